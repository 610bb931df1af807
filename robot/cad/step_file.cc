#include "robot/cad/step_file.h"

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
#include <gp_Pln.hxx>
#include <mutex>
#include <sstream>

#include "algebra/error.h"

namespace tact::cad {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kBegin = "ISO-10303-21;", kEnd = "END-ISO-10303-21;";
constexpr std::string_view kBlanks = " \t\r\n";
constexpr const char* kOnlyPlanes =
    "only planar faces with straight edges can be used; export a faceted model, as STEP or as STL";

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

Vector3d ToVector(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

void CheckText(std::string_view contents, const std::string& name) {
  const size_t first = contents.find_first_not_of(kBlanks);
  if (first == std::string_view::npos || contents.substr(first, kBegin.size()) != kBegin) {
    throw InputError(name + ":1: expected a STEP file, which begins with \"" + std::string(kBegin) +
                     "\", got something else");
  }
  const size_t last = contents.find_last_not_of(kBlanks) + 1;
  if (last < kEnd.size() || contents.substr(last - kEnd.size(), kEnd.size()) != kEnd) {
    throw InputError(name + ": expected \"" + std::string(kEnd) +
                     "\" at the end, got none: the file was cut short");
  }
}

// Names a face by its number and, where the reader knows it, its line in the file.
std::string NameOf(const STEPControl_Reader& reader, const TopoDS_Face& face, size_t number) {
  const std::string name = "face " + std::to_string(number);
  const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(face, 1);
  if (entity.IsNull()) return name;
  return name + " (" + reader.Model()->StringLabel(entity)->ToCString() + ")";
}

std::vector<Vector3d> LoopOf(const TopoDS_Wire& wire, const TopoDS_Face& face, const std::string& where) {
  std::vector<Vector3d> loop;
  for (BRepTools_WireExplorer edges(wire, face); edges.More(); edges.Next()) {
    const GeomAbs_CurveType type = BRepAdaptor_Curve(edges.Current()).GetType();
    if (type != GeomAbs_Line)
      throw InputError(where + " has an edge that is " + Words(type) + ": " + kOnlyPlanes);
    loop.push_back(ToVector(BRep_Tool::Pnt(edges.CurrentVertex()).XYZ()));
  }
  return loop;
}

LoopedFace FaceOf(const TopoDS_Face& face, const std::string& face_name, const std::string& name) {
  const std::string where = name + ": " + face_name;
  LoopedFace result;
  result.name = face_name;
  const gp_Pln plane = BRepAdaptor_Surface(face).Plane();
  const gp_Dir normal = plane.Position().XDirection().Crossed(plane.Position().YDirection());
  result.normal = ToVector(normal.XYZ());
  if (face.Orientation() == TopAbs_REVERSED) result.normal = -result.normal;
  const TopoDS_Wire outer = BRepTools::OuterWire(face);
  result.loops.push_back(LoopOf(outer, face, where));
  for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
    const TopoDS_Wire& wire = TopoDS::Wire(wires.Current());
    if (!wire.IsSame(outer)) result.loops.push_back(LoopOf(wire, face, where));
  }
  for (const auto& loop : result.loops) {
    if (loop.size() < 3) {
      throw InputError(where + ": expected loops of three corners and more, got one of " +
                       std::to_string(loop.size()));
    }
  }
  return result;
}

std::vector<LoopedFace> ReadFaces(std::string_view contents, const std::string& name) {
  STEPControl_Reader reader;
  std::istringstream stream{std::string(contents)};
  if (reader.ReadStream(name.c_str(), stream) != IFSelect_RetDone)
    throw InputError(name + ": expected a STEP file, got contents that the STEP reader refuses");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  std::vector<TopoDS_Face> found;
  if (!shape.IsNull()) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      found.push_back(TopoDS::Face(it.Current()));
  }
  if (found.empty())
    throw InputError(name + ": expected a solid of planar faces, got a STEP file without faces");
  // Surfaces first: a bore's wall says more than the circle around its mouth.
  for (size_t i = 0; i < found.size(); ++i) {
    const GeomAbs_SurfaceType type = BRepAdaptor_Surface(found[i]).GetType();
    if (type == GeomAbs_Plane) continue;
    throw InputError(name + ": " + NameOf(reader, found[i], i + 1) + " is " + Words(type) + ": " +
                     kOnlyPlanes);
  }
  std::vector<LoopedFace> faces;
  for (size_t i = 0; i < found.size(); ++i)
    faces.push_back(FaceOf(found[i], NameOf(reader, found[i], i + 1), name));
  return faces;
}

}  // namespace

std::vector<LoopedFace> ReadStepFaces(std::string_view contents, const std::string& name) {
  CheckText(contents, name);
  static std::mutex mutex;  // the reader's settings are the process'
  const std::lock_guard lock(mutex);
  Message::DefaultMessenger()->ChangePrinters().Clear();  // they write to standard output
  try {
    return ReadFaces(contents, name);
  } catch (const Standard_Failure& failure) {
    throw InputError(name + ": expected a STEP file, got contents that the STEP reader refuses: " +
                     std::string(failure.GetMessageString()));
  }
}

}  // namespace tact::cad
