#include "pipeline/explain/base_shift.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "core/collision/world.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/map/compass_search.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {
namespace {

constexpr std::size_t kFramesAlong = 6, kFramesAroundFindings = 6;  ///< largest numbers
constexpr double kShiftWeight = 0.01;  ///< cost of a metre of shift [m]
constexpr double kMinShiftStep_m = 0.01;

/// Returns frames of findings and evenly spaced ones, without those in which the target is
/// attached, because its pose then depends on the whole path.
std::vector<std::size_t> select_frames(const Plan& plan) {
  double attach_s = kInfinity;
  for (const SceneObject& object : plan.scene.objects)
    if (object.name == plan.movement.target && !object.attached_frame.empty())
      attach_s = object.attach_s;
  const std::vector<double>& time = plan.goals.time;
  std::vector<Finding> findings =
      plan.remaining_findings.empty() ? plan.findings : plan.remaining_findings;
  std::ranges::stable_sort(findings, std::greater{}, &Finding::excess_m);
  std::set<std::size_t> frames;
  for (const Finding& finding : findings) {
    if (frames.size() == kFramesAroundFindings) break;
    const double middle_s = 0.5 * (finding.begin_s + finding.end_s);
    frames.insert(std::min(std::ssize(time) - 1,
                           std::ranges::lower_bound(time, middle_s - 1e-9) - time.begin()));
  }
  for (const std::size_t frame : planning::evenly_spaced_indices(time.size(), kFramesAlong))
    frames.insert(frame);
  std::erase_if(frames, [&](std::size_t frame) { return time[frame] >= attach_s; });
  return {frames.begin(), frames.end()};
}

Eigen::Matrix3d base_rotation(const robot::Robot& robot, const map::PlacementOptions& placement) {
  return (map::is_hand_only(robot) ? map::place_hand(robot, placement)
                                   : map::place_robot(robot, Vec3::Zero(), placement))
      .linear();
}
class ShiftedBase {
 public:
  ShiftedBase(const robot::Robot& robot, const planning::PipelineConfig& config, const Plan& plan,
              std::vector<std::size_t> frames)
      : robot_(robot), config_(config), plan_(plan), frames_(std::move(frames)) {
    base_from_world_ = base_rotation(robot, config.placement).transpose();
  }

  /// Returns the summed excess of the best postures' findings, summed over the frames [m].
  double summed_excess_m(const Vec3& shift) const {
    const Vec3 offset = -(base_from_world_ * shift);  // of scene and goals in the base frame
    const Scene scene = scene::transform_scene(plan_.scene, Pose(Eigen::Translation3d(offset)));
    Goals goals = plan_.goals;
    for (Vec3& tip : goals.tip_position.values) tip += offset;
    const collision::CollisionWorld world = collision::make_world(
        robot_, scene, plan_.movement, plan_.tolerances, config_.scene.meshes);
    const map::MappingProblem problem = planning::with_clearance_weights(
        map::make_mapping_problem(robot_, goals, world, config_.map, plan_.movement.phases),
        planning::kStrongestWeights);
    map::MappingScratch scratch;
    double sum = 0;
    for (const std::size_t frame : frames_) {
      double min_excess_m = kInfinity;
      for (const JointRows* rows : {&plan_.path.position, &plan_.mapped.position}) {
        if (std::cmp_greater_equal(frame, rows->rows()) || min_excess_m == 0) continue;
        const JointVector q = map::solve_frame(problem, frame, rows->row(frame).transpose(),
                                               config_.map.frame_solver, scratch)
                                  .x;
        const JointPath path{q.transpose(), {SampleOrigin::re_solved}, {goals.time[frame]}};
        double posture_excess_m = 0;
        for (const Finding& finding :
             check::check_path(world, goals, plan_.movement, path, config_.check))
          posture_excess_m += finding.excess_m();
        min_excess_m = std::min(min_excess_m, posture_excess_m);
      }
      sum += min_excess_m;
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
  const ShiftedBase base(robot, config, plan, frames);
  BaseShift result;
  result.frames = frames.size();
  result.depth_before = base.summed_excess_m(Vec3::Zero());
  result.shift = map::compass_search(
      [&](const Vec3& shift) { return base.summed_excess_m(shift) + kShiftWeight * shift.norm(); },
      limit_m, kMinShiftStep_m);
  result.depth_after = base.summed_excess_m(result.shift);
  if (result.shift.isZero() || !(result.depth_after <= 0.5 * result.depth_before))
    return std::nullopt;
  return result;
}

}  // namespace morphe::explain
