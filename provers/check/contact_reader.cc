#include "provers/check/contact_reader.h"

#include <cstddef>

namespace tact::check {
namespace {

Row PlaneRow(const Row& point, const Row& n) {
  Row row(6);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    row[i] = point[j] * n[k] - point[k] * n[j];
    row[3 + i] = point[3] * n[i];
  }
  return row;
}

}  // namespace

ContactNumbers ReadContact(const Value& contact) {
  ExpectKeys(contact, {"point", "planes"}, {"name"});
  if (const Value* name = Find(contact, "name")) AsString(*name);
  ContactNumbers numbers;
  numbers.point = AsIntegers(At(contact, "point"), 4);
  if (numbers.point[3] <= 0) throw Refused(&At(contact, "point"), "W is not positive");
  const Array& planes = AsArray(At(contact, "planes"));
  if (planes.empty()) throw Refused(&At(contact, "planes"), "no plane");
  for (const Value& plane : planes) {
    numbers.planes.push_back(AsIntegers(plane, 3));
    if (numbers.planes.back() == Row(3)) throw Refused(&plane, "zero normal");
    numbers.rows.push_back(PlaneRow(numbers.point, numbers.planes.back()));
  }
  return numbers;
}

Matrix RightHalf(const Matrix& matrix) {
  Matrix half;
  for (const Row& row : matrix) half.emplace_back(row.begin() + 3, row.end());
  return half;
}

}  // namespace tact::check
