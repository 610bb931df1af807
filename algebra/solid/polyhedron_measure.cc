#include "algebra/solid/planar_region.h"
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
  for (const Face& face : solid.faces) volume += SixfoldVolumeUnder(RegionOf(solid, face));
  return volume;
}

}  // namespace tact::algebra
