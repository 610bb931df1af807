#include "provers/report/knot_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "algebra/knot/curve_views.h"
#include "algebra/knot/exact_drawing.h"
#include "provers/report/smooth_rope.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using Point = LayoutPoint;

constexpr double kMargin = 16;  // pixels

double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

// A rope to be drawn: pieces one after the other, and for each column the piece at whose beginning its intersection is met.
struct Rope {
  std::vector<Cubic> pieces;
  std::vector<int> piece_of;  // of column i at index i - 1
};

// Where the drawing lands: x to the right, y down.
class Frame {
 public:
  Frame(const Rope& rope, double size) {
    left_ = top_ = rope.pieces[0].control[0].x;
    double right = left_, bottom = top_ = rope.pieces[0].control[0].y;
    for (const Cubic& piece : rope.pieces) {
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Point point = piece.At(share);
        left_ = std::min(left_, point.x);
        right = std::max(right, point.x);
        bottom = std::min(bottom, point.y);
        top_ = std::max(top_, point.y);
      }
    }
    scale_ = std::min((size - 2 * kMargin) / std::max({right - left_, top_ - bottom, 1e-9}), size / 4);
    width_ = (right - left_) * scale_ + 2 * kMargin;
    height_ = (top_ - bottom) * scale_ + 2 * kMargin;
  }
  Point operator()(Point p) const {
    return {kMargin + (p.x - left_) * scale_, kMargin + (top_ - p.y) * scale_};
  }
  double scale() const { return scale_; }
  double width() const { return width_; }
  double height() const { return height_; }

 private:
  double scale_ = 1, left_ = 0, top_ = 0, width_ = 0, height_ = 0;
};

// From blue at the selective end to red at the other: which strand goes on where can be followed by colour.
std::string ColourAt(double share) {
  struct Stop {
    double at, red, green, blue;
  };
  static constexpr Stop kStops[] = {
      {0, 33, 92, 173}, {0.35, 20, 140, 130}, {0.65, 190, 130, 20}, {1, 196, 48, 62}};
  size_t k = 1;
  while (k < 3 && share > kStops[k].at) ++k;
  const Stop &a = kStops[k - 1], &b = kStops[k];
  const double t = (share - a.at) / (b.at - a.at);
  const auto mix = [&](double x, double y) { return static_cast<int>(std::lround(x + t * (y - x))); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue));
}

class Picture {
 public:
  Picture(const knot::PData& p, const Rope& rope, const KnotDrawingOptions& options)
      : p_(p),
        rope_(rope),
        options_(options),
        frame_(rope, options.size),
        column_at_(rope.pieces.size() + 1, 0) {
    double sum = 0;
    for (const Cubic& piece : rope.pieces) sum += piece.length();
    stroke_ = std::clamp(0.13 * sum / static_cast<double>(rope.pieces.size()) * frame_.scale(), 1.2, 5.0);
    for (size_t column = 0; column < rope.piece_of.size(); ++column)
      column_at_[static_cast<size_t>(rope.piece_of[column])] = static_cast<int>(column) + 1;
  }

  std::string Svg() {
    for (size_t k = 0; k < rope_.pieces.size(); ++k) {
      const double gap =
          std::min(0.45, 1.9 * stroke_ / std::max(rope_.pieces[k].length() * frame_.scale(), 1e-9));
      Stroke(k, PassesUnder(k) ? gap : 0, PassesUnder(k + 1) ? 1 - gap : 1);
    }
    Ends();
    if (options_.labels) Labels();
    const std::string title =
        options_.title.empty()
            ? fmt::format("A rope with {} intersection{}", p_.crossings(), p_.crossings() == 1 ? "" : "s")
            : options_.title;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" "
        "role=\"img\"><title>{2}</title><g fill=\"none\" stroke-width=\"{3:.2f}\" "
        "stroke-linecap=\"round\">{4}</g>{5}</svg>",
        std::ceil(frame_.width()), std::ceil(frame_.height()), Escape(title), stroke_, strokes_, marks_);
  }

 private:
  bool PassesUnder(size_t k) const { return column_at_[k] > 0 && !p_.over(column_at_[k]); }
  std::string ColourOf(size_t k) const {
    return ColourAt((static_cast<double>(k) + 0.5) / static_cast<double>(rope_.pieces.size()));
  }

  void Stroke(size_t k, double from, double to) {
    const Cubic part = rope_.pieces[k].Part(from, to);
    std::array<Point, 4> at;
    for (size_t i = 0; i < at.size(); ++i) at[i] = frame_(part.control[i]);
    strokes_ +=
        fmt::format("<path d=\"M{:.2f} {:.2f}C{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}\" stroke=\"{}\"/>",
                    at[0].x, at[0].y, at[1].x, at[1].y, at[2].x, at[2].y, at[3].x, at[3].y, ColourOf(k));
  }

  void Ends() {
    const Point start = frame_(rope_.pieces.front().At(0));
    marks_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>", start.x, start.y,
                          1.6 * stroke_, ColourAt(0));
    for (size_t k = 4; k + 3 < rope_.pieces.size(); ++k) {
      if (column_at_[k] == 0 && column_at_[k + 1] == 0 && ++since_arrow_ >= 6) Arrowhead(k, 0.5, 0.8);
    }
    Arrowhead(rope_.pieces.size() - 1, 1, 1);
  }

  // With the tip ahead of the place.
  void Arrowhead(size_t k, double share, double size) {
    since_arrow_ = 0;
    const Point at = frame_(rope_.pieces[k].At(share)), from = frame_(rope_.pieces[k].At(share - 0.3));
    const double length = std::max(Distance(at, from), 1e-9), half = size * (1.5 * stroke_ + 1.5);
    const Point u = {(at.x - from.x) / length, (at.y - from.y) / length};
    const auto corner = [&](double along, double across) {
      return fmt::format("{:.2f},{:.2f}", at.x + along * u.x - across * u.y,
                         at.y + along * u.y + across * u.x);
    };
    marks_ += fmt::format("<polygon points=\"{} {} {}\" fill=\"{}\"/>", corner(1.5 * half, 0),
                          corner(-0.7 * half, half), corner(-0.7 * half, -half), ColourOf(k));
  }

  // The number of each segment in its middle, the two columns of each intersection beside it.
  void Labels() {
    size_t begin = 0;
    for (int segment = 1; segment <= p_.segments(); ++segment) {
      const size_t end = segment > p_.columns()
                             ? rope_.pieces.size()
                             : static_cast<size_t>(rope_.piece_of[static_cast<size_t>(segment) - 1]);
      const size_t middle = (begin + end) / 2;
      Label(middle, (begin + end) % 2 == 0 ? 0 : 0.5, std::to_string(segment), ColourOf(middle), 11, false);
      if (segment <= p_.columns() && segment < p_.sigma(segment))
        Label(end, 0, fmt::format("{}\u00b7{}", segment, p_.sigma(segment)), "#555", 9, true);
      begin = end;
    }
  }

  // On the left of the rope; at an intersection in the corner on the left ahead.
  void Label(size_t k, double share, const std::string& text, const std::string& colour, int size,
             bool corner) {
    const Point at = frame_(rope_.pieces[k].At(share)), ahead = frame_(rope_.pieces[k].At(share + 0.05));
    const double length = std::max(Distance(at, ahead), 1e-9), away = 1.2 * stroke_ + 7;
    const Point u = {(ahead.x - at.x) / length, (ahead.y - at.y) / length};
    const Point side = corner ? Point{u.y + u.x, u.y - u.x} : Point{u.y, -u.x};
    marks_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" font-family=\"sans-serif\" text-anchor=\"middle\" "
        "dominant-baseline=\"central\" fill=\"{}\" paint-order=\"stroke\" stroke=\"#fff\" "
        "stroke-width=\"2.5\">{}</text>",
        at.x + away * side.x, at.y + away * side.y, size, colour, text);
  }

  const knot::PData& p_;
  const Rope& rope_;
  const KnotDrawingOptions& options_;
  Frame frame_;
  std::vector<int> column_at_;  // the column met at the beginning of each piece; 0: none
  double stroke_ = 3;
  int since_arrow_ = 0;
  std::string strokes_, marks_;
};

// The cubics at which a drawing is not of the P-data; nullopt: it is.
std::optional<std::vector<size_t>> Misread(const std::vector<Cubic>& cubics, const RopeLayout& layout,
                                           const knot::PData& p) {
  const auto read = knot::ProjectCurve(PolylineOf(cubics, layout, p), knot::ViewFromAbove());
  std::vector<size_t> where;
  if (const auto* fault = std::get_if<knot::CurveFault>(&read)) {
    for (const int point : fault->points) where.push_back(CubicOf(point, cubics.size()));
    return where;
  }
  const auto& projection = std::get<knot::CurveProjection>(read);
  if (projection.p == p) return std::nullopt;
  std::vector<bool> meets(layout.rope.size(), false);
  for (const int place : layout.place) meets[static_cast<size_t>(place)] = true;
  for (const knot::CurvePlace& place : projection.places) {
    const size_t cubic = CubicOf(place.edge + 1, cubics.size());
    if (!meets[cubic] && !meets[cubic + 1]) where.push_back(cubic);
  }
  return where;
}

// As round as it may be: where it is misread the rope bends less.
std::optional<std::vector<Cubic>> SmoothAndReadBack(const RopeLayout& layout, const knot::PData& p) {
  constexpr int kTries = 40;
  std::vector<double> bends(layout.rope.size(), 1);
  for (int round = 0; round < kTries; ++round) {
    std::vector<Cubic> cubics = SmoothRope(layout, bends);
    const auto misread = Misread(cubics, layout, p);
    if (!misread) return cubics;
    for (const size_t cubic : *misread) {
      for (const size_t node : {cubic, cubic + 1}) bends[node] = bends[node] > 0.2 ? bends[node] / 2 : 0;
    }
    if (misread->empty()) {
      for (double& bend : bends) bend /= 2;
    }
  }
  return std::nullopt;
}

// Two points on a segment let it bend, a loop needs four.
std::vector<int> PointsForBends(const knot::PData& p) {
  std::vector<int> more(static_cast<size_t>(p.segments()), 1);
  for (int i = 1; i < p.columns(); ++i) more[static_cast<size_t>(i)] += p.sigma(i) == i + 1 ? 1 : 0;
  return more;
}

// The exact drawing's, with the rope's vertices as nodes.
RopeLayout ExactLayout(const knot::PData& p, int outer, const std::vector<int>& more) {
  const knot::DiagramTriangulation t = TriangulateDiagram(p, outer, more);
  const std::vector<knot::PlanePoint> points = EmbedTriangulation(t);
  RopeLayout layout{{}, t.rope, t.place};
  std::vector<int> number(points.size(), -1);
  for (int& node : layout.rope) {
    int& its = number[static_cast<size_t>(node)];
    if (its < 0) {
      its = static_cast<int>(layout.nodes.size());
      const knot::PlanePoint& point = points[static_cast<size_t>(node)];
      layout.nodes.push_back({ToDouble(point.x), ToDouble(point.y)});
    }
    node = its;
  }
  return layout;
}

}  // namespace

std::string KnotSvg(const knot::PData& p, const KnotDrawingOptions& options) {
  const int outer = options.outer ? *options.outer : BestOuterFace(knot::Faces(p), p.segments());
  if (!options.exact) {
    const RopeLayout relaxed = Relax(ExactLayout(p, outer, PointsForBends(p)));
    if (const auto cubics = SmoothAndReadBack(relaxed, p))
      return Picture(p, {*cubics, relaxed.place}, options).Svg();
  }
  const RopeLayout exact = ExactLayout(p, outer, {});
  return Picture(p, {SmoothRope(exact, std::vector<double>(exact.rope.size(), 0)), exact.place}, options)
      .Svg();
}

}  // namespace tact::provers
