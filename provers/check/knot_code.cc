#include "provers/check/knot_code.h"

#include <algorithm>
#include <numeric>

namespace tact::check {
namespace {

constexpr std::size_t kMostColumns = 200000;

int Root(std::vector<int>& parent, int a) {
  while (parent[static_cast<std::size_t>(a)] != a) {
    int& up = parent[static_cast<std::size_t>(a)];
    up = parent[static_cast<std::size_t>(up)];
    a = up;
  }
  return a;
}

}  // namespace

KnotCode ReadKnotCode(const Value& value) {
  ExpectKeys(value, {"sigma", "attr"});
  const Array& sigma = AsArray(At(value, "sigma"));
  const Array& attr = AsArray(At(value, "attr"));
  if (sigma.size() != attr.size() || sigma.size() % 2 != 0 || sigma.size() > kMostColumns)
    throw Refused(&value, "sigma and attr are not rows of one even length");
  KnotCode code;
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    code.sigma.push_back(static_cast<int>(AsIndex(sigma[i], sigma.size() + 1)));
    code.attr.push_back(static_cast<int>(AsIndex(attr[i], 5)));
  }
  for (int i = 1; i <= code.columns(); ++i) {
    const auto at = static_cast<std::size_t>(i) - 1;
    const int mate = code.mate(i);
    if (mate == 0 || mate == i || code.mate(mate) != i) throw Refused(&sigma[at], "columns are not paired");
    if (code.attribute(i) == 0) throw Refused(&attr[at], "an attribute is 1, 2, 3 or 4");
    if (code.over(i) == code.over(mate)) throw Refused(&attr[at], "both strands at one height");
    if (code.plus(i) != code.plus(mate)) throw Refused(&attr[at], "two signs at one intersection");
  }
  return code;
}

KnotCode ReadCodeOnSphere(const Value& value) {
  KnotCode code = ReadKnotCode(value);
  if (!OnSphere(code)) throw Refused(&value, "no sphere holds this diagram");
  return code;
}

std::vector<int> FacesOfCorners(const KnotCode& code) {
  const int n = code.columns();
  std::vector<int> parent(4 * static_cast<std::size_t>(n));
  std::iota(parent.begin(), parent.end(), 0);
  const auto join = [&](int a, int b) {
    parent[static_cast<std::size_t>(Root(parent, a))] = Root(parent, b);
  };
  const auto corner = [](int column, int q) { return 4 * (column - 1) + q; };
  for (int i = 1; i <= n; ++i) {
    const int j = code.mate(i);
    if (code.turns_left(i)) {  // the mate heads to the left: its ahead is this one's left
      join(corner(j, 0), corner(i, 2));
      join(corner(j, 1), corner(i, 0));
      join(corner(j, 2), corner(i, 3));
      join(corner(j, 3), corner(i, 1));
    }
    if (i < n) {
      join(corner(i, 0), corner(i + 1, 2));
      join(corner(i, 1), corner(i + 1, 3));
    }
  }
  if (n > 0) {
    join(corner(1, 2), corner(1, 3));
    join(corner(n, 0), corner(n, 1));
  }
  std::vector<int> number(parent.size(), -1), face(parent.size());
  int faces = 0;
  for (std::size_t c = 0; c < parent.size(); ++c) {
    int& named = number[static_cast<std::size_t>(Root(parent, static_cast<int>(c)))];
    if (named < 0) named = faces++;
    face[c] = named;
  }
  return face;
}

int CountFaces(const KnotCode& code) {
  if (code.columns() == 0) return 1;
  const std::vector<int> face = FacesOfCorners(code);
  return 1 + *std::max_element(face.begin(), face.end());
}

bool OnSphere(const KnotCode& code) { return CountFaces(code) == code.columns() / 2 + 1; }

}  // namespace tact::check
