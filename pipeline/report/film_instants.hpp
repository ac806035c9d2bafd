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
  double time_s = 0, demonstration_s = 0;  ///< time in the motion and in the recording
  std::ptrdiff_t row = 0;                  ///< of the motion, or of the goals if there is no motion
  std::string caption;                     ///< "grasp", "worst" or ""
};

/// Selects kFilmPoseCount instants at equal intervals from the first to the last sample. One of
/// them is moved to the worst instant or, without one, to the begin of the grasp: the nearest of
/// the inner ones, or an end if it is there. Returns no instants without a motion and goals.
std::vector<FilmInstant> film_instants(const Plan& plan, const PlanView& view);

/// Returns the motion that follows the goals, null if no motion was planned.
const DisplayMotion* goal_motion(const PlanView& view);

/// Returns the index of the time nearest to time_s; `times` must not be empty.
std::ptrdiff_t nearest_row(const std::vector<double>& times, double time_s);

}  // namespace morphe::report
