#include "pipeline/explain/base_shift.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "core/collision/world.hpp"
#include "pipeline/planning/firmness.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/map/compass_search.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {
namespace {

constexpr std::size_t kAlong = 6, kAround = 6;  ///< frames looked at
constexpr double kOfShift = 0.01;               ///< what a metre of shift counts [m]
constexpr double kFinest_m = 0.01;

/// A few frames along the movement, and those in the middle of what is left, before anything hangs
/// in the hand: where it hangs depends on the whole path.
std::vector<std::size_t> frames_of(const Plan& plan) {
  double carried_s = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : plan.scene.objects) {
    if (object.name == plan.movement.target && !object.attached_frame.empty())
      carried_s = object.attach_s;
  }
  const std::vector<double>& time = plan.goals.time;
  std::vector<Finding> left = plan.remaining.empty() ? plan.findings : plan.remaining;
  std::ranges::stable_sort(left, std::greater{}, &Finding::depth);
  std::set<std::size_t> frames;
  for (const Finding& finding : left) {
    if (frames.size() == kAround) break;
    const auto at = std::ranges::lower_bound(time, 0.5 * (finding.begin_s + finding.end_s) - 1e-9);
    frames.insert(std::min(time.size() - 1, static_cast<std::size_t>(at - time.begin())));
  }
  for (const std::size_t frame : planning::few_frames(time.size(), kAlong)) frames.insert(frame);
  std::erase_if(frames, [&](std::size_t frame) { return time[frame] >= carried_s; });
  return {frames.begin(), frames.end()};
}

/// world_from_base, as the config turns it.
Eigen::Matrix3d turn_of(const robot::Robot& robot, const map::PlacementOptions& placement) {
  return (map::hand_alone(robot) ? map::place_hand(robot, placement)
                                 : map::place_robot(robot, Vec3::Zero(), placement))
      .linear();
}

/// The plan's frames with the base elsewhere.
class Elsewhere {
 public:
  Elsewhere(const robot::Robot& robot, const planning::PipelineConfig& config, const Plan& plan,
            std::vector<std::size_t> frames)
      : robot_(robot), config_(config), plan_(plan), frames_(std::move(frames)) {
    base_from_world_ = turn_of(robot, config.placement).transpose();
  }

  /// Depths of what the best postures have wrong, summed over the frames.
  double badness(const Vec3& shift) const {
    const Vec3 moved = -(base_from_world_ * shift);  // how the world moves, seen from the base
    const Scene scene = scene::move_scene(plan_.scene, Pose(Eigen::Translation3d(moved)));
    Goals goals = plan_.goals;
    for (Vec3& tip : goals.tip_position.values) tip += moved;
    const collision::CollisionWorld world = collision::make_world(
        robot_, scene, plan_.movement, plan_.tolerances, config_.scene.meshes);
    const map::MappingProblem problem = planning::as_firm(
        map::make_mapping_problem(robot_, goals, world, config_.map, plan_.movement.phases),
        planning::kFirmest);
    map::MappingScratch scratch;
    double sum = 0;
    for (const std::size_t frame : frames_) {
      double least = std::numeric_limits<double>::infinity();
      const auto row = static_cast<Eigen::Index>(frame);
      for (const JointRows* rows : {&plan_.path.position, &plan_.mapped.position}) {
        if (row >= rows->rows() || least == 0) continue;
        const JointVector q = map::solve_frame(problem, frame, rows->row(row).transpose(),
                                               config_.map.solver, scratch)
                                  .x;
        double depths = 0;
        for (const Finding& finding : check::check_path(
                 world, goals, plan_.movement,
                 {q.transpose(), {Origin::resolved}, {goals.time[frame]}}, config_.check)) {
          depths += finding.depth;
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
  const std::vector<std::size_t> frames = frames_of(plan);
  if (frames.empty()) return std::nullopt;
  const Elsewhere elsewhere(robot, config, plan, frames);
  BaseShift found;
  found.frames = frames.size();
  found.before = elsewhere.badness(Vec3::Zero());
  found.shift = map::compass_search(
      [&](const Vec3& shift) { return elsewhere.badness(shift) + kOfShift * shift.norm(); },
      limit_m, kFinest_m);
  found.after = elsewhere.badness(found.shift);
  if (found.shift.isZero() || !(found.after <= 0.5 * found.before)) return std::nullopt;
  return found;
}

}  // namespace morphe::explain
