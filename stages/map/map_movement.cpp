#include "stages/map/map_movement.hpp"

#include <algorithm>

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/finger_curve.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/map/nearest_errors.hpp"
#include "stages/map/reachability.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
constexpr double kMetTolerance_m = 1e-3;  ///< tip error below which a frame's goal is met [m]

void measure_humanlikeness(const MappingProblem& problem, const Goals& goals, std::size_t frame,
                           const std::vector<Pose>& base_from_frame, MappingResult& mapped) {
  const auto row = static_cast<Index>(frame);
  mapped.humanlikeness.row(row).setConstant(kUnknown);
  const humanlike::Chain human{goals.shoulder_position[frame], goals.elbow_position[frame],
                               goals.wrist_position[frame]};
  if (!is_known(human[0]) || !is_known(human[1]) || !is_known(human[2])) return;
  const humanlike::Chain robot = humanlike::arm_chain(*problem.robot, base_from_frame).joints;
  const std::vector<Vec3> inner = robot::arm_centre_positions(*problem.robot, base_from_frame);
  mapped.humanlikeness(row, 0) = humanlike::joint_distance_sum(human[1], inner);
  mapped.humanlikeness(row, 1) = humanlike::triangle_area_sum(human, robot);
  mapped.humanlikeness(row, 2) = humanlike::hull_volume_sum(human, robot);
}

void measure_frame(const MappingProblem& problem, const Goals& goals, std::size_t frame,
                   MappingScratch& scratch, MappingResult& mapped) {
  const auto row = static_cast<Index>(frame);
  const JointVector q = mapped.position.row(row).transpose();
  const humanlike::FrameGoal goal = humanlike::frame_goal(goals, frame);
  scratch.model.reset(q.size());
  add_frame_objective(problem, frame, q, scratch, scratch.model);
  mapped.objective.push_back(scratch.model.value);
  bool any = false, met = true, reachable = true;
  for (std::size_t i = 0; i < goal.tip_position.size(); ++i) {
    const Pose tip = robot::tip_pose(*problem.robot, scratch.base_from_frame, i);
    const auto col = static_cast<Index>(i);
    if (is_known(goal.tip_orientation[i])) {
      mapped.tip_orientation_error(row, col) =
          angle_between(Quat(tip.linear()), goal.tip_orientation[i]);
    }
    if (!is_known(goal.tip_position[i])) continue;
    any = true;
    const Vec3 at = robot::tracked_point(*problem.robot, scratch.base_from_frame, i,
                                         goal.tip_to_pad_share_of(i));
    const double error = (at - goal.tip_position[i]).norm();
    mapped.tip_error(row, col) = error;
    met = met && error < kMetTolerance_m;
    reachable = reachable && goals.reachable(frame, i);
  }
  mapped.status.push_back(!any        ? FrameStatus::no_goal
                          : met       ? FrameStatus::met
                          : reachable ? FrameStatus::compromise
                                      : FrameStatus::out_of_reach);
  measure_humanlikeness(problem, goals, frame, scratch.base_from_frame, mapped);
}

MappingResult measure(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  const auto frames = q.rows();
  const auto tips = static_cast<Index>(goals.tip_position.cols);
  MappingResult mapped;
  mapped.position = q;
  mapped.tip_error = JointRows::Constant(frames, tips, kUnknown);
  mapped.tip_orientation_error = JointRows::Constant(frames, tips, kUnknown);
  mapped.humanlikeness = JointRows::Constant(frames, 3, kUnknown);
  MappingScratch scratch;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    measure_frame(problem, goals, f, scratch, mapped);
  }
  return mapped;
}

double posture_error(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  double sum = 0;
  int count = 0;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const double error = problem.objective.get<humanlike::NaturalPosture>().distance(
        q.row(f).transpose(), humanlike::frame_goal(goals, f));
    if (std::isnan(error)) continue;
    sum += error * error;
    ++count;
  }
  return count == 0 ? kUnknown : std::sqrt(sum / count);
}

/// Returns goals for the middle joints of fingers between the human's, by the rule of their tips.
std::vector<Vec3> curve_joints(const robot::Robot& robot, const Goals& goals, std::size_t frame) {
  const auto joint = [&](std::size_t finger) { return goals.finger_joint_position(frame, finger); };
  std::vector<Vec3> points(robot.tips.size(), unknown_point());
  for (std::size_t tip = 0; tip < points.size(); ++tip) {
    const double along = robot.tips[tip].finger_curve_share;
    if (!std::isfinite(along)) continue;
    points[tip] = finger_curve_point({joint(1), joint(2), joint(3), joint(4)}, along);
  }
  return points;
}

/// Returns the problem with the goals of the tips, by which reachability is evaluated in every
/// mode.
MappingProblem with_tip_goals(const MappingProblem& problem, const Goals& goals) {
  MappingProblem tracked = problem;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    tracked.goals[f] = humanlike::frame_goal(goals, f);
  }
  return tracked;
}

MapResult make_result(const MappingProblem& problem, const MappingProblem& tracked, Goals& goals,
                      const JointRows& q, const MapOptions& options, std::uint64_t seed) {
  const std::vector<bool> reachable = reachable_frames(
      tracked, q, {options.reach_search_starts, options.reach_tolerance_m, options.frame_solver},
      math::seed_from(seed, "reachable"));
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    for (std::size_t i = 0; i < goals.reachable.cols; ++i) goals.reachable(f, i) = reachable[f];
  }
  MapResult result;
  result.mapped = measure(problem, goals, q);
  result.mapped.least_attainable_error =
      nearest_errors(tracked, q, reachable, options.frame_solver);
  result.posture_error_rad = posture_error(problem, goals, q);
  result.path = {q, std::vector<SampleOrigin>(problem.frames(), SampleOrigin::mapped),
                 problem.time};
  return result;
}

}  // namespace

MappingProblem make_mapping_problem(const robot::Robot& robot, const Goals& goals,
                                    const collision::CollisionWorld& world,
                                    const MapOptions& options, const std::vector<Phase>& phases) {
  MappingProblem problem;
  problem.robot = &robot;
  problem.objective = make_objective(options, robot);
  problem.clearance = options.clearance;
  problem.world = &world;
  problem.time = goals.time;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    problem.goals.push_back(humanlike::frame_goal(goals, f));
    problem.goals.back().interpolated_finger_joint = curve_joints(robot, goals, f);
    problem.goals.back().weights =
        weights_at(options.phases, phases, goals.time[f], options.phase_blend_s);
  }
  return problem;
}

Outcome<MapResult> map_movement(const MappingProblem& problem, Goals& goals,
                                const MapOptions& options, std::uint64_t seed) {
  const MappingProblem tracked = with_tip_goals(problem, goals);
  const bool any_goal =
      std::any_of(tracked.goals.begin(), tracked.goals.end(),
                  [](const humanlike::FrameGoal& goal) { return goal.goal_tip_count() > 0; });
  if (problem.frames() < 5 || !any_goal) {
    return {{},
            {Reason::no_goal, any_goal ? "the movement has fewer than 5 frames"
                                       : "no fingertip was seen in the whole movement"}};
  }
  const std::vector<CandidatePath> courses = search_movement(problem, options, seed);
  MapResult result = make_result(problem, tracked, goals, courses.front().q, options, seed);
  for (std::size_t i = 1; i < courses.size(); ++i) result.candidates.push_back(courses[i].q);
  return {std::move(result), {}};
}

MapResult evaluate_path(const MappingProblem& problem, Goals& goals, const JointRows& q,
                        const MapOptions& options, std::uint64_t seed) {
  return make_result(problem, with_tip_goals(problem, goals), goals, q, options, seed);
}

}  // namespace morphe::map
