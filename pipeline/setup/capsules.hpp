#pragma once

#include <functional>
#include <string>
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
  double aim_m = 0;      ///< standoff that was sought, 0 for the closest within the budget
  int tip_capsules = 0;  ///< the last so many reach from the shapes to a fingertip
};

/// The maximum number of capsules of a link, by its kind; `wrist` is the outer half of the arm, and
/// `near` is for links that come near others at rest (clear_covers.hpp). A gripper has few links,
/// and its jaws touch the object: with 8 instead of 4 capsules on the links of the Robotiq 2F-85,
/// three of five plans need no repair any more, another becomes feasible, and the tips are up
/// to 1.1 instead of 4.5 mm off in the grasp, because the covers of the jaws no longer stand in the
/// cup.
struct CapsuleBudget {
  int arm = 6, wrist = 8, palm = 160, finger = 4, jaw = 8, near = 64;
};
/// Largest standoff that is sought for a palm, beside which all fingers move, so that 95 % of its
/// capsules' surface is within 3 mm, grid and margin included; others get all of their budget.
inline constexpr double kPalmStandoff_m = 0.0025;

/// Returns the capsules of a fit.
std::vector<RobotModel::Capsule> capsules_of(const cover::CapsuleFit& fit);

/// Covers every link with capsules, fitted to its shapes. A link without shapes between two joints
/// would not be checked for collisions: it gets a capsule from joint to joint, of a thickness that
/// follows from its inertia (assumed). `arm` are the moving frames of the arm; `hand` may be null.
/// `progress`, which may be empty, is called after each link that has shapes, of which `jobs` are
/// covered at once; their number does not change the result.
std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget,
                                      int jobs,
                                      const std::function<void(const std::string&)>& progress);

}  // namespace morphe::setup
