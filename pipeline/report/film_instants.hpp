#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

inline constexpr int kFilmPoses = 5;

/// A time at which a filmstrip shows a movement.
struct FilmInstant {
  double time_s, demonstration_s;
  std::size_t row;    ///< of the motion, or without one of the goals
  std::string words;  ///< "grasp", "worst" or ""
};

/// Equal times from the first to the last sample; the inner one that is nearest to what matters
/// most (the worst instant, or the grasp) is put there.
std::vector<FilmInstant> film_instants(const Plan& plan, const PlanView& view);

/// The motion that follows the goals, null if nothing was planned.
const ShownMotion* goal_motion(const PlanView& view);

/// Row with the time nearest to x.
std::size_t row_near(const std::vector<double>& times, double x);

}  // namespace morphe::report
