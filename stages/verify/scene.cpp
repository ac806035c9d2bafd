#include "stages/verify/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/movement.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/scene.hpp"

namespace morphe::verify {
namespace {

constexpr double kScenePoseTolerance = 1e-6, kAttachTimeTolerance_s = 1e-9;

bool is_absent(const Pose& pose) { return !pose.matrix().allFinite(); }

/// Returns the deviation of a stored pose from the expected one; both may be absent.
double pose_error(const Pose& stored, const std::optional<Pose>& wanted) {
  if (!wanted) return is_absent(stored) ? 0 : kInfinity;
  if (is_absent(stored)) return kInfinity;
  return (stored.matrix() - wanted->matrix()).cwiseAbs().maxCoeff();
}

/// Checks the times at which the hand attaches and releases an object.
void verify_attach_times(const Plan& plan, const SceneObject& object, ViolationCollector& runs) {
  const auto near = [](double a, double b) { return std::abs(a - b) <= kAttachTimeTolerance_s; };
  const Phase* grasp = last_phase(plan.movement, PhaseKind::grasp);
  if (!grasp || !near(object.attach_s, grasp->end_s))
    runs.note_plan("scene", object.name, object.attach_s, grasp ? grasp->end_s : kUnknown);
  if (!grasp) return;
  const Phase* transport = last_phase(plan.movement, PhaseKind::transport);
  const double release_s =
      transport ? transport->end_s : std::max(plan.movement.end_s, grasp->end_s);
  // Parts of a movement have the release time of the whole movement.
  const bool good = near(object.release_s, release_s) ||
                    (!transport && object.release_s >= release_s - kAttachTimeTolerance_s);
  if (!good) runs.note_plan("scene", object.name, object.release_s, release_s);
}

void verify_attachment(const RobotModel& robot, const Plan& plan, const SceneObject& object,
                       ViolationCollector& runs) {
  const bool timed = !std::isnan(object.attach_s) || !std::isnan(object.release_s);
  const bool target = object.name == plan.movement.target;
  if (!timed && object.attached_frame.empty()) return;
  const bool known = object.attached_frame.empty() ||
                     std::ranges::find(robot.frames, object.attached_frame,
                                       &RobotModel::Frame::name) != robot.frames.end();
  if (!target || !known || std::isnan(object.attach_s)) {
    runs.note_plan("scene", object.name, kUnknown, kUnknown);
    return;
  }
  verify_attach_times(plan, object, runs);
}

}  // namespace

void verify_scene(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  const SceneObject* target = find_object(objects, plan.movement.target);
  if (!plan.movement.target.empty() && !target)
    runs.note_plan("scene", "target", kUnknown, kUnknown);
  for (const SceneObject& object : objects) {
    if (&object != find_object(objects, object.name))
      runs.note_plan("scene", object.name, kUnknown, kUnknown);
    verify_attachment(robot, plan, object, runs);
  }
  // written by an earlier version, or no object was placed
  if (is_absent(plan.reference_frames.base_from_world)) return;
  const Eigen::Matrix3d& turn = plan.reference_frames.base_from_world.linear();
  if (!(turn.isUnitary(kScenePoseTolerance) && turn.determinant() > 0))
    runs.note_plan("scene", "reference_frames/recording", kUnknown, kUnknown);
  const double begin_s = plan.movement.begin_s;
  const auto holds = [&](const char* name, const Pose& stored, const std::optional<Pose>& wanted) {
    const double away = pose_error(stored, wanted);
    if (!(away <= kScenePoseTolerance)) runs.note_plan("scene", name, away, kScenePoseTolerance);
  };
  std::optional<Pose> top, standing;
  const SceneObject* table = find_object(objects, "table");
  if (table && table->shape == Shape::box)
    top = recorded_pose(*table, begin_s) * Eigen::Translation3d(0, 0, table->size[2] / 2);
  if (target) standing = recorded_pose(*target, begin_s);
  holds("reference_frames/table", plan.reference_frames.base_from_table, top);
  holds("reference_frames/target", plan.reference_frames.base_from_target, standing);
}

}  // namespace morphe::verify
