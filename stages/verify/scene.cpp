#include "stages/verify/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/key_bounds.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/scene.hpp"
#include "stages/verify/find_index.hpp"

namespace morphe::verify {
namespace {

/// The bounds of each extent of a target whose shape is inferred [m]: those of the config's keys.
constexpr double kLeastInferredExtent_m = bounds::kInferredExtent.lower,
                 kLargestInferredExtent_m = bounds::kInferredExtent.upper;
constexpr double kExtentTolerance_m = 1e-9;
constexpr double kFrameTolerance = 1e-6, kAttachTimeTolerance_s = 1e-9;

/// Returns the deviation of a stored pose from the expected one; 0 if both are absent.
double pose_error(const Pose& stored, const std::optional<Pose>& expected) {
  const bool present = stored.matrix().allFinite();
  if (!present || !expected) return present == expected.has_value() ? 0 : kInfinity;
  return (stored.matrix() - expected->matrix()).cwiseAbs().maxCoeff();
}

void verify_attach_times(const Plan& plan, const SceneObject& object, ViolationLog& violations) {
  const auto near = [](double a, double b) { return std::abs(a - b) <= kAttachTimeTolerance_s; };
  const Phase* grasp = last_phase(plan.movement, PhaseKind::grasp);
  if (!grasp || !near(object.attach_s, grasp->end_s))
    violations.note_plan("scene", object.name, object.attach_s, grasp ? grasp->end_s : kUnknown);
  if (!grasp) return;
  const Phase* transport = last_phase(plan.movement, PhaseKind::transport);
  const double release_s =
      transport ? transport->end_s : std::max(plan.movement.end_s, grasp->end_s);
  // Parts of a movement have the release time of the whole movement.
  const bool at_end = near(object.release_s, release_s) ||
                      (!transport && object.release_s >= release_s - kAttachTimeTolerance_s);
  if (!at_end) violations.note_plan("scene", object.name, object.release_s, release_s);
}

void verify_attachment(const RobotModel& robot, const Plan& plan, const SceneObject& object,
                       ViolationLog& violations) {
  const bool timed = !std::isnan(object.attach_s) || !std::isnan(object.release_s);
  const bool target = object.name == plan.movement.target;
  if (!target && !timed && object.attached_frame.empty()) return;
  const bool known = object.attached_frame.empty() ||
                     find_index(robot.frames, object.attached_frame, &RobotModel::Frame::name) >= 0;
  if (!target || !known || std::isnan(object.attach_s)) {
    violations.note_plan("scene", object.name, kUnknown, kUnknown);
    return;
  }
  verify_attach_times(plan, object, violations);
}

/// Records an inferred object that is not an upright cylinder of a likely size. (An inferred table
/// is any box; the shape alone is inferred of an object of which only the poses were recorded.)
void verify_inferred_shape(const SceneObject& object, ViolationLog& violations) {
  if (object.pose_origin != ObjectOrigin::inferred || object.name == "table" ||
      object.shape_origin != ObjectOrigin::inferred)
    return;
  if (object.shape != Shape::cylinder || object.size.size() != 2) {
    violations.note_plan("scene", object.name + "/shape_origin", kUnknown, kUnknown);
    return;
  }
  for (const double extent : {2 * object.size[0], object.size[1]}) {
    if (!(extent >= kLeastInferredExtent_m - kExtentTolerance_m))
      violations.note_plan("scene", object.name + "/size", extent, kLeastInferredExtent_m);
    if (!(extent <= kLargestInferredExtent_m + kExtentTolerance_m))
      violations.note_plan("scene", object.name + "/size", extent, kLargestInferredExtent_m);
  }
}

}  // namespace

void verify_scene(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  const SceneObject* target = find_object(objects, plan.movement.target);
  if (!plan.movement.target.empty() && !target)
    violations.note_plan("scene", "target", kUnknown, kUnknown);
  for (const SceneObject& object : objects) {
    if (&object != find_object(objects, object.name))
      violations.note_plan("scene", object.name, kUnknown, kUnknown);
    verify_attachment(robot, plan, object, violations);
    verify_inferred_shape(object, violations);
  }
  const Pose& base_from_world = plan.reference_frames.base_from_world;
  // A plan of an earlier version, or one without placed objects, has no reference frames.
  if (!base_from_world.matrix().allFinite()) return;
  const Eigen::Matrix3d& rotation = base_from_world.linear();
  if (!(rotation.isUnitary(kFrameTolerance) && rotation.determinant() > 0))
    violations.note_plan("scene", "reference_frames/recording", kUnknown, kUnknown);
  const double begin_s = plan.movement.begin_s;
  const auto check = [&](const char* name, const Pose& stored,
                         const std::optional<Pose>& expected) {
    const double error = pose_error(stored, expected);
    if (!(error <= kFrameTolerance)) violations.note_plan("scene", name, error, kFrameTolerance);
  };
  std::optional<Pose> table_pose, target_pose;
  const SceneObject* table = find_object(objects, "table");
  if (table && table->shape == Shape::box)
    table_pose = recorded_pose(*table, begin_s) * Eigen::Translation3d(0, 0, table->size[2] / 2);
  if (target) target_pose = recorded_pose(*target, begin_s);
  check("reference_frames/table", plan.reference_frames.base_from_table, table_pose);
  check("reference_frames/target", plan.reference_frames.base_from_target, target_pose);
}

}  // namespace morphe::verify
