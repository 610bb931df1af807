#include "robot/cad/step/step_module.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <gp_Pln.hxx>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr const char* kOnlyPlanes =
    "only planar faces with straight edges can be used; export a faceted model, as STEP or as STL";

struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Loop = std::vector<gp_XYZ>;

struct Face {
  std::string name;
  gp_XYZ normal;
  std::vector<Loop> loops;
};

std::string Words(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Cylinder:
      return "a cylinder";
    case GeomAbs_Cone:
      return "a cone";
    case GeomAbs_Sphere:
      return "a sphere";
    case GeomAbs_Torus:
      return "a torus";
    case GeomAbs_BezierSurface:
      return "a Bezier surface";
    case GeomAbs_BSplineSurface:
      return "a B-spline surface";
    case GeomAbs_SurfaceOfRevolution:
      return "a surface of revolution";
    case GeomAbs_SurfaceOfExtrusion:
      return "a surface of extrusion";
    default:
      return "another surface than a plane";
  }
}

std::string Words(GeomAbs_CurveType type) {
  switch (type) {
    case GeomAbs_Circle:
      return "a circle's arc";
    case GeomAbs_Ellipse:
      return "an ellipse's arc";
    case GeomAbs_BSplineCurve:
      return "a B-spline curve";
    default:
      return "curved";
  }
}

// Names a face by its number and, where the reader knows it, its line in the file.
std::string NameOf(const STEPControl_Reader& reader, const TopoDS_Face& face, size_t number) {
  const std::string name = "face " + std::to_string(number);
  const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(face, 1);
  if (entity.IsNull()) return name;
  return name + " (" + reader.Model()->StringLabel(entity)->ToCString() + ")";
}

Loop LoopOf(const TopoDS_Wire& wire, const TopoDS_Face& face, const std::string& where) {
  Loop loop;
  for (BRepTools_WireExplorer edges(wire, face); edges.More(); edges.Next()) {
    const GeomAbs_CurveType type = BRepAdaptor_Curve(edges.Current()).GetType();
    if (type != GeomAbs_Line)
      throw Refusal(where + " has an edge that is " + Words(type) + ": " + kOnlyPlanes);
    loop.push_back(BRep_Tool::Pnt(edges.CurrentVertex()).XYZ());
  }
  return loop;
}

Face FaceOf(const TopoDS_Face& face, const std::string& face_name, const std::string& name) {
  const std::string where = name + ": " + face_name;
  Face result;
  result.name = face_name;
  const gp_Pln plane = BRepAdaptor_Surface(face).Plane();
  const gp_Dir normal = plane.Position().XDirection().Crossed(plane.Position().YDirection());
  result.normal = normal.XYZ();
  if (face.Orientation() == TopAbs_REVERSED) result.normal.Reverse();
  const TopoDS_Wire outer = BRepTools::OuterWire(face);
  result.loops.push_back(LoopOf(outer, face, where));
  for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
    const TopoDS_Wire& wire = TopoDS::Wire(wires.Current());
    if (!wire.IsSame(outer)) result.loops.push_back(LoopOf(wire, face, where));
  }
  for (const auto& loop : result.loops) {
    if (loop.size() < 3) {
      throw Refusal(where + ": expected loops of three corners and more, got one of " +
                    std::to_string(loop.size()));
    }
  }
  return result;
}

std::vector<Face> ReadFaces(std::string_view contents, const std::string& name) {
  STEPControl_Reader reader;
  std::istringstream stream{std::string(contents)};
  if (reader.ReadStream(name.c_str(), stream) != IFSelect_RetDone)
    throw Refusal(name + ": expected a STEP file, got contents that the STEP reader refuses");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  std::vector<TopoDS_Face> found;
  if (!shape.IsNull()) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      found.push_back(TopoDS::Face(it.Current()));
  }
  if (found.empty())
    throw Refusal(name + ": expected a solid of planar faces, got a STEP file without faces");
  // Surfaces first: a bore's wall says more than the circle around its mouth.
  for (size_t i = 0; i < found.size(); ++i) {
    const GeomAbs_SurfaceType type = BRepAdaptor_Surface(found[i]).GetType();
    if (type == GeomAbs_Plane) continue;
    throw Refusal(name + ": " + NameOf(reader, found[i], i + 1) + " is " + Words(type) + ": " + kOnlyPlanes);
  }
  std::vector<Face> faces;
  for (size_t i = 0; i < found.size(); ++i)
    faces.push_back(FaceOf(found[i], NameOf(reader, found[i], i + 1), name));
  return faces;
}

void Tell(const std::vector<Face>& faces, const TactStepSink& sink) {
  const auto numbers = [](const gp_XYZ& v) { return std::array<double, 3>{v.X(), v.Y(), v.Z()}; };
  for (const Face& face : faces) {
    sink.face(sink.self, face.name.c_str(), numbers(face.normal).data());
    for (const Loop& loop : face.loops) {
      sink.loop(sink.self);
      for (const gp_XYZ& corner : loop) sink.corner(sink.self, numbers(corner).data());
    }
  }
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void tact_read_step(const char* contents, size_t size,
                                                                      const char* name,
                                                                      const TactStepSink* sink) {
  static std::mutex mutex;  // the reader's settings are the process'
  const std::lock_guard lock(mutex);
  Message::DefaultMessenger()->ChangePrinters().Clear();  // they write to standard output
  std::string refusal;
  try {
    Tell(ReadFaces({contents, size}, name), *sink);
    return;
  } catch (const Standard_Failure& failure) {
    refusal = std::string(name) + ": expected a STEP file, got contents that the STEP reader refuses: " +
              failure.GetMessageString();
  } catch (const std::exception& error) {
    refusal = error.what();
  }
  sink->refuse(sink->self, refusal.c_str());
}
