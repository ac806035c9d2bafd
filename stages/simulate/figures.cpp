#include "stages/simulate/figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/math/statistics.hpp"

namespace morphe::simulate {
namespace {

std::vector<double> each(const PlanResult& result,
                         const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.failure != Failure::engine) values.push_back(of(one));
  }
  return values;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? kNotSeen : *std::ranges::max_element(values);
}

double middle(std::vector<double> values) {
  return values.empty() ? kNotSeen : math::median(values);
}

double median_of_held(const PlanResult& result, const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.held()) values.push_back(of(one));
  }
  return middle(std::move(values));
}

}  // namespace

Figures figures_of(const PlanResult& result) {
  Figures figures;
  figures.held = result.held();
  for (const Rollout& one : result.rollouts) {
    if (!one.lift.held()) ++figures.failures[std::string(name_of(one.lift.failure))];
    figures.foretold.add(one, one.lift);
    figures.directions += one.directions.size();
    for (const Holding& holding : one.directions) {
      figures.directions_held += holding.held() ? 1U : 0U;
      if (!holding.held()) ++figures.direction_failures[std::string(name_of(holding.failure))];
    }
  }
  figures.sag_m = median_of_held(result, [](const Rollout& r) { return r.lift.sag.distance_m; });
  figures.slip_m = median_of_held(result, [](const Rollout& r) { return r.lift.slip_m; });
  figures.creep_m =
      median_of_held(result, [](const Rollout& r) { return r.lift.creep.distance_m; });
  figures.arm_error = largest(each(result, [](const Rollout& r) { return r.arm_error; }));
  figures.hand_error = largest(each(result, [](const Rollout& r) { return r.hand_error; }));
  figures.torque_share = largest(each(result, [](const Rollout& r) { return r.torque_share; }));
  figures.needed_N = middle(each(result, [](const Rollout& r) { return r.lift.needed_N; }));
  figures.given_N = middle(each(result, [](const Rollout& r) { return r.given_N; }));
  std::vector<double> late;
  for (const Rollout& one : result.rollouts) {
    if (std::isfinite(one.contact_s)) late.push_back(one.contact_s - result.planned_contact_s);
  }
  figures.contact_s = middle(std::move(late));
  return figures;
}

}  // namespace morphe::simulate
