#include "enumerators/dof_class.h"

#include <algorithm>
#include <set>

namespace tact::enumerators {
namespace {

using algebra::MotionDof;

std::vector<DofDefinition> MakeDefinitions() {
  const DofDefinition translation = {
      "translation", {"translation.maintaining", "translation.detaching", "translation.constraining"}};
  const DofDefinition rotation = {"rotation",
                                  {"rotation.maintaining", "rotation.detaching", "rotation.constraining"}};
  const DofDefinition types = {"rotation with types",
                               {"rotation.maintaining", "rotation.detaching_type1",
                                "rotation.detaching_type2", "rotation.constraining"}};
  const DofDefinition all = {"all motion", {"all.maintaining", "all.detaching", "all.constraining"}};
  const auto join = [](std::initializer_list<DofDefinition> parts) {
    DofDefinition joined;
    for (const DofDefinition& part : parts) {
      joined.name += (joined.name.empty() ? "" : ", ") + part.name;
      joined.indices.insert(joined.indices.end(), part.indices.begin(), part.indices.end());
    }
    return joined;
  };
  return {translation,
          rotation,
          types,
          all,
          join({translation, rotation}),
          join({translation, types}),
          join({translation, all}),
          join({rotation, all}),
          join({types, all}),
          join({translation, rotation, all}),
          join({translation, types, all})};
}

// The indices that follow from the others.
MotionDof Complete(int mt, int ct, int mr, int type1, int cr, int ca) {
  MotionDof dof;
  dof.translation = {mt, 3 - mt - ct, ct, 3 - mt};
  dof.rotation = {mr, 3 - mr - cr, type1, 3 - mr - cr - type1, cr, 3 - mr};
  dof.all = {mt + mr, 6 - mt - mr - ca, ca, 6 - mt - mr};
  return dof;
}

}  // namespace

const std::vector<DofDefinition>& DofDefinitions() {
  static const std::vector<DofDefinition> definitions = MakeDefinitions();
  return definitions;
}

std::vector<int> IndexValues(const MotionDof& dof, const DofDefinition& definition) {
  std::vector<int> values;
  for (const std::string& index : definition.indices) values.push_back(IndexValue(dof, index));
  return values;
}

const std::vector<DofLemma>& DofLemmas() {
  static const std::vector<DofLemma> lemmas = {
      {"parallel-normals",
       "Forces of one direction turn about axes square to it only: r_r <= 2 if r_t = 1, "
       "r_r = 0 if r_t = 0.",
       [](const MotionDof& d) {
         return d.rotation.restricted <= (d.translation.restricted == 0   ? 0
                                          : d.translation.restricted == 1 ? 2
                                                                          : 3);
       }},
      {"pointed-normals", "Where no translation is blocked, nothing is: c_t = 0 gives c_a = c_r = d_r2 = 0.",
       [](const MotionDof& d) {
         return d.translation.constraining > 0 ||
                (d.all.constraining == 0 && d.rotation.constraining == 0 && d.rotation.detaching_type2 == 0);
       }},
      {"one-blocked-line",
       "Where translation is blocked along one line, some axis turns both ways: c_t = 1 gives "
       "d_r2 + c_r <= 2.",
       [](const MotionDof& d) {
         return d.translation.constraining != 1 || d.rotation.detaching_type2 + d.rotation.constraining <= 2;
       }},
      {"no-detaching-translation",
       "Where no translation detaches, no axis detaches both ways: d_t = 0 gives d_r1 = 0.",
       [](const MotionDof& d) { return d.translation.detaching > 0 || d.rotation.detaching_type1 == 0; }},
      {"shares",
       "Blocked motion is blocked turning and a share of blocked translation: c_r <= c_a <= c_r + c_t.",
       [](const MotionDof& d) {
         const int forces = d.all.constraining - d.rotation.constraining;
         return 0 <= forces && forces <= d.translation.constraining;
       }},
      {"forces-turn", "Only forces block: c_a > 0 gives c_a > c_r.",
       [](const MotionDof& d) {
         return d.all.constraining == 0 || d.all.constraining > d.rotation.constraining;
       }},
      {"no-one-way-turn",
       "Where no axis turns one way only, blocked translations are blocked motions: d_r2 = 0 gives "
       "c_a = c_r + c_t.",
       [](const MotionDof& d) {
         return d.rotation.detaching_type2 > 0 ||
                d.all.constraining == d.rotation.constraining + d.translation.constraining;
       }},
  };
  return lemmas;
}

const std::vector<DofLemma>& BoxLemmas() {
  static const std::vector<DofLemma> lemmas = {
      {"boxes-one-way",
       "With axis-parallel faces, forces of one detaching direction turn about axes square to it: d_t = 1 "
       "and "
       "d_r2 = c_r = 0 give r_r <= 2.",
       [](const MotionDof& d) {
         return d.translation.detaching != 1 || d.rotation.detaching_type2 + d.rotation.constraining > 0 ||
                d.rotation.restricted <= 2;
       }},
      {"boxes-three-couples",
       "With axis-parallel faces, translation is blocked along the three axes by forces that cancel or turn: "
       "c_t = 3 "
       "and c_a = 0 give d_r2 + c_r >= 2.",
       [](const MotionDof& d) {
         return d.translation.constraining != 3 || d.all.constraining > 0 ||
                d.rotation.detaching_type2 + d.rotation.constraining >= 2;
       }},
  };
  return lemmas;
}

std::vector<MotionDof> DofCandidates() {
  std::vector<MotionDof> candidates;
  for (int mt = 0; mt <= 3; ++mt) {
    for (int ct = 0; mt + ct <= 3; ++ct) {
      for (int mr = 0; mr <= 3; ++mr) {
        for (int type1 = 0; mr + type1 <= 3; ++type1) {
          for (int cr = 0; mr + type1 + cr <= 3; ++cr) {
            for (int ca = 0; mt + mr + ca <= 6; ++ca)
              candidates.push_back(Complete(mt, ct, mr, type1, cr, ca));
          }
        }
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

std::optional<size_t> ExcludingLemma(const MotionDof& candidate) {
  const auto& lemmas = DofLemmas();
  for (size_t i = 0; i < lemmas.size(); ++i) {
    if (!lemmas[i].holds(candidate)) return i;
  }
  return std::nullopt;
}

std::vector<MotionDof> DofClasses() {
  std::vector<MotionDof> classes = DofCandidates();
  std::erase_if(classes, [](const MotionDof& dof) { return ExcludingLemma(dof).has_value(); });
  return classes;
}

std::vector<MotionDof> BoxClasses() {
  std::vector<MotionDof> classes = DofClasses();
  std::erase_if(classes, [](const MotionDof& dof) {
    return std::any_of(BoxLemmas().begin(), BoxLemmas().end(),
                       [&](const DofLemma& lemma) { return !lemma.holds(dof); });
  });
  return classes;
}

std::vector<MotionDof> SingularClasses() {
  std::vector<MotionDof> classes;
  for (MotionDof dof : DofClasses()) {
    dof.singular = true;
    const int translation = dof.translation.restricted, rotation = dof.rotation.restricted;
    for (int rt = std::max(2, translation); rt <= 3; ++rt) {
      for (int rr = rotation; rr <= 3; ++rr) {
        dof.translation.restricted = rt;
        dof.rotation.restricted = rr;
        dof.all.restricted = rt + rr;
        classes.push_back(dof);
      }
    }
  }
  std::sort(classes.begin(), classes.end());
  return classes;
}

size_t CountDistinct(const std::vector<MotionDof>& dofs, const DofDefinition& definition) {
  std::set<std::vector<int>> values;
  for (const MotionDof& dof : dofs) values.insert(IndexValues(dof, definition));
  return values.size();
}

size_t FewestContacts(const MotionDof& dof) {
  return static_cast<size_t>(dof.all.restricted) + (dof.all.constraining > 0 ? 1 : 0);
}

}  // namespace tact::enumerators
