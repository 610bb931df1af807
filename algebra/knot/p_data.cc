#include "algebra/knot/p_data.h"

#include <algorithm>

#include "algebra/error.h"

namespace tact::knot {
namespace {

std::string Text(int number) { return std::to_string(number); }

std::string RowText(const std::vector<int>& row) {
  std::string text;
  for (const int n : row) text += (text.empty() ? "" : ",") + Text(n);
  return "[" + text + "]";
}

// p with every attribute replaced by map[attribute - 1].
PData WithAttributes(const PData& p, const int (&map)[4]) {
  PDataBuilder mapped(p.columns());
  for (int i = 1; i <= p.columns(); ++i) mapped.Add(p.sigma(i), map[p.attr(i) - 1]);
  return mapped.Take();
}

}  // namespace

std::optional<PDataFault> PData::FindFault(const std::vector<int>& sigma, const std::vector<int>& attr) {
  if (sigma.size() != attr.size()) {
    return PDataFault{0, "expected as many attributes as mates, got " + std::to_string(attr.size()) +
                             " and " + std::to_string(sigma.size())};
  }
  if (sigma.size() % 2 != 0) {
    return PDataFault{0, "expected two columns for each intersection, got " + std::to_string(sigma.size())};
  }
  const int n = static_cast<int>(sigma.size());
  for (int i = 1; i <= n; ++i) {
    const auto at = [](const std::vector<int>& row, int column) {
      return row[static_cast<size_t>(column) - 1];
    };
    const int mate = at(sigma, i), kind = at(attr, i);
    const std::string mated = "sigma(" + Text(i) + ") = " + Text(mate);
    if (mate < 1 || mate > n) return PDataFault{i, "expected a mate from 1 to " + Text(n) + ", got " + mated};
    if (mate == i) return PDataFault{i, "expected another column as mate, got " + mated};
    if (at(sigma, mate) != i) {
      return PDataFault{i, "expected sigma(" + Text(mate) + ") = " + Text(i) + " since " + mated + ", got " +
                               Text(at(sigma, mate))};
    }
    if (kind < 1 || kind > 4) {
      return PDataFault{i, "expected an attribute from 1 to 4, got attr(" + Text(i) + ") = " + Text(kind)};
    }
    const int other = at(attr, mate);
    if (mate < i && MateAttribute(kind) != other) {
      const bool heights = (kind & 1) == (other & 1);
      return PDataFault{
          i, "expected " +
                 std::string(heights ? "one strand over and one under" : "one sign on both strands") +
                 " at the intersection of columns " + Text(mate) + " and " + Text(i) + ", got attributes " +
                 Text(other) + " and " + Text(kind)};
    }
  }
  return std::nullopt;
}

PData::PData(const std::vector<int>& sigma, const std::vector<int>& attr) {
  if (const auto fault = FindFault(sigma, attr)) throw PreconditionError("PData: " + fault->what);
  PDataBuilder rows(static_cast<int>(sigma.size()));
  for (size_t i = 0; i < sigma.size(); ++i) rows.Add(sigma[i], attr[i]);
  *this = rows.Take();
}

std::vector<int> PData::SigmaRow() const {
  std::vector<int> row;
  for (int i = 1; i <= columns(); ++i) row.push_back(sigma(i));
  return row;
}

std::vector<int> PData::AttrRow() const {
  std::vector<int> row;
  for (int i = 1; i <= columns(); ++i) row.push_back(attr(i));
  return row;
}

std::string PData::ToJson() const {
  return "{\"sigma\":" + RowText(SigmaRow()) + ",\"attr\":" + RowText(AttrRow()) + "}";
}

std::strong_ordering operator<=>(const PData& a, const PData& b) {
  if (const auto order = a.columns_.size() <=> b.columns_.size(); order != 0) return order;
  return a.columns_ <=> b.columns_;
}

PData EquivalentPData(const PData& p) {
  const int n = p.columns();
  PDataBuilder reversed(n);
  for (int i = n; i >= 1; --i) reversed.Add(n - p.sigma(i) + 1, p.attr(i));
  return reversed.Take();
}

PData MirrorShape(const PData& p) { return WithAttributes(p, {3, 4, 1, 2}); }

PData MirrorHeights(const PData& p) { return WithAttributes(p, {4, 3, 2, 1}); }

PData CanonicalPData(const PData& p) { return std::min(p, EquivalentPData(p)); }

}  // namespace tact::knot
