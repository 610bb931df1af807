/// @file
/// What was recognized, as JSON and for people.
#pragma once

#include <string>

#include "robot/recognition/recognition.h"

namespace tact::cli {

/// `"relations":[...],"transitions":[...]`, without braces.
std::string ToJsonMembers(const recognition::Recognition& recognition);
/// "edge-face, 2 face-face", "nothing touches".
std::string ContactSummary(const recognition::SeenRelation& relation);
/// The table of relations, and the transitions with the reasons for their sub-skills.
std::string ToText(const recognition::Recognition& recognition);

}  // namespace tact::cli
