#include "stages/simulate/planned_task.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/world.hpp"
#include "stages/simulate/inertias.hpp"
#include "stages/simulate/options.hpp"

namespace morphe::simulate {
namespace {

/// The planned motion of the target along a trajectory.
class TargetMotion {
 public:
  TargetMotion(const robot::Robot& robot, const Plan& plan)
      : trajectory_(plan.trajectory),
        world_(collision::make_world(robot, plan.scene, plan.movement, plan.tolerances)) {
    collision::attach_target(trajectory_.demonstration_time, trajectory_.position, world_);
  }

  Pose pose(Eigen::Index sample) {
    const JointVector q = trajectory_.position.row(sample).transpose();
    collision::update_bodies(world_, q, trajectory_.demonstration_time[sample], scratch_);
    return scratch_.object_poses[world_.target];
  }
  const SceneObject& object() const { return world_.scene->objects[world_.target]; }

 private:
  const Trajectory& trajectory_;
  collision::CollisionWorld world_;
  collision::CollisionScratch scratch_;
};

bool carries_target(const Plan& plan) {
  return std::ranges::any_of(plan.movement.phases, [&](const Phase& phase) {
    return phase.kind == PhaseKind::transport &&
           phase.begin_s < plan.trajectory.demonstration_time.back();
  });
}

/// Returns samples at least kLoadInterval_s apart, from `first` to `last`.
std::vector<Eigen::Index> spaced_samples(const std::vector<double>& time, Eigen::Index first,
                                         Eigen::Index last) {
  std::vector<Eigen::Index> samples{first};
  for (Eigen::Index k = first + 1; k <= last; ++k)
    if (time[k] - time[samples.back()] >= kLoadInterval_s) samples.push_back(k);
  return samples;
}

/// Adds the loads at all samples but the first and the last, by differences of the positions.
void add_loads(const std::vector<double>& time, const std::vector<Pose>& poses, const Vec3& gravity,
               std::vector<CarriedLoad>& loads) {
  for (std::size_t k = 1; k + 1 < poses.size(); ++k) {
    const double before_s = time[k] - time[k - 1], after_s = time[k + 1] - time[k];
    const Vec3 arriving = (poses[k].translation() - poses[k - 1].translation()) / before_s;
    const Vec3 leaving = (poses[k + 1].translation() - poses[k].translation()) / after_s;
    const Vec3 acceleration = 2 * (leaving - arriving) / (before_s + after_s);
    loads.push_back(poses[k].linear().transpose() * (gravity - acceleration));
  }
}

}  // namespace

std::optional<PlannedTask> planned_task(const robot::Robot& robot, const Plan& plan,
                                        Eigen::Index grasp_end, const Vec3& up) {
  const Trajectory& t = plan.trajectory;
  const Eigen::Index last = std::ssize(t.time) - 1;
  if (robot.arm_joints.empty() || !carries_target(plan)) return std::nullopt;
  TargetMotion target(robot, plan);
  const auto first_at = [&](double demonstration_s) {
    return std::isnan(demonstration_s)
               ? last + 1
               : std::ranges::lower_bound(t.demonstration_time, demonstration_s) -
                     t.demonstration_time.begin();
  };
  const Eigen::Index release =
      std::clamp(first_at(target.object().release_s), grasp_end + 1, std::max(last, grasp_end + 1));
  if (release > last) return std::nullopt;

  PlannedTask task;
  task.release_s = t.time[release] - t.time.front();
  task.lets_go = release < last;
  task.base_from_placed = target.pose(release);
  std::vector<double> time;
  std::vector<Pose> poses;
  for (const Eigen::Index sample : spaced_samples(t.time, grasp_end, release)) {
    time.push_back(t.time[sample]);
    poses.push_back(target.pose(sample));
    task.rise_m = std::max(task.rise_m, lowest_height(target.object(), poses.back(), up) -
                                            lowest_height(target.object(), poses.front(), up));
  }
  const Vec3 gravity = -kGravity_m_s2 * up;
  task.loads = {poses.front().linear().transpose() * gravity};
  add_loads(time, poses, gravity, task.loads);
  return task;
}

}  // namespace morphe::simulate
