#include "stages/map/clearance_term.hpp"

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::map {
namespace {

/// Returns the frame that moves a body of a pair: that of a capsule, or to which a target is
/// attached; -1 for other objects.
int frame_of(const collision::CollisionWorld& world, bool is_object, int body, double time_s) {
  if (!is_object) return world.robot->capsules[body].frame;
  const bool attached = body == world.target && collision::target_state_at(world, time_s) ==
                                                    collision::TargetState::attached;
  return attached ? world.attached.frame : -1;
}

/// Computes the gradient of band - slack: positive for joints that bring the bodies nearer.
void missing_slack_gradient(const collision::CollisionWorld& world, double time_s,
                            const collision::PairSeparation& pair,
                            const std::vector<Pose>& base_from_frame, JointVector& slope) {
  const RobotModel& robot = *world.robot;
  const int first = frame_of(world, pair.first_is_object, pair.first, time_s);
  const int second = frame_of(world, pair.other_is_object, pair.other, time_s);
  const int common = robot::common_ancestor(robot, first, second);  // its joints move both alike
  const collision::Separation& s = pair.separation;
  slope.setZero();
  robot::add_point_gradient(robot, base_from_frame, first, common, s.on_first, -s.normal, slope);
  robot::add_point_gradient(robot, base_from_frame, second, common, s.on_second, s.normal, slope);
}

}  // namespace

void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world,
                   const JointVector& q, double time_s, ClearanceScratch& scratch,
                   solve::Quadratic& model) {
  if (term.weight == 0) return;
  robot::forward_kinematics(*world.robot, q, scratch.collision.base_from_frame);
  add_clearance(term, world, time_s, scratch, model);
}

void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world, double time_s,
                   ClearanceScratch& scratch, solve::Quadratic& model) {
  if (term.weight == 0) return;
  collision::update_bodies_from_frames(world, time_s, scratch.collision);
  collision::near_pairs(world, time_s, term.activation_distance_m, scratch.collision,
                        scratch.pairs);
  JointVector& slope = scratch.missing_gradient;
  slope.resize(model.gradient.size());
  for (const collision::PairSeparation& pair : scratch.pairs) {
    double band = term.activation_distance_m;
    if (pair.required_distance_m < 0) band = std::min(band, -pair.required_distance_m);
    const double missing_slack_m = band - pair.slack();
    if (missing_slack_m <= 0) continue;
    missing_slack_gradient(world, time_s, pair, scratch.collision.base_from_frame, slope);
    model.value += term.weight * missing_slack_m * missing_slack_m;
    scratch.active_joints.clear();
    for (Eigen::Index j = 0; j < slope.size(); ++j) {
      if (slope[j] != 0) scratch.active_joints.push_back(j);
    }
    for (const Eigen::Index j : scratch.active_joints) {
      model.gradient[j] += 2 * term.weight * missing_slack_m * slope[j];
      const double factor = 2 * term.weight * slope[j];
      for (const Eigen::Index i : scratch.active_joints) model.hessian(i, j) += factor * slope[i];
    }
  }
}

}  // namespace morphe::map
