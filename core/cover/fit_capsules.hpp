#pragma once

#include <string>
#include <vector>

#include "core/collision/distance.hpp"
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

/// Fits at most `budget` capsules that enclose the surface of the bodies as closely as possible. It
/// first chooses segments between interior points greedily. Each covers, after widening all by the
/// same growth, most of the points that remain; the growth is the smallest for which the budget
/// suffices. Then it moves their ends as long as the distance of the capsules' surface from the
/// body decreases, with each surface point assigned to the capsule in which it is deepest. If
/// budget remains, the worst capsules are split and moved again. Bodies that are all spheres and
/// capsules are kept exactly if they fit into the budget. Gaps can only be between the samples of
/// the surface. `name` seeds the sampling; without a surface there are no capsules.
CapsuleFit fit_capsules(const std::vector<SceneObject>& bodies, int budget,
                        const std::string& name);

}  // namespace morphe::cover
