// A relation's motion DOFs from its evidence: the formulas of docs/certificates.md, "Relations and their
// evidence".
#include <cstddef>
#include <string>

#include "provers/check/exact_rank.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

struct Rows {
  Matrix single;  // A: the rows of the contacts with one plane
  Matrix planes;  // A': those of every plane of every contact
  bool singular = false;
};

// [ (X,Y,Z) x n | W n ]
Row PlaneRow(const std::vector<mpz_class>& point, const Value& plane) {
  const std::vector<mpz_class> n = AsIntegers(plane, 3);
  if (n[0] == 0 && n[1] == 0 && n[2] == 0) throw Refused(&plane, "zero normal");
  Row row(6);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    row[i] = point[j] * n[k] - point[k] * n[j];
    row[3 + i] = point[3] * n[i];
  }
  return row;
}

Rows ReadRows(const Value& contacts) {
  Rows rows;
  for (const Value& contact : AsArray(contacts)) {
    ExpectKeys(contact, {"point", "planes"}, {"name"});
    if (const Value* name = Find(contact, "name")) AsString(*name);
    const std::vector<mpz_class> point = AsIntegers(At(contact, "point"), 4);
    if (point[3] <= 0) throw Refused(&At(contact, "point"), "W is not positive");
    const Array& planes = AsArray(At(contact, "planes"));
    if (planes.empty()) throw Refused(&At(contact, "planes"), "no plane");
    for (const Value& plane : planes) rows.planes.push_back(PlaneRow(point, plane));
    if (planes.size() == 1) rows.single.push_back(rows.planes.back());
    if (planes.size() > 1) rows.singular = true;
  }
  return rows;
}

Matrix RightHalf(const Matrix& matrix) {
  Matrix half;
  for (const Row& row : matrix) half.emplace_back(row.begin() + 3, row.end());
  return half;
}

Matrix Select(const Matrix& matrix, const std::vector<std::size_t>& rows) {
  Matrix selected;
  for (std::size_t row : rows) selected.push_back(matrix[row]);
  return selected;
}

// The implicit equalities of { z | B z >= 0 } from its strictly complementary pair, which is checked.
std::vector<std::size_t> ImplicitEqualities(const Value& pair, const Matrix& b, std::size_t width) {
  ExpectKeys(pair, {"x", "y"});
  const Row x = AsIntegers(At(pair, "x"), width);
  const Row y = AsIntegers(At(pair, "y"), b.size());
  std::vector<std::size_t> equalities;
  Row combination(width);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const std::string row = "row " + std::to_string(i) + ": ";
    mpz_class product = 0;
    for (std::size_t j = 0; j < width; ++j) {
      product += b[i][j] * x[j];
      combination[j] += y[i] * b[i][j];
    }
    if (product < 0) throw Refused(&pair, row + "B x is negative");
    if (y[i] < 0) throw Refused(&pair, row + "y is negative");
    if (product > 0 && y[i] > 0) throw Refused(&pair, row + "both B x and y are positive");
    if (product == 0 && y[i] == 0) throw Refused(&pair, row + "neither B x nor y is positive");
    if (y[i] > 0) equalities.push_back(i);
  }
  for (std::size_t j = 0; j < width; ++j) {
    if (combination[j] != 0) throw Refused(&pair, "entry " + std::to_string(j) + " of y^T B is not zero");
  }
  return equalities;
}

}  // namespace

MotionNumbers CheckRelation(const Value& relation) {
  ExpectKeys(relation, {"contacts", "all", "translation", "dof"});
  const Rows rows = ReadRows(At(relation, "contacts"));
  const Matrix& a = rows.single;
  const Matrix n = RightHalf(a);
  const auto in_all = ImplicitEqualities(At(relation, "all"), a, 6);
  const auto in_translation = ImplicitEqualities(At(relation, "translation"), n, 3);

  MotionNumbers dof;
  dof.singular = rows.singular;
  dof["all.maintaining"] = 6 - Rank(a);
  dof["all.constraining"] = Rank(Select(a, in_all));
  dof["all.detaching"] = 6 - dof["all.maintaining"] - dof["all.constraining"];
  dof["translation.maintaining"] = 3 - Rank(n);
  dof["translation.constraining"] = Rank(Select(n, in_translation));
  dof["translation.detaching"] = 3 - dof["translation.maintaining"] - dof["translation.constraining"];
  dof["rotation.maintaining"] = dof["all.maintaining"] - dof["translation.maintaining"];
  dof["rotation.constraining"] = dof["all.constraining"] - Rank(Select(n, in_all));
  dof["rotation.detaching"] = 3 - dof["rotation.maintaining"] - dof["rotation.constraining"];
  dof["rotation.detaching_type1"] =
      3 - (Rank(Select(a, in_translation)) - dof["translation.constraining"]) - dof["rotation.maintaining"];
  dof["rotation.detaching_type2"] = dof["rotation.detaching"] - dof["rotation.detaching_type1"];
  dof["all.restricted"] = Rank(rows.planes);
  dof["translation.restricted"] = Rank(RightHalf(rows.planes));
  dof["rotation.restricted"] = dof["all.restricted"] - dof["translation.restricted"];
  ExpectNumbers(At(relation, "dof"), dof);
  return dof;
}

void CheckMotionDofs(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"relation"}, {"asserts"});
  const MotionNumbers dof = CheckRelation(At(certificate, "relation"));
  if (const Value* asserts = Find(certificate, "asserts")) CheckAsserts(*asserts, dof);
}

}  // namespace tact::check
