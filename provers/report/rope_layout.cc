#include "provers/report/rope_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tact::provers {
namespace {

constexpr int kRounds = 300;
constexpr int kRoundsBetweenNodes = 6;
constexpr double kClearance = 1.7;       // strands nearer than that push each other
constexpr double kShortening = 0.5;      // of the way to the middle of the neighbours, a round
constexpr double kStraightening = 0.25;  // the same, the neighbours giving way; strong at intersections
constexpr double kStraight = 0.6;
constexpr double kSpacing = 0.6;                   // what an edge wants, weakly
constexpr double kEndEdge = 1.4;                   // what the first and last edge want
constexpr int kEndEdges = 3;                       // as many as an end segment has, at most
constexpr double kLongest = 1.5, kShortest = 0.8;  // edges
constexpr double kFar = 5;                         // nothing moves so far in a round

using Point = LayoutPoint;

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double Cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double Length(Point a) { return std::hypot(a.x, a.y); }

size_t At(int i) { return static_cast<size_t>(i); }

// From the nearest point of the edge a-b to p; `share` is where on the edge that is.
Point FromEdge(Point a, Point b, Point p, double& share) {
  const Point along = b - a;
  share = std::clamp(Dot(p - a, along) / std::max(Dot(along, along), 1e-300), 0.0, 1.0);
  return p - (a + share * along);
}

class Relaxation {
 public:
  explicit Relaxation(RopeLayout layout) : l_(std::move(layout)) {}

  RopeLayout Run() {
    ScaleToUnit();
    for (int round = 0; round < kRounds; ++round) {
      if (round % kRoundsBetweenNodes == 0 && round + 2 * kRoundsBetweenNodes < kRounds) {
        AddNodes();
        RemoveNodes();
        CutEnds();
      }
      const double cooling = 1 - 0.9 * round / kRounds;
      Move(cooling);
    }
    return std::move(l_);
  }

 private:
  // So that the mean edge has the length 1.
  void ScaleToUnit() {
    double sum = 0;
    for (size_t k = 1; k < l_.rope.size(); ++k) sum += Length(Node(k) - Node(k - 1));
    const double scale = static_cast<double>(l_.rope.size() - 1) / sum;
    for (Point& p : l_.nodes) p = scale * p;
  }

  Point Node(size_t k) const { return l_.nodes[At(l_.rope[k])]; }

  void Move(double cooling) {
    places_.assign(l_.nodes.size(), {-1, -1});
    for (size_t k = 0; k < l_.rope.size(); ++k) {
      auto& [first, second] = places_[At(l_.rope[k])];
      (first < 0 ? first : second) = static_cast<int>(k);
    }
    std::vector<Point> move = Forces();
    for (Point& m : move) {
      const double length = Length(m);
      if (length > cooling) m = cooling / length * m;
    }
    const std::vector<double> share = Allowed(move);
    for (size_t i = 0; i < move.size(); ++i) l_.nodes[i] = l_.nodes[i] + share[i] * move[i];
  }

  std::vector<Point> Forces() const {
    std::vector<Point> force(l_.nodes.size());
    const auto add = [&](int node, Point f) { force[At(node)] = force[At(node)] + f; };
    const size_t last = l_.rope.size() - 1;
    for (size_t k = 1; k < last; ++k) {
      const Point bend = 0.5 * (Node(k - 1) + Node(k + 1)) - Node(k);
      const double straightening = IsIntersection(l_.rope[k]) ? kStraight : kStraightening;
      add(l_.rope[k], (kShortening + straightening) * bend);
      add(l_.rope[k - 1], -0.5 * straightening * bend);
      add(l_.rope[k + 1], -0.5 * straightening * bend);
      const Point edge = Node(k) - Node(k - 1);
      const Point spring = 0.2 * (1 - kSpacing / std::max(Length(edge), 0.1)) * edge;
      add(l_.rope[k - 1], spring);
      add(l_.rope[k], -1 * spring);
    }
    for (const auto& [end, next] : {std::pair<size_t, size_t>{0, 1}, {last, last - 1}}) {
      const Point edge = Node(end) - Node(next);
      add(l_.rope[end], 0.5 * (kEndEdge / std::max(Length(edge), 1e-3) - 1) * edge);
    }
    ForEachNodeAndEdge([&](int v, size_t edge, Point from_edge, double distance, double share) {
      if (distance > kClearance || IsNear(v, edge)) return;
      const Point push = 0.5 * (kClearance / std::max(distance, 1e-3) - 1) * from_edge;
      add(v, push);
      add(l_.rope[edge - 1], (share - 1) * push);
      add(l_.rope[edge], -share * push);
    });
    return force;
  }

  bool IsIntersection(int v) const { return places_[At(v)][1] >= 0; }

  // Whether the node is on the rope a step or two from the edge that ends at place `edge`.
  bool IsNear(int v, size_t edge) const {
    for (const int place : places_[At(v)]) {
      if (place >= 0 && std::abs(2 * place - 2 * static_cast<int>(edge) + 1) <= 5) return true;
    }
    return false;
  }

  // How much of its way each node may go.
  std::vector<double> Allowed(const std::vector<Point>& move) const {
    std::vector<double> allowed(move.size(), 1);
    ForEachNodeAndEdge([&](int v, size_t edge, Point from_edge, double distance, double) {
      const auto limit = [&](int node, double toward) {
        if (toward > distance / 3) allowed[At(node)] = std::min(allowed[At(node)], distance / (3 * toward));
      };
      const Point normal = 1 / std::max(distance, 1e-300) * from_edge;
      limit(v, -Dot(move[At(v)], normal));
      limit(l_.rope[edge - 1], Dot(move[At(l_.rope[edge - 1])], normal));
      limit(l_.rope[edge], Dot(move[At(l_.rope[edge])], normal));
    });
    return allowed;
  }

  // Every edge, by the place on the rope where it ends, with every node near it that does not end it.
  template <typename Visit>
  void ForEachNodeAndEdge(const Visit& visit) const {
    for (size_t k = 1; k < l_.rope.size(); ++k) {
      const int a = l_.rope[k - 1], b = l_.rope[k];
      const Point pa = l_.nodes[At(a)], pb = l_.nodes[At(b)];
      const double left = std::min(pa.x, pb.x) - kFar, right = std::max(pa.x, pb.x) + kFar;
      for (int v = 0; v < static_cast<int>(l_.nodes.size()); ++v) {
        const Point p = l_.nodes[At(v)];
        if (v == a || v == b || p.x < left || p.x > right) continue;
        double share = 0;
        const Point from_edge = FromEdge(pa, pb, p, share);
        visit(v, k, from_edge, Length(from_edge), share);
      }
    }
  }

  void AddNodes() {
    RopeLayout finer;
    finer.nodes = l_.nodes;
    size_t column = 0;
    for (size_t k = 0; k < l_.rope.size(); ++k) {
      if (k > 0 && Length(Node(k) - Node(k - 1)) > kLongest) {
        finer.rope.push_back(static_cast<int>(finer.nodes.size()));
        finer.nodes.push_back(0.5 * (Node(k) + Node(k - 1)));
      }
      if (column < l_.place.size() && At(l_.place[column]) == k) {
        finer.place.push_back(static_cast<int>(finer.rope.size()));
        ++column;
      }
      finer.rope.push_back(l_.rope[k]);
    }
    l_ = std::move(finer);
  }

  // A node between two short edges, if nothing lies between it and the line that replaces them.
  void RemoveNodes() {
    std::vector<bool> gone(l_.nodes.size(), false);
    size_t column = 0, previous = 0;
    for (size_t k = 1; k + 1 < l_.rope.size(); ++k) {
      while (column < l_.place.size() && At(l_.place[column]) < k) ++column;
      const bool meets = column < l_.place.size() && At(l_.place[column]) == k;
      if (!meets && HasNodesToSpare(k, column) && Length(Node(k) - Node(previous)) < kShortest &&
          Length(Node(k + 1) - Node(k)) < kShortest &&
          !IsBetween(l_.rope[previous], l_.rope[k], l_.rope[k + 1], gone)) {
        gone[At(l_.rope[k])] = true;
        spared_from_ = column;  // one at a time
      } else {
        previous = k;
      }
    }
    spared_from_ = l_.place.size() + 1;
    std::vector<int> rope;
    column = 0;
    for (size_t k = 0; k < l_.rope.size(); ++k) {
      if (column < l_.place.size() && At(l_.place[column]) == k)
        l_.place[column++] = static_cast<int>(rope.size());
      if (!gone[At(l_.rope[k])]) rope.push_back(l_.rope[k]);
    }
    l_.rope = std::move(rope);
    KeepNodesOfRope();
  }

  // Whether the segment that ends in that column, at whose place k the node is, has more nodes than it needs to be round: a loop
  // four, others two.
  bool HasNodesToSpare(size_t k, size_t column) const {
    if (column == 0 || column == l_.place.size()) return true;
    const int begin = l_.place[column - 1], end = l_.place[column];
    const bool loop = l_.rope[At(begin)] == l_.rope[At(end)];
    return static_cast<int>(k) > begin && spared_from_ != column && end - begin - 1 > (loop ? 4 : 2);
  }

  // An end segment is as short as shows where the end is.
  void CutEnds() {
    if (l_.place.empty()) return;
    const int begin = std::max(0, l_.place.front() - kEndEdges);
    const int end = std::min(static_cast<int>(l_.rope.size()), l_.place.back() + kEndEdges + 1);
    l_.rope = std::vector<int>(l_.rope.begin() + begin, l_.rope.begin() + end);
    for (int& place : l_.place) place -= begin;
    KeepNodesOfRope();
  }

  void KeepNodesOfRope() {
    std::vector<int> number(l_.nodes.size(), -1);
    std::vector<Point> kept;
    for (int& node : l_.rope) {
      int& its = number[At(node)];
      if (its < 0) {
        its = static_cast<int>(kept.size());
        kept.push_back(l_.nodes[At(node)]);
      }
      node = its;
    }
    l_.nodes = std::move(kept);
  }

  // Whether another node lies in the triangle, or on its rim; or the line that replaces two edges of it is there already.
  bool IsBetween(int a, int b, int c, const std::vector<bool>& gone) const {
    if (a == c) return true;
    const Point pa = l_.nodes[At(a)], pb = l_.nodes[At(b)], pc = l_.nodes[At(c)];
    const double turn = Cross(pb - pa, pc - pa) >= 0 ? 1 : -1;
    for (int v = 0; v < static_cast<int>(l_.nodes.size()); ++v) {
      if (v == a || v == b || v == c || gone[At(v)]) continue;
      const Point p = l_.nodes[At(v)];
      if (turn * Cross(pb - pa, p - pa) >= 0 && turn * Cross(pc - pb, p - pb) >= 0 &&
          turn * Cross(pa - pc, p - pc) >= 0)
        return true;
    }
    for (size_t k = 1; k < l_.rope.size(); ++k) {
      const int from = l_.rope[k - 1], to = l_.rope[k];
      if ((from == a && to == c) || (from == c && to == a)) return true;
    }
    return false;
  }

  RopeLayout l_;
  size_t spared_from_ = static_cast<size_t>(-1);  // the column before which a node went in this round
  std::vector<std::array<int, 2>> places_;        // of each node on the rope; -1: none
};

}  // namespace

RopeLayout Relax(RopeLayout layout) { return Relaxation(std::move(layout)).Run(); }

}  // namespace tact::provers
