#include "stages/map/map_movement.hpp"

#include <algorithm>

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/finger_curve.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/map/nearest_errors.hpp"
#include "stages/map/reachability.hpp"

namespace morphe::map {
namespace {

/// Measures A, which needs the human elbow alone, and B and C, which need the whole arm.
void measure_humanlikeness(const MappingProblem& problem, const Goals& goals, int frame,
                           const std::vector<Pose>& base_from_frame, MappingResult& mapped) {
  const humanlike::Chain human{goals.shoulder_position[frame], goals.elbow_position[frame],
                               goals.wrist_position[frame]};
  const std::vector<Vec3> inner = robot::arm_centre_positions(*problem.robot, base_from_frame);
  if (!is_known(human[1]) || inner.empty()) return;
  mapped.humanlikeness(frame, 0) = humanlike::joint_distance_sum(human[1], inner);
  if (!is_known(human[0]) || !is_known(human[2])) return;
  const humanlike::Chain robot = humanlike::arm_chain(*problem.robot, base_from_frame).joints;
  mapped.humanlikeness(frame, 1) = humanlike::triangle_area_sum(human, robot);
  mapped.humanlikeness(frame, 2) = humanlike::hull_volume_sum(human, robot);
}

void measure_frame(const MappingProblem& problem, const Goals& goals, int frame,
                   MappingScratch& scratch, MappingResult& mapped) {
  const JointVector q = mapped.position.row(frame).transpose();
  const humanlike::FrameGoal goal = humanlike::frame_goal(goals, frame);
  scratch.model.reset(q.size());
  add_frame_objective(problem, frame, q, scratch, scratch.model);
  mapped.objective.push_back(scratch.model.value);
  bool has_goal = false, met = true, reachable = true;
  for (int i = 0; i < std::ssize(goal.tip_position); ++i) {
    const Pose tip = robot::tip_pose(*problem.robot, scratch.base_from_frame, i);
    if (is_known(goal.tip_orientation[i])) {
      mapped.tip_orientation_error(frame, i) =
          angle_between(Quat(tip.linear()), goal.tip_orientation[i]);
    }
    if (!is_known(goal.tip_position[i])) continue;
    has_goal = true;
    const Vec3 reached = robot::tracked_point(*problem.robot, scratch.base_from_frame, i,
                                              goal.tip_to_pad_share_of(i));
    const double error = (reached - goal.tip_position[i]).norm();
    mapped.tip_error(frame, i) = error;
    met = met && error < kMetTolerance_m;
    reachable = reachable && goals.reachable(frame, i);
  }
  mapped.status.push_back(!has_goal   ? FrameStatus::no_goal
                          : met       ? FrameStatus::met
                          : reachable ? FrameStatus::compromise
                                      : FrameStatus::out_of_reach);
  measure_humanlikeness(problem, goals, frame, scratch.base_from_frame, mapped);
}

MappingResult measure(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  const Eigen::Index frames = q.rows(), tips = goals.tip_position.cols;
  MappingResult mapped;
  mapped.position = q;
  mapped.tip_error = JointRows::Constant(frames, tips, kUnknown);
  mapped.tip_orientation_error = JointRows::Constant(frames, tips, kUnknown);
  mapped.humanlikeness = JointRows::Constant(frames, 3, kUnknown);
  MappingScratch scratch;
  for (int f = 0; f < frames; ++f) measure_frame(problem, goals, f, scratch, mapped);
  return mapped;
}

double posture_error(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  double sum = 0;
  int count = 0;
  for (int f = 0; f < q.rows(); ++f) {
    const double error = problem.objective.get<humanlike::NaturalPosture>().distance(
        q.row(f).transpose(), humanlike::frame_goal(goals, f));
    if (std::isnan(error)) continue;
    sum += error * error;
    ++count;
  }
  return count == 0 ? kUnknown : std::sqrt(sum / count);
}

/// Returns goals for the middle joints of robot fingers that follow a curve between human fingers.
std::vector<Vec3> curve_joints(const robot::Robot& robot, const Goals& goals, int frame) {
  const auto joint = [&](int finger) { return goals.finger_joint_position(frame, finger); };
  std::vector<Vec3> points(robot.tips.size(), unknown_point());
  for (int tip = 0; tip < std::ssize(points); ++tip) {
    const double share = robot.tips[tip].finger_curve_share;
    if (!std::isfinite(share)) continue;
    points[tip] = finger_curve_point({joint(1), joint(2), joint(3), joint(4)}, share);
  }
  return points;
}

/// Returns the problem with the goals of the tips, which decide in every mode what is reachable.
MappingProblem with_tip_goals(const MappingProblem& problem, const Goals& goals) {
  MappingProblem tracked = problem;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    tracked.goals[f] = humanlike::frame_goal(goals, f);
  }
  return tracked;
}

MapResult make_result(const MappingProblem& problem, const MappingProblem& tracked, Goals& goals,
                      const JointRows& q, const MapOptions& options, std::uint64_t seed) {
  const std::vector<bool> reachable = reachable_frames(
      tracked, q, {options.reach_search_starts, options.reach_tolerance_m, options.frame_solver},
      math::seed_from(seed, "reachable"));
  for (int f = 0; f < q.rows(); ++f) {
    for (std::size_t i = 0; i < goals.reachable.cols; ++i) goals.reachable(f, i) = reachable[f];
  }
  MapResult result;
  result.mapped = measure(problem, goals, q);
  result.mapped.least_attainable_error =
      nearest_errors(tracked, q, reachable, options.frame_solver);
  result.mapped.natural_posture_error = posture_error(problem, goals, q);
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
  problem.wrist_motion = options.mode == MapMode::humanlike ? options.wrist_motion : 0;
  problem.world = &world;
  problem.time = goals.time;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
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
  const bool any_goal = std::ranges::any_of(
      tracked.goals, [](const auto& goal) { return goal.goal_tip_count() > 0; });
  if (problem.frames() < kMinFrames || !any_goal) {
    return {{},
            {Reason::no_goal, any_goal ? "the movement has fewer than 5 frames"
                                       : "no fingertip was seen in the whole movement"}};
  }
  const std::vector<CandidatePath> paths = search_movement(problem, options, seed);
  MapResult result = make_result(problem, tracked, goals, paths.front().q, options, seed);
  for (int i = 1; i < std::ssize(paths); ++i) result.candidates.push_back(paths[i].q);
  return {std::move(result), {}};
}

MapResult evaluate_path(const MappingProblem& problem, Goals& goals, const JointRows& q,
                        const MapOptions& options, std::uint64_t seed) {
  return make_result(problem, with_tip_goals(problem, goals), goals, q, options, seed);
}

}  // namespace morphe::map
