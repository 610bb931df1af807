#include "provers/report/paint_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tact::provers {
namespace {

struct Box {
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, low_z = low_x;
  double high_x = -low_x, high_y = -low_x, high_z = -low_x;
};

Box BoxOf(const FlatFace& face) {
  Box box;
  for (const ViewPoint& p : face.loops.at(0)) {
    box.low_x = std::min(box.low_x, p.x), box.high_x = std::max(box.high_x, p.x);
    box.low_y = std::min(box.low_y, p.y), box.high_y = std::max(box.high_y, p.y);
    box.low_z = std::min(box.low_z, p.z), box.high_z = std::max(box.high_z, p.z);
  }
  return box;
}

template <typename Visit>
void ForEachEdge(const FlatFace& face, const Visit& visit) {
  for (const auto& loop : face.loops) {
    for (size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
  }
}

double Turn(const ViewPoint& a, const ViewPoint& b, const ViewPoint& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

double DistanceToSegment(const ViewPoint& a, const ViewPoint& b, double x, double y) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square == 0 ? 0 : std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0);
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

// How much nearer to the viewer a is than b where their pictures meet, taken where they differ most.
class DepthGap {
 public:
  DepthGap(const FlatFace& a, const FlatFace& b, double margin) : a_(a), b_(b), margin_(margin) {
    ForEachEdge(a, [&](const ViewPoint& p, const ViewPoint& q) { TryEdge(p, q); });
    ForEachEdge(b, [&](const ViewPoint& p, const ViewPoint& q) { TryEdge(p, q); });
    ForEachEdge(a, [&](const ViewPoint& p, const ViewPoint& q) {
      ForEachEdge(b, [&](const ViewPoint& r, const ViewPoint& s) { TryCrossing(p, q, r, s); });
    });
  }
  bool meet() const { return meet_; }
  double value() const { return value_; }

 private:
  void Try(double x, double y) {
    if (!Covers(a_, x, y, margin_) || !Covers(b_, x, y, margin_)) return;
    meet_ = true;
    const double gap = DepthAt(a_, x, y) - DepthAt(b_, x, y);
    if (std::abs(gap) > std::abs(value_)) value_ = gap;
  }
  void TryEdge(const ViewPoint& p, const ViewPoint& q) {
    Try(p.x, p.y);
    Try((p.x + q.x) / 2, (p.y + q.y) / 2);
  }
  void TryCrossing(const ViewPoint& p, const ViewPoint& q, const ViewPoint& r, const ViewPoint& s) {
    const double turn_p = Turn(r, s, p), turn_q = Turn(r, s, q);
    if ((turn_p > 0) == (turn_q > 0) || (Turn(p, q, r) > 0) == (Turn(p, q, s) > 0)) return;
    const double t = turn_p / (turn_p - turn_q);
    Try(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y));
  }

  const FlatFace& a_;
  const FlatFace& b_;
  double margin_;
  bool meet_ = false;
  double value_ = 0;
};

// Whether a must be painted before b (1), after it (-1), or whenever (0).
int Precedence(const FlatFace& a, const FlatFace& b, double margin) {
  const DepthGap gap(a, b, margin);
  if (!gap.meet()) return 0;
  if (gap.value() < -margin) return 1;
  if (gap.value() > margin) return -1;
  const bool a_front = a.normal.z > 0, b_front = b.normal.z > 0;
  return a_front == b_front ? 0 : (a_front ? -1 : 1);
}

}  // namespace

double DepthAt(const FlatFace& face, double x, double y) {
  const ViewPoint& p = face.loops.at(0).at(0);
  return p.z - (face.normal.x * (x - p.x) + face.normal.y * (y - p.y)) / face.normal.z;
}

bool Covers(const FlatFace& face, double x, double y, double margin) {
  bool inside = false, border = false;
  ForEachEdge(face, [&](const ViewPoint& a, const ViewPoint& b) {
    border = border || DistanceToSegment(a, b, x, y) <= margin;
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  });
  return inside || border;
}

std::vector<size_t> PaintOrder(const std::vector<FlatFace>& faces, double margin) {
  const size_t count = faces.size();
  std::vector<Box> boxes;
  for (const FlatFace& face : faces) boxes.push_back(BoxOf(face));
  std::vector<std::vector<size_t>> later(count);
  std::vector<size_t> waits_for(count, 0);
  for (size_t i = 0; i < count; ++i) {
    for (size_t j = i + 1; j < count; ++j) {
      const Box &a = boxes[i], &b = boxes[j];
      if (a.low_x > b.high_x || b.low_x > a.high_x || a.low_y > b.high_y || b.low_y > a.high_y) continue;
      const int precedence = Precedence(faces[i], faces[j], margin);
      if (precedence == 0) continue;
      const size_t first = precedence > 0 ? i : j, second = precedence > 0 ? j : i;
      later[first].push_back(second);
      ++waits_for[second];
    }
  }
  std::vector<size_t> order;
  std::vector<bool> painted(count, false);
  const auto depth = [&](size_t i) { return boxes[i].low_z + boxes[i].high_z; };
  while (order.size() < count) {
    size_t best = count;
    for (size_t i = 0; i < count; ++i) {
      if (painted[i]) continue;
      const bool free = waits_for[i] == 0, best_free = best < count && waits_for[best] == 0;
      if (best == count || (free && !best_free) || (free == best_free && depth(i) < depth(best))) best = i;
    }
    painted[best] = true;
    order.push_back(best);
    for (const size_t j : later[best]) --waits_for[j];
  }
  return order;
}

}  // namespace tact::provers
