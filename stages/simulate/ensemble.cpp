#include "stages/simulate/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/files/sha256.hpp"
#include "core/math/random_stream.hpp"
#include "core/math/rotation.hpp"
#include "core/math/seed.hpp"
#include "core/parallel/ordered_map.hpp"
#include "core/physics/model.hpp"
#include "core/store/fingerprint.hpp"

namespace morphe::simulate {

namespace {

double drawn(math::RandomStream& random, double value, const std::optional<Range>& range) {
  if (!range) return value * random.uniform(1 - kFactor, 1 + kFactor);
  return range->from * std::exp(random.uniform(0, 1) * std::log(range->to / range->from));
}

}  // namespace

Variation variation_of(const PreparedPlan& plan, const SimulateOptions& options,
                       const std::string& name, int k) {
  Variation variation{options.friction, options.torsion_m, options.mass_kg, plan.base_from_target};
  if (k == 0) return variation;
  math::RandomStream random(math::seed_from(options.seed, name, static_cast<std::size_t>(k)),
                            "simulate");
  const double friction = drawn(random, options.friction, options.friction_range);
  variation.torsion_m *= friction / variation.friction;
  variation.friction = friction;
  variation.mass_kg = drawn(random, options.mass_kg, options.mass_range);
  const Eigen::Matrix3d plane =
      math::shortest_rotation(Vec3::UnitZ(), plan.world.up).toRotationMatrix();
  const double right = random.uniform(-kShift_m, kShift_m);
  const double forward = random.uniform(-kShift_m, kShift_m);
  const double turn = random.uniform(-kTurn_deg, kTurn_deg) * kDegree;
  variation.base_from_target.linear() =
      Eigen::AngleAxisd(turn, plan.world.up) * plan.base_from_target.linear();
  variation.base_from_target.translation() += right * plane.col(0) + forward * plane.col(1);
  return variation;
}

std::size_t PlanResult::held() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(rollouts, [](const Rollout& one) { return one.lift.held(); }));
}

PlanResult simulate_plan(const robot::Robot& robot, const Plan& plan, const std::string& name,
                         const SimulateOptions& options) {
  const Prepared prepared = prepare(robot, plan, options);
  PlanResult result;
  result.plan = name;
  result.plan_sha256 = store::fingerprint(robot, plan);
  result.unfit = prepared.unfit;
  result.detail = prepared.detail;
  result.notes = prepared.notes;
  if (prepared.unfit != Unfit::none) return result;
  result.presses = prepared.plan.squeeze.presses;
  for (const Press& press : result.presses) result.tips.push_back(robot.tips[press.tip].name);
  result.planned_squeeze = prepared.plan.squeeze.planned;
  result.force_share = prepared.plan.squeeze.force_share;
  result.planned_contact_s = prepared.plan.planned_contact_s;
  result.rollouts.resize(static_cast<std::size_t>(options.ensemble));
  parallel::for_each_index(result.rollouts.size(), [&](std::size_t k) {
    const bool directions = options.directions == Directions::every ||
                            (options.directions == Directions::first && k == 0);
    result.rollouts[k] =
        roll_out(prepared.plan, variation_of(prepared.plan, options, name, static_cast<int>(k)),
                 options, directions);
  });
  return result;
}

std::string key_of(const RobotTable& robot, const Plan& plan, const SimulateOptions& options,
                   const std::string& program) {
  return files::sha256(store::fingerprint(robot, plan) + text_of(options) + physics::engine() +
                       program);
}

}  // namespace morphe::simulate
