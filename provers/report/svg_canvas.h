/// @file
/// Marks in view coordinates, written as SVG: no ids and no style sheet, so that many drawings fit in one page.
/// Shapes  the drawing fills the space it is given in one direction; a column on its left is kept for the triad.
/// Units   pixels; two decimals.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "provers/report/projection.h"

namespace tact::provers {

/// The larger side of the points' bounding box in the picture; zero without points.
double Extent(const std::vector<ViewPoint>& points);

class SvgCanvas {
 public:
  struct Axis {
    std::string name;
    ViewPoint direction;  // unit length
    std::string colour;
  };

  /// A canvas of at most this size in pixels that shows all of `points`, with or without room for a triad.
  SvgCanvas(const std::vector<ViewPoint>& points, double width, double height, bool triad = true);

  void Area(const std::vector<std::vector<ViewPoint>>& loops, const std::string& style);
  void Circle(const ViewPoint& centre, double radius, const std::string& style);
  /// Lines that follow on one another are one stroke.
  void Lines(const std::vector<std::pair<ViewPoint, ViewPoint>>& lines, const std::string& style);
  void Arrow(const ViewPoint& from, const ViewPoint& to, const std::string& colour);
  /// An arrow along the line of sight: a dot in a ring toward the viewer, a cross in it away.
  void SightRing(const ViewPoint& at, bool toward_viewer, const std::string& colour);
  /// A thin arrow with a name beyond its tip; along the line of sight a small ring.
  void NamedArrow(const ViewPoint& from, const ViewPoint& to, const std::string& name,
                  const std::string& colour);
  /// A contact: a dot, or a diamond; hollow if hidden.
  void Mark(const ViewPoint& at, bool diamond, bool hollow, const std::string& colour);
  /// The axes in the lower left corner, those farther from the viewer first.
  void Triad(std::vector<Axis> axes);

  /// Where a point lands, as text: equal for points that look the same.
  std::string Key(const ViewPoint& p) const;
  /// The <svg> element; the title is for those who cannot see it.
  std::string Finish(const std::string& title) const;

 private:
  struct Pixel {
    double x, y;
  };
  Pixel ToPixel(const ViewPoint& p) const;
  // With a white rim, an arrow is seen on any face.
  void ArrowBetween(Pixel from, Pixel to, const std::string& colour, double width, bool rim);
  // Centred.
  void Name(Pixel at, const std::string& name, const std::string& colour);
  void Ring(Pixel at, bool toward_viewer, const std::string& colour, double radius);

  double scale_ = 1, left_ = 0, top_ = 0, width_ = 0, height_ = 0;
  std::string body_;
};

}  // namespace tact::provers
