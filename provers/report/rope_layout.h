/// @file
/// A drawing of a rope made readable: strands of even spacing that bend gently, without changing what crosses what.
/// Model   Nodes on the rope, those of intersections passed twice, and the edges between them, planar from the start. Forces: springs
///         along the edges, nodes push nodes and edges away, and each node is drawn toward the middle of its neighbours on the
///         rope. No node moves, toward an edge that it does not end, by more than a third of its distance from it, nor that edge toward
///         the node; so a line always parts the two and no strand is crossed [after Bertault 2000, Simonetto et al. 2011]. Long
///         edges get nodes, superfluous nodes go.
/// Exact   no: doubles; what is drawn must be read back.
/// Units   an edge wants the length 1.
/// Cost    O(nodes^2) a round, some hundred rounds: 0.1 to 0.5 s at 30 intersections.
#pragma once

#include <vector>

namespace tact::provers {

struct LayoutPoint {
  double x = 0, y = 0;
};

struct RopeLayout {
  std::vector<LayoutPoint> nodes;
  std::vector<int> rope;   // nodes along the rope, from its selective end
  std::vector<int> place;  // of column i in `rope`, at index i - 1
};

RopeLayout Relax(RopeLayout layout);

}  // namespace tact::provers
