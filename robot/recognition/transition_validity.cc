#include "robot/recognition/transition_validity.h"

#include <algorithm>

namespace tact::recognition {
namespace {

bool Includes(const std::vector<PointContact>& all, const std::vector<PointContact>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

}  // namespace

TransitionValidity ValidityOf(const RelationSeen& from, const RelationSeen& to) {
  return {Includes(from.contacts, to.contacts) || Includes(to.contacts, from.contacts),
          AnalyzeTransition(from.dof, to.dof).practical};
}

std::string ToString(const TransitionValidity& validity) {
  std::string text;
  if (!validity.included) text = "neither relation includes the other";
  if (!validity.practical) text += (text.empty() ? "" : "; ") + std::string("no practical DOF-transition");
  return text;
}

}  // namespace tact::recognition
