#include "pipeline/report/film_instants.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::report {

const DisplayMotion* goal_motion(const PlanView& view) {
  for (const DisplayMotion& motion : view.motions) {
    if (motion.name != "approach" && motion.name != "retreat" && !motion.time.empty())
      return &motion;
  }
  return nullptr;
}

std::ptrdiff_t nearest_row(const std::vector<double>& times, double time_s) {
  const auto distance = [&](double time) { return std::abs(time - time_s); };
  return std::ranges::min_element(times, {}, distance) - times.begin();
}

std::vector<FilmInstant> film_instants(const Plan& plan, const PlanView& view) {
  const DisplayMotion* motion = goal_motion(view);
  const std::vector<double>& times = motion ? motion->time : plan.goals.time;
  const std::vector<double>& demonstration = motion ? motion->demonstration_time : plan.goals.time;
  std::vector<FilmInstant> instants;
  if (times.empty()) return instants;
  for (int k = 0; k < kFilmPoseCount; ++k) {
    const double share = k / (kFilmPoseCount - 1.0);
    const std::ptrdiff_t row =
        nearest_row(times, times.front() + share * (times.back() - times.front()));
    instants.push_back({times[row], demonstration[row], row, ""});
  }
  double event_s = kUnknown;
  std::string caption;
  if (view.worst) {
    event_s = view.worst->demonstration_s;
    caption = "worst";
  } else if (const Phase* grasp = last_phase(plan.movement, PhaseKind::grasp)) {
    event_s = grasp->begin_s;
    caption = "grasp";
  }
  if (std::isnan(event_s)) return instants;
  const std::ptrdiff_t row = nearest_row(demonstration, event_s);
  int nearest = 1;
  for (int k = 1; k + 1 < kFilmPoseCount; ++k) {
    if (std::abs(instants[k].time_s - times[row]) < std::abs(instants[nearest].time_s - times[row]))
      nearest = k;
  }
  if (row == instants.front().row) nearest = 0;
  if (row == instants.back().row) nearest = kFilmPoseCount - 1;
  instants[nearest] = {times[row], demonstration[row], row, caption};
  return instants;
}

}  // namespace morphe::report
