#include "robot/input/rotation_quaternion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tact::input {
namespace {

using Row = std::array<double, 3>;

double Dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double Determinant(const RotationRows& m) {
  const Row cross{m[0][1] * m[1][2] - m[0][2] * m[1][1], m[0][2] * m[1][0] - m[0][0] * m[1][2],
                  m[0][0] * m[1][1] - m[0][1] * m[1][0]};
  return Dot(cross, m[2]);
}

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::optional<std::string> RotationFault(const RotationRows& rows, double allowed) {
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double product = Dot(rows[i], rows[j]), wanted = i == j ? 1 : 0;
      if (std::abs(product - wanted) <= allowed) continue;
      if (i == j) return "row " + std::to_string(i + 1) + " times itself is " + Short(product) + ", not 1";
      return "rows " + std::to_string(i + 1) + " and " + std::to_string(j + 1) + " have the product " +
             Short(product) + ", not 0";
    }
  }
  if (Determinant(rows) < 0) return "the determinant is -1 (a mirror image)";
  return std::nullopt;
}

std::array<double, 4> QuaternionOf(const RotationRows& m) {
  const double trace = m[0][0] + m[1][1] + m[2][2];
  int largest = 0;
  for (int i = 1; i < 3; ++i) {
    if (m[i][i] > m[largest][largest]) largest = i;
  }
  // Four times the square of the largest entry and its products with the others: all scaled by four times that entry.
  if (trace >= m[largest][largest])
    return {1 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
  const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  std::array<double, 4> q{};
  q[0] = m[k][j] - m[j][k];
  q[1 + i] = 1 + m[i][i] - m[j][j] - m[k][k];
  q[1 + j] = m[j][i] + m[i][j];
  q[1 + k] = m[k][i] + m[i][k];
  return q;
}

double NormaliseQuaternion(std::array<double, 4>* q) {
  double largest = 0;
  for (const double entry : *q) largest = std::max(largest, std::abs(entry));
  if (largest == 0) return 0;
  // Scaled first, so that no square overflows or vanishes.
  double squares = 0;
  for (double& entry : *q) {
    entry /= largest;
    squares += entry * entry;
  }
  for (double& entry : *q) entry /= std::sqrt(squares);
  return largest * std::sqrt(squares);
}

}  // namespace tact::input
