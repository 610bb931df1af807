// `knot-embedding`: a drawing of a knot graph on a sphere that is neither that of its P-data nor its mirror image
// [thesis, 5.1.3, Proposition 9].
#include <algorithm>
#include <cstdlib>
#include <map>

#include "provers/check/kinds.h"
#include "provers/check/knot_graph.h"

namespace tact::check {
namespace {

// Round each vertex, counterclockwise, the darts that leave it: +k from column k along e_k, -k from column k + 1 back.
using Rotation = std::vector<std::vector<int>>;

Rotation OwnRotation(const KnotCode& code) {
  Rotation rotation;
  for (int i = 1; i <= code.columns(); ++i) {
    const int j = code.mate(i);
    if (j < i) continue;
    std::vector<int> order;
    const int ahead = j == code.columns() ? 0 : j, behind = 1 - j;
    order.push_back(i);
    order.push_back(code.turns_left(i) ? ahead : behind);
    order.push_back(1 - i);
    order.push_back(code.turns_left(i) ? behind : ahead);
    std::erase(order, 0);
    rotation.push_back(order);
  }
  return rotation;
}

Rotation ReadRotation(const Value& value, const Rotation& own) {
  const Array& vertices = AsArray(value);
  if (vertices.size() != own.size()) throw Refused(&value, "expected an order for each intersection");
  Rotation rotation;
  for (std::size_t v = 0; v < own.size(); ++v) {
    std::vector<int> order;
    for (const mpz_class& dart : AsIntegers(vertices[v], own[v].size())) {
      if (!dart.fits_sint_p()) throw Refused(&vertices[v], "no edge has this number");
      order.push_back(static_cast<int>(dart.get_si()));
    }
    if (!std::is_permutation(order.begin(), order.end(), own[v].begin()))
      throw Refused(&vertices[v], "other edges leave this intersection");
    rotation.push_back(order);
  }
  return rotation;
}

using Next = std::map<int, int>;

Next After(const Rotation& rotation) {
  Next after;
  for (const auto& order : rotation) {
    for (std::size_t i = 0; i < order.size(); ++i) after[order[i]] = order[(i + 1) % order.size()];
  }
  return after;
}

Next Before(const Rotation& rotation) {
  Next before;
  for (const auto& [dart, next] : After(rotation)) before[next] = dart;
  return before;
}

bool IsOnSphere(const Rotation& rotation) {
  const Next before = Before(rotation);
  std::map<int, bool> seen;
  long faces = 0;
  for (const auto& [first, ignored] : before) {
    if (seen[first]) continue;
    ++faces;
    for (int dart = first; !seen[dart]; dart = before.at(-dart)) seen[dart] = true;
  }
  const long edges = static_cast<long>(before.size() / 2), vertices = static_cast<long>(rotation.size());
  return vertices - edges + faces == 2;
}

// Whether the drawing with `after` becomes the other, names aside, when `from` goes to `to`: the rest follows.
bool Carries(const Next& after, int from, const Next& other, int to) {
  std::map<int, int> image = {{from, to}};
  std::vector<int> waiting = {from};
  while (!waiting.empty()) {
    const int dart = waiting.back();
    waiting.pop_back();
    const std::pair<int, int> follows[] = {{after.at(dart), other.at(image[dart])}, {-dart, -image[dart]}};
    for (const auto& [x, y] : follows) {
      const auto [at, is_new] = image.emplace(x, y);
      if (at->second != y) return false;
      if (is_new) waiting.push_back(x);
    }
  }
  return true;
}

}  // namespace

void CheckKnotEmbedding(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "rotation", "nameless"});
  const KnotCode code = ReadIrreducibleCode(certificate, 2);
  const Value& text = At(certificate, "rotation");
  const Rotation own = OwnRotation(code), rotation = ReadRotation(text, own);
  if (!IsOnSphere(rotation)) throw Refused(&text, "the faces do not add up to a sphere");
  const Next after = After(rotation);
  if (after == After(own)) throw Refused(&text, "this is the drawing that the P-data has");
  if (after == Before(own))
    throw Refused(&text, "this is the mirror image of the drawing that the P-data has");
  if (!AsBool(At(certificate, "nameless"))) return;
  for (const auto& [dart, ignored] : after) {
    if (Carries(After(own), 1, after, dart) || Carries(After(own), 1, Before(rotation), dart))
      throw Refused(&At(certificate, "nameless"), "without names the two drawings are alike");
  }
}

}  // namespace tact::check
