#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/cover/cover.hpp"
#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

struct LinkCapsules {
  int frame = -1;
  std::vector<RobotTable::Capsule> capsules;
  cover::CoverFigures figures;
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
