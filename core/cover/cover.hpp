#pragma once

#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/scene.hpp"

namespace morphe::cover {

/// How well capsules stand for a surface, on samples of its area that they were not made from.
struct CoverFigures {
  double coverage = 1;           ///< share of the surface inside
  double largest_gap_m = 0;      ///< how far any of it is outside
  double standoff_median_m = 0;  ///< of the capsules' own outer surface from the body
  double standoff_95_m = 0;
  double near_share = 1;  ///< of that within 5 mm of the body
};

struct Cover {
  std::vector<collision::CapsuleBody> capsules;
  CoverFigures figures;
};

/// At most `budget` capsules that hold the bodies' surface, as close to it as that many come.
/// Begins with the segments between points inside that, widened by one growth for all, cover most
/// of what is left, one after the other, with the least growth for which the budget suffices; then
/// moves their ends, each surface point staying with the capsule that it is deepest in, as long as
/// what stands off becomes less; where budget is left, the worst are split and moved again. Bodies
/// that are balls and capsules are kept as they are if they fit. Nothing that is sampled is left
/// out: gaps lie between samples. `name` seeds the sampling.
Cover cover_bodies(const std::vector<SceneObject>& bodies, int budget, const std::string& name);

}  // namespace morphe::cover
