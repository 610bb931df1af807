/// @file
/// The DOF classes of a census for people, as JSON and as CSV.
/// JSON    {"definitions":[{"indices":[names],"classes":N,"complete":true,"upper_bound":N,"name":...,"list":[{"values":[...],
///         "count":N,"witness":{"contacts":[...]}}]}],"world":{"name","sentence","contacts","largest"},"relations":N};
///         `classes` have a witness, `upper_bound` is what the lemmas allow.
/// CSV     a line a class of the finest definition: its indices, relations, contacts of the witness, the witness.
#pragma once

#include <string>
#include <vector>

#include "enumerators/dof_class_list.h"

namespace tact::cli {

struct DofClassAnswer {
  std::string world;  // its name
  const enumerators::DofCensus& census;
  std::vector<enumerators::DofClassList> lists;
};

std::string ToTable(const DofClassAnswer& answer);
std::string ToJson(const DofClassAnswer& answer);
std::string ToCsv(const DofClassAnswer& answer);

}  // namespace tact::cli
