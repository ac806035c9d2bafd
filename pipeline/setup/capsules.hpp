#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/cover/fit_capsules.hpp"
#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// The capsules of one link.
struct LinkCapsules {
  /// The index of the frame.
  int frame = -1;
  /// The capsules, in the frame.
  std::vector<RobotModel::Capsule> capsules;
  /// The quality of the fit.
  cover::FitQuality figures;
  /// The certainty of the capsules.
  Provenance sure = Provenance::derived;
};

/// The maximum number of capsules of a link.
struct CapsuleBudget {
  /// The budgets by kind of link; `wrist` is for the outer half of the arm.
  int arm = 6, wrist = 8, palm = 12, finger = 4;
};

/// Covers every link with capsules, fitted to its shapes. A link without shapes that extends from
/// one joint to the next is given a bone whose thickness follows from its inertia (assumed),
/// because it would not be checked otherwise.
std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget);

}  // namespace morphe::setup
