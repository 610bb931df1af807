#include "provers/report/rope_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tact::provers {
namespace {

constexpr int kMostUntangling = 2000;  // rounds until no edge is shorter than kUntangled
constexpr double kUntangled = 0.25;
constexpr int kRounds = 250;  // after that, with less and less way to go
constexpr int kRoundsBetweenNodes = 6;
constexpr double kClearance = 1.7;       // strands nearer than that push each other
constexpr double kNearClearance = 0.35;  // the same of one strand, two steps apart
constexpr double kShortening = 0.5;      // of the way to the middle of the neighbours, a round
constexpr double kStraightening = 0.25;  // the same, the neighbours giving way; strong at intersections
constexpr double kStraight = 0.6;
constexpr double kSpacing = 0.6;                   // what an edge wants, weakly
constexpr double kEndEdge = 1.4;                   // what the first and last edge want
constexpr int kEndEdges = 3;                       // as many as an end segment has, at most
constexpr double kLongest = 1.5, kShortest = 0.8;  // edges
constexpr double kFar = 3;                         // what is farther apart does not meet in a round

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

// Nodes by squares of side kFar, the outermost ones going on without end.
class Cells {
 public:
  void Fill(const std::vector<Point>& nodes) {
    left_ = bottom_ = 0;
    double right = 0, top = 0;
    for (const Point& p : nodes) {
      left_ = std::min(left_, p.x);
      bottom_ = std::min(bottom_, p.y);
      right = std::max(right, p.x);
      top = std::max(top, p.y);
    }
    columns_ = std::min(kMost, 1 + static_cast<int>((right - left_) / kFar));
    rows_ = std::min(kMost, 1 + static_cast<int>((top - bottom_) / kFar));
    cells_.assign(At(columns_ * rows_), {});
    for (size_t v = 0; v < nodes.size(); ++v)
      cells_[At(Row(nodes[v].y) * columns_ + Column(nodes[v].x))].push_back(static_cast<int>(v));
  }
  // Nodes within kFar of a box about a and b, and some more.
  template <typename Visit>
  void ForEachNear(Point a, Point b, const Visit& visit) const {
    const int left = Column(std::min(a.x, b.x) - kFar), right = Column(std::max(a.x, b.x) + kFar);
    const int bottom = Row(std::min(a.y, b.y) - kFar), top = Row(std::max(a.y, b.y) + kFar);
    for (int row = bottom; row <= top; ++row) {
      for (int column = left; column <= right; ++column) {
        for (const int v : cells_[At(row * columns_ + column)]) visit(v);
      }
    }
  }

 private:
  static constexpr int kMost = 64;
  int Column(double x) const { return std::clamp(static_cast<int>((x - left_) / kFar), 0, columns_ - 1); }
  int Row(double y) const { return std::clamp(static_cast<int>((y - bottom_) / kFar), 0, rows_ - 1); }

  double left_ = 0, bottom_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;
};

class Relaxation {
 public:
  explicit Relaxation(RopeLayout layout) : l_(std::move(layout)) {}

  RopeLayout Run() {
    ScaleToUnit();
    for (int round = 0; round < kMostUntangling && ShortestEdge() < kUntangled; ++round) {
      if (round % kRoundsBetweenNodes == 0) ChangeNodes();
      Move(1);
    }
    for (int round = 0; round < kRounds; ++round) {
      if (round % kRoundsBetweenNodes == 0 && round + 2 * kRoundsBetweenNodes < kRounds) ChangeNodes();
      Move(1 - 0.9 * round / kRounds);
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

  double ShortestEdge() const {
    double shortest = kLongest;
    for (size_t k = 1; k < l_.rope.size(); ++k) shortest = std::min(shortest, Length(Node(k) - Node(k - 1)));
    return shortest;
  }

  void ChangeNodes() {
    AddNodes();
    RemoveNodes();
    CutEnds();
  }

  Point Node(size_t k) const { return l_.nodes[At(l_.rope[k])]; }

  void Move(double cooling) {
    places_.assign(l_.nodes.size(), {-1, -1});
    for (size_t k = 0; k < l_.rope.size(); ++k) {
      auto& [first, second] = places_[At(l_.rope[k])];
      (first < 0 ? first : second) = static_cast<int>(k);
    }
    cells_.Fill(l_.nodes);
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
      const double clearance = IsNear(v, edge) ? kNearClearance : kClearance;
      if (distance > clearance) return;
      // The nearer the stronger without end: deep inside loops what is near counts, not what is many.
      const double near = std::max(distance, 1e-15);
      const Point push = 0.5 * (clearance / near - 1) / near * from_edge;
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
      // What is near already, measured by the edge, comes no nearer.
      const double room = distance < 1e-3 * Length(Node(edge) - Node(edge - 1)) ? 0 : distance / 3;
      const auto limit = [&](int node, double toward) {
        if (toward > room) allowed[At(node)] = std::min(allowed[At(node)], room / toward);
      };
      const Point normal = 1 / std::max(distance, 1e-300) * from_edge;
      limit(v, -Dot(move[At(v)], normal));
      limit(l_.rope[edge - 1], Dot(move[At(l_.rope[edge - 1])], normal));
      limit(l_.rope[edge], Dot(move[At(l_.rope[edge])], normal));
    });
    return allowed;
  }

  // Every edge, by the place on the rope where it ends, with every node within kFar that does not end it.
  template <typename Visit>
  void ForEachNodeAndEdge(const Visit& visit) const {
    for (size_t k = 1; k < l_.rope.size(); ++k) {
      const int a = l_.rope[k - 1], b = l_.rope[k];
      const Point pa = l_.nodes[At(a)], pb = l_.nodes[At(b)];
      cells_.ForEachNear(pa, pb, [&](int v) {
        if (v == a || v == b) return;
        double share = 0;
        const Point from_edge = FromEdge(pa, pb, l_.nodes[At(v)], share);
        visit(v, k, from_edge, Length(from_edge), share);
      });
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
  Cells cells_;
  size_t spared_from_ = static_cast<size_t>(-1);  // the column before which a node went in this round
  std::vector<std::array<int, 2>> places_;        // of each node on the rope; -1: none
};

}  // namespace

RopeLayout Relax(RopeLayout layout) { return Relaxation(std::move(layout)).Run(); }

}  // namespace tact::provers
