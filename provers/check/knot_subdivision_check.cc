// `knot-subdivision`: a barycentric subdivision of a knot graph that is not three-connected [thesis, 5.1.3, Proposition
// 8].
#include <algorithm>
#include <set>

#include "provers/check/kinds.h"
#include "provers/check/knot_graph.h"

namespace tact::check {

void CheckKnotSubdivision(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "faces", "without"});
  const Value &text = At(certificate, "p_data"), &listed = At(certificate, "faces");
  const KnotCode code = ReadCodeOnSphere(text);
  if (code.columns() == 0 || code.columns() > kMostGraphColumns)
    throw Refused(&text, "no intersection, or more columns than this checker tries");
  const KnotGraph graph = GraphOf(code);
  const int intersections = graph.vertices, middles = static_cast<int>(graph.edges.size());
  std::vector<std::vector<int>> faces, own = FaceEdges(code);
  for (const Value& face : AsArray(listed)) faces.push_back(ReadEdges(face, code));
  if (!std::is_permutation(faces.begin(), faces.end(), own.begin(), own.end()))
    throw Refused(&listed, "these are not the faces");
  faces.erase(faces.begin());  // the external one
  // Intersections, then the middles of the edges, then the faces.
  int vertices = intersections + middles;
  std::vector<std::pair<int, int>> edges;
  const auto end = [&](int k) { return graph.edges[static_cast<std::size_t>(k) - 1]; };
  const auto middle = [&](int k) { return intersections + k - 1; };
  for (int k = 1; k <= middles; ++k) {
    edges.emplace_back(end(k).first, middle(k));
    edges.emplace_back(end(k).second, middle(k));
  }
  for (const auto& face : faces) {
    std::set<int> boundary;
    for (const int k : face) boundary.insert({end(k).first, end(k).second, middle(k)});
    for (const int v : boundary) edges.emplace_back(v, vertices);
    ++vertices;
  }
  const Value& removed = At(certificate, "without");
  std::vector<int> without;
  for (const Value& number : AsArray(removed))
    without.push_back(static_cast<int>(AsIndex(number, static_cast<std::size_t>(vertices))));
  if (without.size() > 2) throw Refused(&removed, "three-connected is about two vertices taken away");
  if (vertices > 3 && CountPieces(vertices, edges, without) < 2)
    throw Refused(&removed, "there are more than three vertices, and the rest hangs together");
}

}  // namespace tact::check
