/// @file
/// A closed diagram in Regina's hands: which Reidemeister moves it admits there, and what they make of it.
/// Model   P-data whose two ends lie on one face is closed by joining them there; crossings and columns keep their order.
///         Regina's + is the thesis' +. A strand is the closed arc that starts at a column; the last one is segment n + 1
///         joined to segment 1. Sides: 0 left, 1 right.
/// Shapes  crossings count from 0 in the order in which they are first met, columns from 1.
/// Licence Regina is GPL: this links with test and benchmark programs only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::benchmarks {

class ReginaKnot {
 public:
  explicit ReginaKnot(const knot::PData& p);
  ReginaKnot(const ReginaKnot& other);
  ~ReginaKnot();

  /// Each: whether the move is possible; done if `perform`.
  bool RemoveR1(int crossing, bool perform);
  /// The crossing at which the upper arc of the lens starts. Regina 7.3 also accepts two arcs, one over the other, that bound no
  /// face, with one sign at both crossings: pulling them apart turns a part of the knot over and is no R2, as Writhe() shows.
  bool RemoveR2(int crossing, bool perform);
  /// The crossing at which the uppermost arc starts, and the triangle's side of it.
  bool ShiftR3(int crossing, int side, bool perform);
  bool AddR1(int column, int side, int sign, bool perform);
  bool AddR2(int upper_column, int upper_side, int lower_column, int lower_side, bool perform);

  /// The same for diagrams that differ in where the reading starts, and for no others: orientation and mirror images count.
  std::string Signature() const;

  /// The sum of the crossings' signs: R2 and R3 keep it.
  int Writhe() const;

  /// Whether a sphere holds some diagram with this Gauss code, signs for over and under.
  static bool IsRealisable(const std::vector<int>& gauss);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The number, from 0, of each column's crossing, at [column - 1].
std::vector<int> CrossingOfColumns(const knot::PData& p);

}  // namespace tact::benchmarks
