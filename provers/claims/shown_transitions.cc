#include "provers/claims/shown_transitions.h"

#include <algorithm>

#include "algebra/contact/dof_pairing.h"
#include "algebra/error.h"

namespace tact::provers {
namespace {

using algebra::DofIndex;
using algebra::DofTransition;

bool Has(const std::vector<DofTransition>& list, const DofTransition& t, bool backwards) {
  const DofTransition forwards = backwards ? DofTransition{t.motion, t.to, t.from} : t;
  return std::ranges::find(list, forwards) != list.end();
}

ShownTransition Find(const DofTransition& t, const std::vector<ShownScene>& scenes) {
  ShownTransition best{t, {}, false, false};
  int best_rank = 0;
  for (size_t i = 0; i < scenes.size(); ++i) {
    for (const bool backwards : {false, true}) {
      const ShownScene& scene = scenes[i];
      if (!Has(scene.by_direction, t, backwards)) continue;
      const bool forced = Has(scene.forced, t, backwards);
      const DofIndex from = backwards ? t.to : t.from, to = backwards ? t.from : t.to;
      const bool made_for_it = scene.given.before == from && scene.given.after == to;
      const int rank = 1 + (forced ? 2 : 0) + (made_for_it ? 1 : 0);
      if (rank <= best_rank) continue;
      best_rank = rank;
      best = {t, i, backwards, forced};
    }
  }
  return best;
}

}  // namespace

std::string Symbol(DofIndex index) {
  static const char* const kSymbols[] = {"M", "D", "C", "SM", "SD", "SC"};
  return kSymbols[static_cast<int>(index)];
}

std::vector<ShownScene> ShowScenes() {
  std::vector<ShownScene> scenes;
  for (DofTransitionScene& given : DofTransitionScenes()) {
    const algebra::PathContacts path = FollowScene(given.scene);
    if (path.event)
      throw InvariantError("\"" + given.story + "\" is no motion of that kind: " + path.event->what);
    const algebra::ContactRelation &a = path.start.relation, &b = path.end.relation;
    const algebra::MotionDof dof_a = ComputeMotionDof(a), dof_b = ComputeMotionDof(b);
    scenes.push_back({std::move(given), a, b, dof_a, dof_b, DofTransitionsByDirection(a, b),
                      ForcedDofTransitions(dof_a, dof_b)});
  }
  return scenes;
}

std::vector<ShownTransition> ShownTransitions(const std::vector<ShownScene>& scenes) {
  std::vector<ShownTransition> shown;
  for (const algebra::Motion motion : {algebra::Motion::kTranslation, algebra::Motion::kRotation}) {
    for (int from = 0; from < algebra::kDofIndices; ++from) {
      for (int to = 0; to < algebra::kDofIndices; ++to) {
        if (from == to) continue;
        shown.push_back(Find({motion, static_cast<DofIndex>(from), static_cast<DofIndex>(to)}, scenes));
      }
    }
  }
  return shown;
}

}  // namespace tact::provers
