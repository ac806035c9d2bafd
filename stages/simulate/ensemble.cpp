#include "stages/simulate/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/files/sha256.hpp"
#include "core/math/random_stream.hpp"
#include "core/math/rotation.hpp"
#include "core/math/seed.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/physics/model.hpp"
#include "core/store/fingerprint.hpp"

namespace morphe::simulate {
namespace {

double sample_value(math::RandomStream& random, double value, const std::optional<Range>& range) {
  if (!range) return value * random.uniform(1 - kVariationShare, 1 + kVariationShare);
  return range->from * std::exp(random.uniform(0, 1) * std::log(range->to / range->from));
}

}  // namespace

Variation variation_of(const PreparedPlan& plan, const SimulateOptions& options,
                       const std::string& name, std::ptrdiff_t k) {
  Variation variation{options.friction, options.torsional_friction_m, options.mass_kg,
                      plan.base_from_target};
  if (k == 0) return variation;
  math::RandomStream random(math::seed_from(options.seed, name, k), "simulate");
  const double friction = sample_value(random, options.friction, options.friction_range);
  variation.torsional_friction_m *= friction / variation.friction;
  variation.friction = friction;
  variation.mass_kg = sample_value(random, options.mass_kg, options.mass_range);
  const Eigen::Matrix3d plane =
      math::shortest_rotation(Vec3::UnitZ(), plan.world.up).toRotationMatrix();
  const double right = random.uniform(-kTargetShift_m, kTargetShift_m);
  const double forward = random.uniform(-kTargetShift_m, kTargetShift_m);
  const double angle = random.uniform(-kTargetTurn_deg, kTargetTurn_deg) * kRadPerDegree;
  variation.base_from_target.linear() =
      Eigen::AngleAxisd(angle, plan.world.up) * plan.base_from_target.linear();
  variation.base_from_target.translation() += right * plane.col(0) + forward * plane.col(1);
  return variation;
}

std::size_t PlanResult::held_count() const {
  return std::ranges::count_if(rollouts, [](const Rollout& r) { return r.lift.is_held(); });
}

PlanResult simulate_plan(const robot::Robot& robot, const Plan& plan, const std::string& name,
                         const SimulateOptions& options) {
  const PreparationResult prepared = prepare(robot, plan, options);
  PlanResult result;
  result.plan = name;
  result.plan_sha256 = store::fingerprint(robot, plan);
  result.skip_reason = prepared.skip_reason;
  result.detail = prepared.detail;
  result.notes = prepared.notes;
  if (prepared.skip_reason != SkipReason::none) return result;
  result.finger_forces = prepared.plan.squeeze.finger_forces;
  for (const FingerForce& press : result.finger_forces)
    result.tips.push_back(robot.tips[press.tip].name);
  result.contact_source =
      prepared.plan.squeeze.is_planned ? ContactSource::planned : ContactSource::nearest;
  result.force_scale = prepared.plan.squeeze.force_scale;
  result.planned_contact_s = prepared.plan.planned_contact_s;
  result.rollouts.resize(options.rollouts);
  parallel::for_each_index(result.rollouts.size(), [&](std::size_t k) {
    const bool directions = options.load_directions == Directions::every ||
                            (options.load_directions == Directions::first && k == 0);
    result.rollouts[k] =
        roll_out(prepared.plan, variation_of(prepared.plan, options, name, k), options, directions);
  });
  return result;
}

std::string result_key(const RobotModel& robot, const Plan& plan, const SimulateOptions& options,
                       const std::string& program) {
  return files::sha256(store::fingerprint(robot, plan) + text_of(options) +
                       physics::engine_version() + program);
}

}  // namespace morphe::simulate
