// A relation's motion DOFs from its evidence (docs/certificates.md, "Relations and their evidence").
#include <cstddef>
#include <string>

#include "provers/check/contact_reader.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

struct Rows {
  Matrix single;  // A: the rows of the contacts with one plane
  Matrix planes;  // A': those of every plane of every contact
  bool singular = false;
};

Rows ReadRows(const Value& contacts) {
  Rows rows;
  for (const Value& contact : AsArray(contacts)) {
    const Matrix own = ReadContact(contact).rows;
    rows.planes.insert(rows.planes.end(), own.begin(), own.end());
    if (own.size() == 1) rows.single.push_back(own[0]);
    if (own.size() > 1) rows.singular = true;
  }
  return rows;
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

  const MotionNumbers dof =
      FromRanks({rows.singular, Rank(a), Rank(n), Rank(Select(a, in_all)), Rank(Select(n, in_all)),
                 Rank(Select(a, in_translation)), Rank(Select(n, in_translation)), Rank(rows.planes),
                 Rank(RightHalf(rows.planes))});
  ExpectNumbers(At(relation, "dof"), dof);
  return dof;
}

void CheckMotionDofs(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"relation"}, {"asserts"});
  const MotionNumbers dof = CheckRelation(At(certificate, "relation"));
  if (const Value* asserts = Find(certificate, "asserts")) CheckAsserts(*asserts, dof);
}

}  // namespace tact::check
