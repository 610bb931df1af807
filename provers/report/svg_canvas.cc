#include "provers/report/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr double kPadding = 14;
constexpr double kTriadColumn = 84;
constexpr double kTriadArm = 30;

struct Box {
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
};

Box BoxOf(const std::vector<ViewPoint>& points) {
  if (points.empty()) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const ViewPoint& p : points) {
    box.low_x = std::min(box.low_x, p.x), box.high_x = std::max(box.high_x, p.x);
    box.low_y = std::min(box.low_y, p.y), box.high_y = std::max(box.high_y, p.y);
  }
  return box;
}

}  // namespace

double Extent(const std::vector<ViewPoint>& points) {
  const Box box = BoxOf(points);
  return std::max(box.high_x - box.low_x, box.high_y - box.low_y);
}

SvgCanvas::SvgCanvas(const std::vector<ViewPoint>& points, double width, double height, bool triad) {
  const double column = triad ? kTriadColumn : kPadding;
  const Box box = BoxOf(points);
  const double across = box.high_x - box.low_x, up = box.high_y - box.low_y;
  const double room_across = std::max(width - column - kPadding, 1.0),
               room_up = std::max(height - 2 * kPadding, 1.0);
  if (across > 0 || up > 0) {
    scale_ = std::min(across > 0 ? room_across / across : room_up / up,
                      up > 0 ? room_up / up : room_across / across);
  }
  width_ = column + scale_ * across + kPadding;
  height_ = std::max(scale_ * up + 2 * kPadding, column + kPadding);
  left_ = column - scale_ * box.low_x;
  top_ = (height_ + scale_ * (box.low_y + box.high_y)) / 2;
}

SvgCanvas::Pixel SvgCanvas::ToPixel(const ViewPoint& p) const {
  return {left_ + scale_ * p.x, top_ - scale_ * p.y};
}

std::string SvgCanvas::Key(const ViewPoint& p) const {
  const Pixel at = ToPixel(p);
  return ShortDecimal(at.x) + " " + ShortDecimal(at.y) + " ";
}

void SvgCanvas::Area(const std::vector<std::vector<ViewPoint>>& loops, const std::string& style) {
  std::string path;
  for (const auto& loop : loops) {
    for (size_t i = 0; i < loop.size(); ++i) path += (i == 0 ? "M" : "L") + Key(loop[i]);
    path += "Z";
  }
  body_ += fmt::format("<path d=\"{}\" {}/>\n", path, style);
}

void SvgCanvas::Circle(const ViewPoint& centre, double radius, const std::string& style) {
  const Pixel at = ToPixel(centre);
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", ShortDecimal(at.x), ShortDecimal(at.y),
                       ShortDecimal(scale_ * radius), style);
}

void SvgCanvas::Lines(const std::vector<std::pair<ViewPoint, ViewPoint>>& lines, const std::string& style) {
  if (lines.empty()) return;
  std::string path, at;
  for (const auto& [from, to] : lines) {
    const std::string start = Key(from), end = Key(to);
    path += (start == at ? "L" : "M" + start + "L") + end;
    at = end;
  }
  path.pop_back();
  body_ += fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" {}/>\n", path, style);
}

void SvgCanvas::ArrowBetween(Pixel from, Pixel to, const std::string& colour, double width, bool rim) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length == 0) return;
  const double head = std::min(4.2 * width, length), half = 0.42 * head;
  const double ux = dx / length, uy = dy / length;
  const Pixel neck{to.x - head * ux, to.y - head * uy};
  const auto n = ShortDecimal;
  const std::string shaft = fmt::format("M{} {}L{} {}", n(from.x), n(from.y), n(neck.x), n(neck.y));
  const std::string tip = fmt::format("M{} {}L{} {}L{} {}Z", n(to.x), n(to.y), n(neck.x - half * uy),
                                      n(neck.y + half * ux), n(neck.x + half * uy), n(neck.y - half * ux));
  if (rim) {
    body_ += fmt::format(
        "<path d=\"{0}\" stroke=\"#ffffff\" stroke-width=\"{2}\"/>"
        "<path d=\"{1}\" stroke=\"#ffffff\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n",
        shaft, tip, n(width + 2));
  }
  body_ += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/><path d=\"{}\" fill=\"{}\"/>\n",
                       shaft, colour, n(width), tip, colour);
}

void SvgCanvas::Arrow(const ViewPoint& from, const ViewPoint& to, const std::string& colour) {
  ArrowBetween(ToPixel(from), ToPixel(to), colour, 2.6, true);
}

void SvgCanvas::Ring(Pixel at, bool toward_viewer, const std::string& colour, double radius) {
  const auto n = ShortDecimal;
  body_ += fmt::format(
      "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.8\"/>\n", n(at.x),
      n(at.y), n(radius), colour);
  if (toward_viewer) {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", n(at.x), n(at.y),
                         n(radius * 0.36), colour);
  } else {
    const double arm = radius * 0.707;
    body_ +=
        fmt::format("<path d=\"M{0} {1}L{2} {3}M{0} {3}L{2} {1}\" stroke=\"{4}\" stroke-width=\"1.5\"/>\n",
                    n(at.x - arm), n(at.y - arm), n(at.x + arm), n(at.y + arm), colour);
  }
}

void SvgCanvas::Name(Pixel at, const std::string& name, const std::string& colour) {
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" fill=\"{}\" font-family=\"Georgia, serif\" font-style=\"italic\" "
      "font-size=\"14\" text-anchor=\"middle\">{}</text>\n",
      ShortDecimal(at.x), ShortDecimal(at.y + 4), colour, Escape(name));
}

void SvgCanvas::NamedArrow(const ViewPoint& from, const ViewPoint& to, const std::string& name,
                           const std::string& colour) {
  constexpr double kShortest = 7, kNameGap = 9;
  const Pixel tail = ToPixel(from), tip = ToPixel(to);
  const double dx = tip.x - tail.x, dy = tip.y - tail.y, length = std::hypot(dx, dy);
  if (length < kShortest) {
    Ring(tip, to.z > from.z, colour, 5);
    Name({tip.x + 1.4 * kNameGap, tip.y + 1.4 * kNameGap}, name, colour);
  } else {
    ArrowBetween(tail, tip, colour, 1.6, false);
    Name({tip.x + kNameGap * dx / length, tip.y + kNameGap * dy / length}, name, colour);
  }
}

void SvgCanvas::SightRing(const ViewPoint& at, bool toward_viewer, const std::string& colour) {
  Ring(ToPixel(at), toward_viewer, colour, 9.5);
}

void SvgCanvas::Mark(const ViewPoint& at, bool diamond, bool hollow, const std::string& colour) {
  const Pixel p = ToPixel(at);
  const auto n = ShortDecimal;
  const std::string style =
      hollow ? fmt::format("fill=\"#ffffff\" fill-opacity=\"0.7\" stroke=\"{}\" stroke-width=\"1.8\"", colour)
             : fmt::format("fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1.2\"", colour);
  if (diamond) {
    body_ += fmt::format("<path d=\"M{0} {1}L{2} {3}L{0} {4}L{5} {3}Z\" {6}/>\n", n(p.x), n(p.y - 6.5),
                         n(p.x + 6.5), n(p.y), n(p.y + 6.5), n(p.x - 6.5), style);
  } else {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4.8\" {}/>\n", n(p.x), n(p.y), style);
  }
}

void SvgCanvas::Triad(std::vector<Axis> axes) {
  std::stable_sort(axes.begin(), axes.end(),
                   [](const Axis& a, const Axis& b) { return a.direction.z < b.direction.z; });
  const Pixel origin{kPadding + 24, height_ - kPadding - 24};
  for (const Axis& axis : axes) {
    const double across = std::hypot(axis.direction.x, axis.direction.y);
    Pixel label{origin.x - 13, origin.y + 13};
    if (across < 0.1) {
      Ring(origin, axis.direction.z > 0, axis.colour, 5);
    } else {
      ArrowBetween(origin, {origin.x + kTriadArm * axis.direction.x, origin.y - kTriadArm * axis.direction.y},
                   axis.colour, 1.6, false);
      const double reach = kTriadArm + 8 / across;
      label = {origin.x + reach * axis.direction.x, origin.y - reach * axis.direction.y};
    }
    Name(label, axis.name, axis.colour);
  }
}

std::string SvgCanvas::Finish(const std::string& title) const {
  const std::string width = ShortDecimal(std::ceil(width_)), height = ShortDecimal(std::ceil(height_));
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"img\">\n"
      "<title>{2}</title>\n{3}</svg>",
      width, height, Escape(title), body_);
}

}  // namespace tact::provers
