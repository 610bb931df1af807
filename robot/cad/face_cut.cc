#include "robot/cad/face_cut.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

#include "algebra/solid/planar_region.h"

namespace tact::cad {
namespace {

using algebra::Rational;
using algebra::Vector3;
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
struct FaceInfo {
  int depth = -1;  // loops around it
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<size_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel,
                                                CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::No_constraint_intersection_tag>;

// From outside inwards: crossing a loop's edge is one loop deeper.
void FindDepths(Triangulation& cut) {
  std::vector<Triangulation::Face_handle> front = {cut.infinite_face()};
  front.front()->info().depth = 0;
  for (int depth = 0; !front.empty(); ++depth) {
    std::vector<Triangulation::Face_handle> deeper;
    while (!front.empty()) {
      const auto face = front.back();
      front.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto neighbour = face->neighbor(i);
        if (neighbour->info().depth >= 0) continue;
        const bool through = cut.is_constrained({face, i});
        if (through) {
          deeper.push_back(neighbour);
        } else {
          neighbour->info().depth = depth;
          front.push_back(neighbour);
        }
      }
    }
    for (const auto& face : deeper) {
      if (face->info().depth >= 0) continue;
      face->info().depth = depth + 1;
      front.push_back(face);
    }
  }
}

Rational TwiceArea(algebra::Axes axes, const std::vector<Vector3>& points, const size_t* corners,
                   size_t count) {
  Rational sum;
  for (size_t i = 0; i < count; ++i) {
    const Vector3 &a = points[corners[i]], &b = points[corners[(i + 1) % count]];
    sum += a[axes.u] * b[axes.v] - a[axes.v] * b[axes.u];
  }
  return sum;
}

}  // namespace

std::optional<std::vector<std::array<size_t, 3>>> CutFace(const std::vector<Vector3>& points,
                                                          const std::vector<std::vector<size_t>>& loops,
                                                          const Vector3& normal) {
  const algebra::Axes axes = algebra::ProjectionAxes(normal);
  Triangulation cut;
  Rational wanted;
  size_t corners = 0;
  try {
    for (const auto& loop : loops) {
      std::vector<Triangulation::Vertex_handle> handles;
      for (const size_t corner : loop) {
        const Vector3& p = points[corner];
        handles.push_back(cut.insert({CGAL::Gmpq(p[axes.u].ToString()), CGAL::Gmpq(p[axes.v].ToString())}));
        handles.back()->info() = corner;
      }
      for (size_t i = 0; i < handles.size(); ++i)
        cut.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
      wanted += TwiceArea(axes, points, loop.data(), loop.size());
      corners += loop.size();
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  size_t edges = 0;
  for (const auto& edge : cut.finite_edges()) edges += cut.is_constrained(edge) ? 1 : 0;
  if (cut.number_of_vertices() != corners || edges != corners) return std::nullopt;
  FindDepths(cut);
  std::vector<std::array<size_t, 3>> triangles;
  Rational area;
  for (const auto face : cut.finite_face_handles()) {
    if (face->info().depth != 1) continue;
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    area += TwiceArea(axes, points, triangles.back().data(), 3);
  }
  if (area != wanted) return std::nullopt;  // a hole outside, or in another one
  return triangles;
}

}  // namespace tact::cad
