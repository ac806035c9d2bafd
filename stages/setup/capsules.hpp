#pragma once

#include <map>
#include <string>
#include <vector>

#include "stages/setup/hand_frames.hpp"
#include "stages/setup/shapes.hpp"

namespace morphe::setup {

/// How well a link's capsules stand for its shapes.
struct CoverFigures {
  int capsules = 0;
  double coverage = 1;                              ///< share of the surface inside
  double largest_gap_m = 0;                         ///< how far any of it is outside
  double standoff_median_m = 0, standoff_95_m = 0;  ///< capsules' surface from the link's
};

struct LinkCapsules {
  int frame = -1;
  std::vector<RobotTable::Capsule> capsules;
  CoverFigures figures;
  Sure sure = Sure::derived;
};

/// How many capsules a link may have.
struct CapsuleBudget {
  int arm = 6, wrist = 8, palm = 12, finger = 4;
};

/// Capsules of every link: of its shapes; of one that has none but reaches from one joint to the
/// next, a bone as thick as its inertia says (assumed), since nothing else would be checked.
std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget);

}  // namespace morphe::setup
