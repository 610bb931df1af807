#include "algebra/contact/motion_dof.h"

#include <algorithm>
#include <string>

#include "algebra/cone/dual_simplex.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"

namespace tact::algebra {
namespace {

// The ranks that every motion DOF follows from (motion_dof.h).
struct Ranks {
  int all = 0, force = 0;                    // A, N
  int all_fixed = 0, force_all_fixed = 0;    // A(I_a), N(I_a)
  int force_fixed = 0, all_force_fixed = 0;  // N(I_t), A(I_t)
};

// One run of the method over numbers of type T, with its memory.
template <typename T>
class Method {
 public:
  using Simplex = DualSimplex<T>;

  // False on overflow. rows: six numbers each; single: which rows count for the cone.
  bool Run(const std::vector<T>& rows, const std::vector<char>& single, bool singular, Ranks& cone,
           Ranks& restricted) {
    if (!singular) {
      if (!ConeRanks(rows.data(), rows.size() / 6, cone)) return false;
      restricted = cone;
      return true;
    }
    selected_.clear();
    for (size_t i = 0; i < single.size(); ++i) {
      if (single[i] == 0) continue;
      for (size_t j = 6 * i; j < 6 * i + 6; ++j) selected_.push_back(rows[j]);
    }
    return ConeRanks(selected_.data(), selected_.size() / 6, cone) &&
           RankOf(rows.data(), rows.size() / 6, 6, nullptr, restricted.all) &&
           RankOf(rows.data() + 3, rows.size() / 6, 3, nullptr, restricted.force);
  }

  bool ConeRanks(const T* rows, size_t count, Ranks& ranks) {
    const T* forces = count == 0 ? rows : rows + 3;  // without rows there is no array to point into
    if (translation_.Solve(forces, count, 3, 6) != Simplex::Status::kDone) return false;
    if (all_.Solve(rows, count, 6, 6) != Simplex::Status::kDone) return false;
    ranks.force = translation_.rank();
    ranks.all = all_.rank();
    ranks.force_fixed = translation_.vanishing_rank();
    ranks.all_fixed = all_.vanishing_rank();
    ranks.force_all_fixed = 0;
    ranks.all_force_fixed = 0;
    // Nothing fixed: nothing to take the rank of. Everything fixed in translation: all rows.
    if (ranks.all_fixed > 0 && !RankOf(forces, count, 3, &all_.vanishing(), ranks.force_all_fixed))
      return false;
    return ranks.force_fixed == 0 || RankOf(rows, count, 6, &translation_.vanishing(), ranks.all_force_fixed);
  }

 private:
  bool RankOf(const T* rows, size_t count, int columns, const std::vector<char>* flags, int& rank) {
    const bool done = rank_.Rank(rows, count, columns, 6, flags) == Simplex::Status::kDone;
    rank = rank_.rank();
    return done;
  }

  Simplex all_, translation_, rank_;
  std::vector<T> selected_;
};

struct NamedIndex {
  const char* name;
  int (*value)(const MotionDof& dof);
};

constexpr NamedIndex kIndices[] = {
    {"translation.maintaining", [](const MotionDof& d) { return d.translation.maintaining; }},
    {"translation.detaching", [](const MotionDof& d) { return d.translation.detaching; }},
    {"translation.constraining", [](const MotionDof& d) { return d.translation.constraining; }},
    {"translation.restricted", [](const MotionDof& d) { return d.translation.restricted; }},
    {"rotation.maintaining", [](const MotionDof& d) { return d.rotation.maintaining; }},
    {"rotation.detaching", [](const MotionDof& d) { return d.rotation.detaching; }},
    {"rotation.detaching_type1", [](const MotionDof& d) { return d.rotation.detaching_type1; }},
    {"rotation.detaching_type2", [](const MotionDof& d) { return d.rotation.detaching_type2; }},
    {"rotation.constraining", [](const MotionDof& d) { return d.rotation.constraining; }},
    {"rotation.restricted", [](const MotionDof& d) { return d.rotation.restricted; }},
    {"all.maintaining", [](const MotionDof& d) { return d.all.maintaining; }},
    {"all.detaching", [](const MotionDof& d) { return d.all.detaching; }},
    {"all.constraining", [](const MotionDof& d) { return d.all.constraining; }},
    {"all.restricted", [](const MotionDof& d) { return d.all.restricted; }},
};

void RequireRows(std::span<const int64_t> rows) {
  constexpr int64_t kLimit = int64_t{1} << 60;
  if (rows.size() % 6 != 0)
    throw PreconditionError("rows of six numbers each, but got " + std::to_string(rows.size()));
  for (size_t i = 0; i < rows.size(); i += 6) {
    const auto row = rows.subspan(i, 6);
    if (row[3] == 0 && row[4] == 0 && row[5] == 0)
      throw PreconditionError("row " + std::to_string(i / 6) + " has a zero normal");
    if (std::any_of(row.begin(), row.end(), [](int64_t x) { return x >= kLimit || x <= -kLimit; }))
      throw PreconditionError("row " + std::to_string(i / 6) + " has an entry beyond 2^60");
  }
}

MotionDof FromRanks(const Ranks& cone, const Ranks& restricted, bool singular) {
  MotionDof dof;
  dof.singular = singular;
  dof.translation.maintaining = 3 - cone.force;
  dof.translation.constraining = cone.force_fixed;
  dof.translation.detaching = cone.force - cone.force_fixed;
  dof.translation.restricted = restricted.force;
  dof.all.maintaining = 6 - cone.all;
  dof.all.constraining = cone.all_fixed;
  dof.all.detaching = cone.all - cone.all_fixed;
  dof.all.restricted = restricted.all;
  dof.rotation.maintaining = dof.all.maintaining - dof.translation.maintaining;
  dof.rotation.constraining = cone.all_fixed - cone.force_all_fixed;
  dof.rotation.detaching = 3 - dof.rotation.maintaining - dof.rotation.constraining;
  dof.rotation.detaching_type1 = 3 - (cone.all_force_fixed - cone.force_fixed) - dof.rotation.maintaining;
  dof.rotation.detaching_type2 = dof.rotation.detaching - dof.rotation.detaching_type1;
  dof.rotation.restricted = restricted.all - restricted.force;
  return dof;
}

}  // namespace

struct MotionDofEngine::Memory {
  ContactRows rows;
  Method<int64_t> small;
  Method<Integer> large;
  size_t overflows = 0;
};

MotionDofEngine::MotionDofEngine() : memory_(std::make_unique<Memory>()) {}
MotionDofEngine::~MotionDofEngine() = default;
size_t MotionDofEngine::overflows() const { return memory_->overflows; }

MotionDof MotionDofEngine::Compute(const ContactRelation& relation) {
  Memory& m = *memory_;
  m.rows.Assign(relation);
  Ranks cone, restricted;
  if (!m.rows.is_small() ||
      !m.small.Run(m.rows.small(), m.rows.single(), m.rows.singular(), cone, restricted)) {
    ++m.overflows;
    m.large.Run(m.rows.ToIntegers(), m.rows.single(), m.rows.singular(), cone, restricted);
  }
  return FromRanks(cone, restricted, m.rows.singular());
}

MotionDof MotionDofEngine::Compute(std::span<const int64_t> rows) {
  Memory& m = *memory_;
  RequireRows(rows);
  Ranks ranks;
  if (!m.small.ConeRanks(rows.data(), rows.size() / 6, ranks)) {
    ++m.overflows;
    const std::vector<Integer> large(rows.begin(), rows.end());
    m.large.ConeRanks(large.data(), large.size() / 6, ranks);
  }
  return FromRanks(ranks, ranks, false);
}

int IndexValue(const MotionDof& dof, std::string_view index) {
  const auto found = std::find_if(std::begin(kIndices), std::end(kIndices),
                                  [&](const NamedIndex& named) { return index == named.name; });
  if (found == std::end(kIndices)) throw PreconditionError("no DOF index is named " + std::string(index));
  return found->value(dof);
}

MotionDof ComputeMotionDof(const ContactRelation& relation) {
  thread_local MotionDofEngine engine;
  return engine.Compute(relation);
}

}  // namespace tact::algebra
