/// @file
/// A plier to take range images of: two levers alike, of handle, boss and jaw, that turn about a pin; 150 mm long.
/// Model   A lever is a bar of rounded section along a bent line, a boss of half the thickness, and a rivet's head. The other
///         lever is the same, turned over about x. At angle 0 the jaws meet; 0.5 (30 degrees) is wide open.
/// Frames  a lever's z is the pin; handles lie toward -x. Lever 1 sees lever 2 turned by the opening about z.
/// Units   metre, radian.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/perception/range_image.h"

namespace tact::perception {

/// Lever 1.
TriangleMesh PlierLever();

/// Both levers of a plier opened so far, lever 1 in the place X_CL.
std::vector<PosedMesh> OpenPlier(const Transform& X_CL, double opening);

/// How a plier is scanned in several states: put down afresh before each scan, almost in the same place, 0.7 m away.
struct PlierStudy {
  std::vector<double> openings = {0, 0.13, 0.26, 0.39, 0.52};  // 0 to 30 degrees, as in [thesis, 4.5.3]
  RangeCamera camera = {};
  double turned = 0.09;   // how far it is turned each time, at most
  double shifted = 0.01;  // and shifted
  std::uint64_t seed = 1;
};

struct PlierScan {
  LabelledPoints seen;  // meshes 0 and 1: levers 1 and 2
  Transform X_CL;       // lever 1
  double opening;
};

std::vector<PlierScan> ScanPlier(const PlierStudy& study);

}  // namespace tact::perception
