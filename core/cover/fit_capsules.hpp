#pragma once

#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/cover/surface.hpp"
#include "core/motion/scene.hpp"

namespace morphe::cover {

/// The quality of a capsule fit, on samples of the surface that were not used for fitting.
struct FitQuality {
  double coverage = 1;           ///< share of the surface that is inside the capsules
  double largest_gap_m = 0;      ///< largest distance of the surface outside the capsules
  double standoff_median_m = 0;  ///< median distance of the capsules' outer surface from the body
  double standoff_95_m = 0;      ///< its 95 % quantile
  double near_share = 1;         ///< share of the outer surface within 5 mm of the body
};

/// Capsules that enclose a surface, and their quality.
struct CapsuleFit {
  std::vector<collision::CapsuleBody> capsules;
  FitQuality quality;
};

/// The requested closeness of a fit.
struct FitOptions {
  int budget = 1;  ///< largest number of capsules
  /// Standoff with which the fewest capsules are taken; a closer fit is not sought.
  double aim_m = 0;
  std::vector<Triangle> nearby = {};  ///< surfaces that the capsules should stay clear of
  double gap_m = 0;                   ///< between the body and these surfaces
  double clearance_m = 0;             ///< from capsules that stay clear of this body likewise
};

/// Bodies that are all boxes, cylinders and spheres are covered in closed form
/// (cover_primitives.hpp), if there are not more of them than capsules and no surface is nearby.
/// Otherwise fits at most `budget` capsules that enclose bodies, their surface and their inside, as
/// closely as possible. None stands off the bodies by more than a common growth: the aim or, if the
/// budget does not suffice for it, the least for which it does (choose_segments.hpp); in the latter
/// case the ends are then moved as long as the mean square standoff decreases. Capsules also stay
/// nearer to the bodies than to the surfaces nearby, if the budget suffices for that. Bodies that
/// are all spheres and capsules are kept exactly if they fit into the budget. Gaps can only be
/// between the samples of the surface. `name` seeds the sampling; without a surface there are no
/// capsules.
CapsuleFit fit_capsules(const std::vector<SceneObject>& bodies, const FitOptions& options,
                        const std::string& name);

}  // namespace morphe::cover
