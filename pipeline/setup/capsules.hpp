#pragma once

#include <vector>

#include "core/cover/fit_capsules.hpp"
#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// The capsules of one link.
struct LinkCapsules {
  int frame = -1;
  std::vector<RobotModel::Capsule> capsules;  ///< in the frame
  cover::FitQuality figures;                  ///< how well the capsules fit the shapes
  Provenance sure = Provenance::derived;
};

/// The maximum number of capsules of a link, by its kind; `wrist` is the outer half of the arm.
struct CapsuleBudget {
  int arm = 6, wrist = 8, palm = 12, finger = 4;
};

/// Covers every link with capsules, fitted to its shapes. A link without shapes between two joints
/// would not be checked for collisions: it gets a capsule from joint to joint, of a thickness that
/// follows from its inertia (assumed). `arm` are the moving frames of the arm; `hand` may be null.
std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget);

}  // namespace morphe::setup
