/// @file
/// Matrices of steps from one class to another, as SVG.
/// Model   A row is a class before, a column a class after.
/// Shapes  cells.at(row).at(column).
#pragma once

#include <string>
#include <vector>

namespace tact::provers {

struct MatrixCell {
  std::string fill;   // a colour; empty: nothing
  std::string text;   // shown in it
  std::string title;  // shown when pointed at
  std::string link;   // empty: none
  bool ring = false;
};

/// Cells with text, a label before each row and above each column.
std::string DrawMatrix(const std::vector<std::string>& labels,
                       const std::vector<std::vector<MatrixCell>>& cells, double cell_width,
                       const std::string& title);

struct MatrixDot {
  size_t row = 0, column = 0;
  std::string fill, title;
};

/// Classes in a row that have something in common.
struct MatrixGroup {
  std::string label;
  size_t classes = 0;
};

/// Many classes, a dot for each pair that has one, with lines between groups.
std::string DrawDotMatrix(const std::vector<MatrixGroup>& groups, const std::vector<MatrixDot>& dots,
                          const std::string& title);

}  // namespace tact::provers
