#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

Polyhedron Transform(const Polyhedron& solid, const Pose& X) {
  Polyhedron moved = solid;
  for (Vertex& vertex : moved.vertices) vertex.point = X * vertex.point;
  for (Face& face : moved.faces) {
    face.normal = Primitive(X.rotation * face.normal);
    face.offset = Dot(face.normal, moved.vertices[face.loops[0][0]].point);
  }
  return moved;
}

Rational SixfoldVolume(const Polyhedron& solid) {
  Rational volume;
  for (const Face& face : solid.faces) {
    Vector3 area;  // twice the face's area along its normal
    for (const auto& loop : face.loops) {
      for (size_t i = 0; i < loop.size(); ++i) {
        area = area + Cross(solid.vertices[loop[i]].point, solid.vertices[loop[(i + 1) % loop.size()]].point);
      }
    }
    volume += Dot(solid.vertices[face.loops[0][0]].point, area);
  }
  return volume;
}

}  // namespace tact::algebra
