#include "stages/verify/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/movement.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/scene.hpp"

namespace morphe::verify {
namespace {

constexpr double kPose = 1e-6, kCarryingTime_s = 1e-9;

bool is_absent(const Pose& pose) { return !pose.matrix().allFinite(); }

/// How far a stored pose is from what it should be; both may be absent.
double off(const Pose& stored, const std::optional<Pose>& wanted) {
  if (!wanted) return is_absent(stored) ? 0 : kInfinity;
  if (is_absent(stored)) return kInfinity;
  return (stored.matrix() - wanted->matrix()).cwiseAbs().maxCoeff();
}

/// When the hand takes an object and when it lets go.
void judge_times(const Plan& plan, const SceneObject& object, ViolationRuns& runs) {
  const auto near = [](double a, double b) { return std::abs(a - b) <= kCarryingTime_s; };
  const Phase* grasp = last_phase(plan.movement, PhaseKind::grasp);
  if (!grasp || !near(object.attach_s, grasp->end_s))
    runs.note_plan("scene", object.name, object.attach_s, grasp ? grasp->end_s : kNotSeen);
  if (!grasp) return;
  const Phase* transport = last_phase(plan.movement, PhaseKind::transport);
  const double release_s =
      transport ? transport->end_s : std::max(plan.movement.end_s, grasp->end_s);
  // Parts of a movement have that of the whole.
  const bool good = near(object.release_s, release_s) ||
                    (!transport && object.release_s >= release_s - kCarryingTime_s);
  if (!good) runs.note_plan("scene", object.name, object.release_s, release_s);
}

void judge_carrying(const RobotTable& robot, const Plan& plan, const SceneObject& object,
                    ViolationRuns& runs) {
  const bool timed = !std::isnan(object.attach_s) || !std::isnan(object.release_s);
  const bool target = object.name == plan.movement.target;
  if (!timed && object.attached_frame.empty()) return;
  const bool known = object.attached_frame.empty() ||
                     std::ranges::find(robot.frames, object.attached_frame,
                                       &RobotTable::Frame::name) != robot.frames.end();
  if (!target || !known || std::isnan(object.attach_s)) {
    runs.note_plan("scene", object.name, kNotSeen, kNotSeen);
    return;
  }
  judge_times(plan, object, runs);
}

}  // namespace

void judge_scene(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  const SceneObject* target = object_named(objects, plan.movement.target);
  if (!plan.movement.target.empty() && !target)
    runs.note_plan("scene", "target", kNotSeen, kNotSeen);
  for (const SceneObject& object : objects) {
    if (&object != object_named(objects, object.name))
      runs.note_plan("scene", object.name, kNotSeen, kNotSeen);
    judge_carrying(robot, plan, object, runs);
  }
  if (is_absent(plan.world.base_from_world)) return;  // of earlier versions, or nothing was placed
  const Eigen::Matrix3d& turn = plan.world.base_from_world.linear();
  if (!(turn.isUnitary(kPose) && turn.determinant() > 0))
    runs.note_plan("scene", "world/recording", kNotSeen, kNotSeen);
  const double begin_s = plan.movement.begin_s;
  const auto holds = [&](const char* name, const Pose& stored, const std::optional<Pose>& wanted) {
    const double away = off(stored, wanted);
    if (!(away <= kPose)) runs.note_plan("scene", name, away, kPose);
  };
  std::optional<Pose> top, standing;
  const SceneObject* table = object_named(objects, "table");
  if (table && table->shape == Shape::box)
    top = recorded_pose(*table, begin_s) * Eigen::Translation3d(0, 0, table->size[2] / 2);
  if (target) standing = recorded_pose(*target, begin_s);
  holds("world/table", plan.world.base_from_table, top);
  holds("world/target", plan.world.base_from_target, standing);
}

}  // namespace morphe::verify
