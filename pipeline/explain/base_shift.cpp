#include "pipeline/explain/base_shift.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "core/collision/world.hpp"
#include "pipeline/planning/clearance_weights.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/map/compass_search.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {
namespace {

constexpr std::size_t kFramesAlong = 6, kFramesAroundFindings = 6;  ///< numbers of frames
constexpr double kShiftWeight = 0.01;  ///< cost of a metre of shift [m]
constexpr double kMinShiftStep_m = 0.01;

/// Returns a few frames along the movement, and those in the middle of the remaining findings,
/// before the target is attached, because its pose then depends on the whole path.
std::vector<std::size_t> select_frames(const Plan& plan) {
  double carried_s = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : plan.scene.objects) {
    if (object.name == plan.movement.target && !object.attached_frame.empty())
      carried_s = object.attach_s;
  }
  const std::vector<double>& time = plan.goals.time;
  std::vector<Finding> left =
      plan.remaining_findings.empty() ? plan.findings : plan.remaining_findings;
  std::ranges::stable_sort(left, std::greater{}, &Finding::excess);
  std::set<std::size_t> frames;
  for (const Finding& finding : left) {
    if (frames.size() == kFramesAroundFindings) break;
    const auto at = std::ranges::lower_bound(time, 0.5 * (finding.begin_s + finding.end_s) - 1e-9);
    frames.insert(std::min(time.size() - 1, static_cast<std::size_t>(at - time.begin())));
  }
  for (const std::size_t frame : planning::evenly_spaced_frames(time.size(), kFramesAlong))
    frames.insert(frame);
  std::erase_if(frames, [&](std::size_t frame) { return time[frame] >= carried_s; });
  return {frames.begin(), frames.end()};
}

/// Returns the rotation world_from_base given by the config.
Eigen::Matrix3d base_rotation(const robot::Robot& robot, const map::PlacementOptions& placement) {
  return (map::is_hand_only(robot) ? map::place_hand(robot, placement)
                                   : map::place_robot(robot, Vec3::Zero(), placement))
      .linear();
}

/// Evaluates the plan's frames with a shifted base.
class ShiftedBase {
 public:
  ShiftedBase(const robot::Robot& robot, const planning::PipelineConfig& config, const Plan& plan,
              std::vector<std::size_t> frames)
      : robot_(robot), config_(config), plan_(plan), frames_(std::move(frames)) {
    base_from_world_ = base_rotation(robot, config.placement).transpose();
  }

  /// Returns the depths of the best postures' findings, summed over the frames.
  double violation_depth(const Vec3& shift) const {
    const Vec3 moved = -(base_from_world_ * shift);  // the motion of the world relative to the base
    const Scene scene = scene::transform_scene(plan_.scene, Pose(Eigen::Translation3d(moved)));
    Goals goals = plan_.goals;
    for (Vec3& tip : goals.tip_position.values) tip += moved;
    const collision::CollisionWorld world = collision::make_world(
        robot_, scene, plan_.movement, plan_.tolerances, config_.scene.meshes);
    const map::MappingProblem problem = planning::with_clearance_weights(
        map::make_mapping_problem(robot_, goals, world, config_.map, plan_.movement.phases),
        planning::kStrongestWeights);
    map::MappingScratch scratch;
    double sum = 0;
    for (const std::size_t frame : frames_) {
      double least = std::numeric_limits<double>::infinity();
      const auto row = static_cast<Eigen::Index>(frame);
      for (const JointRows* rows : {&plan_.path.position, &plan_.mapped.position}) {
        if (row >= rows->rows() || least == 0) continue;
        const JointVector q = map::solve_frame(problem, frame, rows->row(row).transpose(),
                                               config_.map.frame_solver, scratch)
                                  .x;
        double depths = 0;
        for (const Finding& finding : check::check_path(
                 world, goals, plan_.movement,
                 {q.transpose(), {SampleOrigin::re_solved}, {goals.time[frame]}}, config_.check)) {
          depths += finding.excess;
        }
        least = std::min(least, depths);
      }
      sum += least;
    }
    return sum;
  }

 private:
  const robot::Robot& robot_;
  const planning::PipelineConfig& config_;
  const Plan& plan_;
  std::vector<std::size_t> frames_;
  Eigen::Matrix3d base_from_world_;
};

}  // namespace

std::optional<BaseShift> find_base_shift(const robot::Robot& robot,
                                         const planning::PipelineConfig& config, const Plan& plan,
                                         double limit_m) {
  if (plan.mapped.position.rows() == 0) return std::nullopt;
  const std::vector<std::size_t> frames = select_frames(plan);
  if (frames.empty()) return std::nullopt;
  const ShiftedBase elsewhere(robot, config, plan, frames);
  BaseShift found;
  found.frames = frames.size();
  found.depth_before = elsewhere.violation_depth(Vec3::Zero());
  found.shift = map::compass_search(
      [&](const Vec3& shift) {
        return elsewhere.violation_depth(shift) + kShiftWeight * shift.norm();
      },
      limit_m, kMinShiftStep_m);
  found.depth_after = elsewhere.violation_depth(found.shift);
  if (found.shift.isZero() || !(found.depth_after <= 0.5 * found.depth_before)) return std::nullopt;
  return found;
}

}  // namespace morphe::explain
