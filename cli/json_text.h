/// @file
/// Exact values as JSON text: numbers where a decimal of 15 digits says it all, strings "p/q" where not.
#pragma once

#include <string>

#include "algebra/contact/contact_relation.h"
#include "algebra/contact/dof_transition.h"
#include "algebra/contact/motion_dof.h"

namespace tact::cli {

/// The text with what JSON escapes escaped, in quotes.
std::string JsonString(const std::string& text);
std::string ToJson(const algebra::Rational& value);
std::string ToJson(const algebra::Vector3& vector);
/// A contact as in a contact relation file.
std::string ToJson(const algebra::Contact& contact);
/// `[{"point":...,"planes":...,"name":...},...]`.
std::string ContactsToJson(const algebra::ContactRelation& relation);
/// The object of `tact dof --json`, without a line's end.
std::string ToJson(const algebra::MotionDof& dof);
std::string ToJson(const algebra::DofTransition& transition);

}  // namespace tact::cli
