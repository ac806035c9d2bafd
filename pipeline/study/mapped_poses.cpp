#include "pipeline/study/mapped_poses.hpp"

#include <cmath>

#include "core/collision/world.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/study.hpp"
#include "stages/map/finger_curve.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::study {
namespace {

humanlike::FrameObjective objective_of(const StudyWeights& weights) {
  humanlike::FrameObjective objective;
  objective.get<humanlike::TipPosition>().weight = weights.tip_position;
  objective.get<humanlike::TipOrientation>() = {weights.tip_orientation, 1e-5};
  objective.get<humanlike::JointDistance>().weight = weights.humanlike;
  return objective;
}

template <class T>
void append_moved(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Appends the errors and metric A at q.
void append_measures(const robot::Robot& robot, const humanlike::FrameGoal& goal,
                     const JointVector& q, MappedPoses& mapped) {
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, q, frames);
  double position = 0, orientation = 0;
  int positions = 0, orientations = 0;
  for (int i = 0; i < std::ssize(robot.tips); ++i) {
    const Pose tip = robot::tip_pose(robot, frames, i);
    if (is_known(goal.tip_position[i])) {
      position += (tip.translation() - goal.tip_position[i]).norm();
      ++positions;
    }
    if (is_known(goal.tip_orientation[i])) {
      orientation += angle_between(Quat(tip.linear()), goal.tip_orientation[i]);
      ++orientations;
    }
  }
  mapped.position_m.push_back(positions == 0 ? kUnknown : position / positions);
  mapped.orientation_rad.push_back(orientations == 0 ? kUnknown : orientation / orientations);
  const std::vector<Vec3> centres = robot::arm_centre_positions(robot, frames);
  mapped.humanlike_m2.push_back(centres.empty() || !is_known(goal.elbow)
                                    ? kUnknown
                                    : humanlike::joint_distance_sum(goal.elbow, centres) /
                                          static_cast<double>(centres.size()));
}

}  // namespace

void MappedPoses::append(MappedPoses&& other) {
  append_moved(q, std::move(other.q));
  append_moved(position_m, std::move(other.position_m));
  append_moved(orientation_rad, std::move(other.orientation_rad));
  append_moved(humanlike_m2, std::move(other.humanlike_m2));
  append_moved(objective, std::move(other.objective));
  seconds += other.seconds;
  solves += other.solves;
}

std::vector<humanlike::FrameGoal> goals_of(const robot::Robot& robot, const HumanPoses& poses,
                                           const Pose& base_from_shoulder) {
  std::vector<humanlike::FrameGoal> goals;
  const Quat turn(base_from_shoulder.linear());
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, (robot.lower + robot.upper) / 2, frames);
  const Vec3 shift = frames[robot.shoulder_frame].translation() - base_from_shoulder.translation();
  for (const HumanPose& pose : poses) {
    humanlike::FrameGoal goal;
    goal.elbow = base_from_shoulder * pose.elbow + shift;
    for (const RobotModel::Tip& tip : robot.tips) {
      Vec3 position = pose.wrist;
      if (tip.finger >= 0) position = pose.tip[tip.finger];
      if (std::isfinite(tip.finger_curve_share))
        position = map::finger_curve_point({pose.tip[1], pose.tip[2], pose.tip[3], pose.tip[4]},
                                           tip.finger_curve_share);
      goal.tip_position.push_back(base_from_shoulder * position);
      goal.tip_orientation.push_back(tip.finger < 0 ? Quat(turn * pose.hand) : unknown_rotation());
    }
    goals.push_back(std::move(goal));
  }
  return goals;
}

MappedPoses map_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                      const StudyWeights& weights, const solve::MinimiseOptions& options,
                      int starts, std::uint64_t seed) {
  constexpr int kKeyFrameCount = 3, kKeptMinimaCount = 4;
  const collision::CollisionWorld empty_world = collision::make_world(robot, {}, {}, {});
  map::MappingProblem problem;
  problem.robot = &robot;
  problem.objective = objective_of(weights);
  problem.clearance.weight = 0;
  problem.world = &empty_world;
  problem.goals = goals;
  const std::ptrdiff_t count = std::ssize(goals);
  for (int f = 0; f < count; ++f) problem.time.push_back(f);

  MappedPoses best;
  best.q.resize(count);
  best.objective.assign(count, kInfinity);
  map::MappingScratch scratch;
  const auto keep_if_better = [&](std::ptrdiff_t frame, const solve::Minimum& minimum) {
    if (!(minimum.value < best.objective[frame])) return;
    best.objective[frame] = minimum.value;
    best.q[frame] = minimum.x;
  };
  const auto follow = [&](std::ptrdiff_t frame, std::ptrdiff_t end, int step, JointVector q) {
    best.seconds += measure_seconds([&] {
      while (frame != end) {
        frame += step;
        const solve::Minimum minimum = map::solve_frame(problem, frame, q, options, scratch);
        keep_if_better(frame, minimum);
        q = minimum.x;
        ++best.solves;
      }
    });
  };
  for (int k = 0; k < kKeyFrameCount; ++k) {
    const std::ptrdiff_t key_frame = (count - 1) * k / (kKeyFrameCount - 1);
    for (const solve::Minimum& start : map::search_frame(
             problem, key_frame, starts, kKeptMinimaCount, map::thorough_stages(options),
             math::seed_from(seed, "key frame", k), scratch)) {
      keep_if_better(key_frame, start);
      follow(key_frame, count - 1, 1, start.x);
      follow(key_frame, 0, -1, start.x);
    }
  }
  for (int f = 0; f < count; ++f) append_measures(robot, goals[f], best.q[f], best);
  return best;
}

MappedPoses measure_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                          const std::vector<JointVector>& q) {
  MappedPoses mapped;
  mapped.q = q;
  for (int f = 0; f < std::ssize(goals); ++f) append_measures(robot, goals[f], q[f], mapped);
  return mapped;
}

}  // namespace morphe::study
