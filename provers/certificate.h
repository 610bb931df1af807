/// @file
/// Certificates: JSON texts that restate a problem in full, in integers, with evidence (docs/certificates.md).
#pragma once

#include <string>

namespace tact::provers {

/// One certificate: the stem of its file name below certificates/, and its JSON text.
struct Certificate {
  std::string name;
  std::string json;
};

}  // namespace tact::provers
