// `knot-parts`: P-data that no sphere holds though each of its irreducible parts is one of a sphere [thesis, 5.1.3].
#include <algorithm>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/knot_graph.h"

namespace tact::check {
namespace {

// The columns alone, numbered from 1; refuses those whose mates are not among them.
KnotCode Restrict(const KnotCode& code, const std::vector<int>& columns, const Value& where) {
  KnotCode part;
  for (const int i : columns) {
    const auto mate = std::lower_bound(columns.begin(), columns.end(), code.mate(i));
    if (mate == columns.end() || *mate != code.mate(i)) throw Refused(&where, "a column's mate is missing");
    part.sigma.push_back(static_cast<int>(mate - columns.begin()) + 1);
    part.attr.push_back(code.attribute(i));
  }
  return part;
}

}  // namespace

void CheckKnotParts(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "parts"});
  const Value& text = At(certificate, "p_data");
  const KnotCode code = ReadKnotCode(text);
  if (code.columns() > kMostGraphColumns) throw Refused(&text, "more columns than this checker tries");
  if (OnSphere(code)) throw Refused(&text, "a sphere holds this diagram");
  const Value& parts = At(certificate, "parts");
  // The part of each column, from 1.
  std::vector<int> part_of(static_cast<std::size_t>(code.columns()) + 1, 0);
  int count = 0;
  for (const Value& value : AsArray(parts)) {
    ++count;
    std::vector<int> columns;
    for (const Value& number : AsArray(value)) {
      const int i = static_cast<int>(AsIndex(number, part_of.size()));
      if (i == 0 || part_of[static_cast<std::size_t>(i)] != 0 || (!columns.empty() && i < columns.back()))
        throw Refused(&number, "columns count from 1, ascend in a part and are in one part each");
      part_of[static_cast<std::size_t>(i)] = count;
      columns.push_back(i);
    }
    const KnotCode part = Restrict(code, columns, value);
    if (columns.empty() || !IsIrreducible(part)) throw Refused(&value, "this part is empty or reducible");
    if (!OnSphere(part)) throw Refused(&value, "no sphere holds this part");
  }
  if (std::count(part_of.begin() + 1, part_of.end(), 0) > 0) throw Refused(&parts, "a column is in no part");
  for (int i = 1; i <= code.columns(); ++i) {
    for (int a = i + 1; a < code.mate(i); ++a) {
      if (code.mate(a) < code.mate(i) ||
          part_of[static_cast<std::size_t>(i)] == part_of[static_cast<std::size_t>(a)])
        continue;
      throw Refused(&parts, "columns " + std::to_string(i) + " and " + std::to_string(a) +
                                " alternate with their mates and are in different parts");
    }
  }
}

}  // namespace tact::check
