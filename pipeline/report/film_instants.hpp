#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// The number of poses in a filmstrip.
inline constexpr int kFilmPoseCount = 5;

/// An instant at which a filmstrip shows a movement.
struct FilmInstant {
  /// The time in the motion and in the demonstration [s].
  double time_s, demonstration_s;
  /// Row of the motion, or of the goals if there is no motion.
  std::size_t row;
  /// Caption "grasp", "worst" or "".
  std::string caption;
};

/// Selects instants at equal intervals from the first to the last sample. The inner one nearest to
/// the most relevant instant (the worst instant, or the grasp) is moved there.
std::vector<FilmInstant> film_instants(const Plan& plan, const PlanView& view);

/// Returns the motion that follows the goals, null if no motion was planned.
const DisplayMotion* goal_motion(const PlanView& view);

/// Returns the row with the time nearest to x.
std::size_t nearest_row(const std::vector<double>& times, double x);

}  // namespace morphe::report
