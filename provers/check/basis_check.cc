// A basis and its reduced form: the same space, with the translations apart [thesis, Fig. 2.2].
#include <string>

#include "provers/check/exact_rank.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

Matrix ReadIndependent(const Value& list) {
  Matrix matrix;
  for (const Value& vector : AsArray(list)) matrix.push_back(AsIntegers(vector, 6));
  if (matrix.size() > 6 || Rank(matrix) < static_cast<int>(matrix.size())) {
    throw Refused(&list, "linearly dependent");
  }
  return matrix;
}

}  // namespace

void CheckBasis(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"vectors", "reduced", "translations"});
  const Matrix vectors = ReadIndependent(At(certificate, "vectors"));
  const Matrix reduced = ReadIndependent(At(certificate, "reduced"));
  Matrix both = vectors;
  both.insert(both.end(), reduced.begin(), reduced.end());
  if (vectors.size() != reduced.size() || Rank(both) != static_cast<int>(vectors.size())) {
    throw Refused(&At(certificate, "reduced"), "spans another space than the vectors");
  }

  Matrix angular;
  for (const Row& row : reduced) {
    if (row[0] != 0 || row[1] != 0 || row[2] != 0) angular.emplace_back(row.begin(), row.begin() + 3);
  }
  const std::size_t translations = reduced.size() - angular.size();
  const Value& claimed = At(certificate, "translations");
  if (AsInteger(claimed) != translations) {
    throw Refused(&claimed, "the reduced basis has " + std::to_string(translations));
  }
  if (Rank(angular) < static_cast<int>(angular.size())) {
    throw Refused(&At(certificate, "reduced"), "the angular parts that are not zero are linearly dependent");
  }
}

}  // namespace tact::check
