/// @file
/// Motion degrees of freedom of a contact relation [thesis, 2.2, 2.6].
/// Model   With rows a_i = [ p_i x n_i | n_i ], K = { V = [w ; v] | A V >= 0 }, I_a its implicit equalities,
///         T = { v | N v >= 0 } the legal translations, I_t their implicit equalities, and rank(I) the rank
///         of the rows in I:
///           m_a = 6 - rank A,  c_a = rank A(I_a),  d_a = 6 - m_a - c_a                    [eq. (2.4)]
///           m_t = 3 - rank N,  c_t = rank N(I_t),  d_t = 3 - m_t - c_t                    [eq. (2.3)]
///           m_r = m_a - m_t,   c_r = rank A(I_a) - rank N(I_a),  d_r = 3 - m_r - c_r      [Prop. 1-3]
///           d_r1 = 3 - (rank A(I_t) - rank N(I_t)) - m_r,  d_r2 = d_r - d_r1              [Prop. 4-6]
///         The last but one: the lineality space of the projection of K to w is the projection of the
///         smallest face of K that holds every legal translation, and that face is { A(I_t) V = 0 }.
/// Exact   integer arithmetic throughout, 64-bit with overflow detection, GMP on overflow.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "algebra/contact/contact_relation.h"

namespace tact::algebra {

struct TranslationDof {
  int maintaining = 0, detaching = 0, constraining = 0, restricted = 0;
  friend auto operator<=>(const TranslationDof&, const TranslationDof&) = default;
};

struct RotationDof {
  int maintaining = 0, detaching = 0, detaching_type1 = 0, detaching_type2 = 0, constraining = 0,
      restricted = 0;
  friend auto operator<=>(const RotationDof&, const RotationDof&) = default;
};

/// If singular, the three kinds are the thesis' singular DOFs (of the relation without its singular
/// contacts, eq. (2.8)); the restricted DOFs count every plane of every contact.
struct MotionDof {
  bool singular = false;
  TranslationDof translation;
  RotationDof rotation;
  TranslationDof all;
  friend auto operator<=>(const MotionDof&, const MotionDof&) = default;
};

/// The index of that name, "translation.maintaining", "rotation.detaching_type1", "all.restricted" and so on.
/// PreconditionError: no such index.
int IndexValue(const MotionDof& dof, std::string_view index);

/// PreconditionError: a zero normal, or a contact without planes.
MotionDof ComputeMotionDof(const ContactRelation& relation);

/// The same with memory that is kept from call to call: once warm, a relation whose numbers stay in 64 bits
/// costs no allocation. One instance per thread.
class MotionDofEngine {
 public:
  MotionDofEngine();
  ~MotionDofEngine();
  MotionDofEngine(const MotionDofEngine&) = delete;
  MotionDofEngine& operator=(const MotionDofEngine&) = delete;

  MotionDof Compute(const ContactRelation& relation);
  /// Of a non-singular relation given by its rows [ p x n | n ], six numbers each (contact_rows.h).
  /// PreconditionError: not a multiple of six numbers, a zero normal, entries of 2^60 or more.
  MotionDof Compute(std::span<const int64_t> rows);
  /// How many calls so far had to leave 64 bits for GMP.
  size_t overflows() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace tact::algebra
