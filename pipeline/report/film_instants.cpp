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

std::size_t nearest_row(const std::vector<double>& times, double x) {
  const auto nearer = [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); };
  return std::ranges::min_element(times, nearer) - times.begin();
}

std::vector<FilmInstant> film_instants(const Plan& plan, const PlanView& view) {
  const DisplayMotion* motion = goal_motion(view);
  const std::vector<double>& times = motion ? motion->time : plan.goals.time;
  const std::vector<double>& demonstration = motion ? motion->demonstration_time : plan.goals.time;
  std::vector<FilmInstant> instants;
  if (times.empty()) return instants;
  for (int k = 0; k < kFilmPoseCount; ++k) {
    const double share = static_cast<double>(k) / (kFilmPoseCount - 1);
    const std::size_t row =
        nearest_row(times, times.front() + share * (times.back() - times.front()));
    instants.push_back({times[row], demonstration[row], row, ""});
  }
  double matters_s = kUnknown;
  std::string words;
  if (view.worst) {
    matters_s = view.worst->demonstration_s;
    words = "worst";
  } else if (const Phase* grasp = last_phase(plan.movement, PhaseKind::grasp)) {
    matters_s = grasp->begin_s;
    words = "grasp";
  }
  if (std::isnan(matters_s)) return instants;
  const std::size_t row = nearest_row(demonstration, matters_s);
  std::size_t nearest = 1;
  for (std::size_t k = 1; k + 1 < instants.size(); ++k) {
    if (std::abs(instants[k].time_s - times[row]) < std::abs(instants[nearest].time_s - times[row]))
      nearest = k;
  }
  if (row == instants.front().row) nearest = 0;
  if (row == instants.back().row) nearest = instants.size() - 1;
  instants[nearest] = {times[row], demonstration[row], row, words};
  return instants;
}

}  // namespace morphe::report
