// `knot-tying`: a knot tied from the straight rope by moves that are each checked at both of its P-data.
#include <array>
#include <cstdlib>

#include "provers/check/kinds.h"
#include "provers/check/knot_moves.h"

namespace tact::check {
namespace {

// (c + |u| + |v|) / 2: what no move changes by more than one (docs/certificates.md).
int LeastSteps(const KnotCode& code) {
  std::array<int, 2> signs{};
  for (int i = 1; i <= code.columns(); ++i) {
    if (code.mate(i) > i) signs[code.over(i) ? 0 : 1] += code.plus(i) ? 1 : -1;
  }
  return (code.columns() / 2 + std::abs(signs[0]) + std::abs(signs[1])) / 2;
}

}  // namespace

void CheckKnotTying(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "moves"}, {"at_least"});
  const Array &texts = AsArray(At(certificate, "p_data")), &moves = AsArray(At(certificate, "moves"));
  if (texts.size() != moves.size() + 1) throw Refused(&certificate, "expected one P-data more than moves");
  std::vector<KnotCode> codes;
  for (const Value& text : texts) codes.push_back(ReadCodeOnSphere(text));
  if (codes.front().columns() != 0) throw Refused(&texts.front(), "not the straight rope");
  for (std::size_t k = 0; k < moves.size(); ++k)
    ExpectMoveLeads(moves[k], codes[k], ReadKnotMove(moves[k]), codes[k + 1]);
  if (const Value* least = Find(certificate, "at_least")) {
    if (static_cast<int>(AsIndex(*least, std::size_t{1} << 20)) > LeastSteps(codes.back()))
      throw Refused(least, "fewer steps are not excluded by the signs of the intersections");
  }
}

}  // namespace tact::check
