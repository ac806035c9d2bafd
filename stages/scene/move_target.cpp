#include "stages/scene/move_target.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/math/rotation.hpp"
#include "stages/scene/configured_body.hpp"
#include "stages/scene/infer_objects.hpp"

namespace morphe::scene {
namespace {

/// A rotation of a body about its centre and a translation, of which a share w is applied.
struct RigidDisplacement {
  Vec3 centre = Vec3::Zero(), translation = Vec3::Zero();
  Quat rotation = Quat::Identity();

  Quat rotation_at(double w) const { return Quat::Identity().slerp(w, rotation); }
  Vec3 moved(const Vec3& x, double w) const {
    return rotation_at(w) * (x - centre) + centre + w * translation;
  }
};

RigidDisplacement target_displacement(const TargetOptions& options, const Pose& world_from_target) {
  RigidDisplacement shift;
  shift.centre = world_from_target.translation();
  if (options.pose) {
    shift.translation = options.pose->position - shift.centre;
    shift.rotation =
        rotation_from_rpy(options.pose->rpy) * Quat(world_from_target.linear()).conjugate();
  } else {
    shift.translation = options.pose_offset.position;
    shift.rotation = rotation_from_rpy(options.pose_offset.rpy);
  }
  return shift;
}

/// Returns, for each frame, the travelled share of the wrist's path from begin_s to end_s, or the
/// elapsed share of the time if the wrist was not seen; 0 before and 1 after.
std::vector<double> wrist_path_shares(const HumanMotion& motion, double begin_s, double end_s) {
  std::vector<double> shares(motion.time.size(), 0.0);
  double path_length_m = 0;
  Vec3 last = unknown_point();
  for (int i = 0; i < std::ssize(shares); ++i) {
    if (motion.time[i] >= begin_s && motion.time[i] <= end_s && is_known(motion.wrist[i])) {
      if (is_known(last)) path_length_m += (motion.wrist[i] - last).norm();
      last = motion.wrist[i];
    }
    shares[i] = path_length_m;
  }
  for (int i = 0; i < std::ssize(shares); ++i) {
    const double time_share = (motion.time[i] - begin_s) / (end_s - begin_s);
    shares[i] = motion.time[i] >= end_s     ? 1
                : motion.time[i] <= begin_s ? 0
                : path_length_m > 0         ? shares[i] / path_length_m
                                            : time_share;
  }
  return shares;
}

/// Moves the elbow after the wrist has moved. Returns false if the wrist is nearer to or farther
/// from the shoulder than the bones allow.
bool move_elbow(const Vec3& shoulder, const Vec3& from_wrist, const Vec3& to_wrist, Vec3& elbow) {
  const Vec3 before = from_wrist - shoulder, after = to_wrist - shoulder;
  const double upper_arm = (elbow - shoulder).norm(), forearm = (from_wrist - elbow).norm();
  const double distance = after.norm();
  if (!(distance > 0) || !(before.norm() > 0)) return false;
  const Vec3 along = after / distance;
  Vec3 aside = math::shortest_rotation(before, after) * (elbow - shoulder);
  aside -= along * along.dot(aside);
  // Foot of the elbow on the line, by the law of cosines.
  const double foot =
      (upper_arm * upper_arm - forearm * forearm + distance * distance) / (2 * distance);
  const double height_squared = upper_arm * upper_arm - foot * foot;
  const bool reaches = height_squared >= 0;
  elbow = shoulder + (reaches ? foot : std::copysign(upper_arm, foot)) * along;
  if (reaches && aside.norm() > 0) elbow += std::sqrt(height_squared) * aside.normalized();
  return reaches;
}

void move_frame(const RigidDisplacement& shift, double w, std::size_t i, HumanMotion& motion,
                int& out_of_reach) {
  const auto point = [&](Vec3& x) { x = shift.moved(x, w); };
  const auto rotation = [&](Quat& q) { q = (shift.rotation_at(w) * q).normalized(); };
  const auto row = [&](auto& array, const auto& move) {
    for (std::size_t k = 0; array.rows > i && k < array.cols; ++k) move(array(i, k));
  };
  const Vec3 wrist = motion.wrist[i];
  point(motion.wrist[i]);
  rotation(motion.wrist_orientation[i]);
  row(motion.tip, point);
  row(motion.tip_orientation, rotation);
  row(motion.finger_joint, point);
  Vec3& elbow = motion.elbow[i];
  if (!is_known(elbow) || !is_known(wrist) || !is_known(motion.shoulder[i])) return;
  if (!move_elbow(motion.shoulder[i], wrist, motion.wrist[i], elbow)) ++out_of_reach;
}

}  // namespace

RelocatedMovement move_target(const SceneOptions& options, const HumanMotion& motion,
                              const Movement& movement, const Scene& scene) {
  RelocatedMovement out{motion, scene};
  const TargetPoseOffset& offset = options.target.pose_offset;
  if (!options.target.pose && offset.position == Vec3::Zero() && offset.rpy == Vec3::Zero())
    return out;
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  SceneObject* target = find_object(out.scene.objects, movement.target);
  if (!grasp || !target) {
    out.motion.reconstruction_notes.push_back("nothing is grasped: there is no target to move");
    return out;
  }
  const RigidDisplacement shift =
      target_displacement(options.target, recorded_pose(*target, grasp->begin_s));
  for (Vec3& position : target->position) position = shift.moved(position, 1);
  for (Quat& orientation : target->orientation)
    orientation = (shift.rotation * orientation).normalized();
  if (options.target.pose) target->pose_origin = ObjectOrigin::configured;

  const std::vector<double> share = wrist_path_shares(motion, movement.begin_s, grasp->begin_s);
  int out_of_reach = 0;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const double s = share[i];
    if (s <= 0 || motion.time[i] > movement.end_s) continue;
    const double w = s * s * s * (10 - 15 * s + 6 * s * s);
    move_frame(shift, w, i, out.motion, out_of_reach);
  }
  out.motion.arm_angles.resize(0, out.motion.arm_angles.cols());
  out.motion.estimated.emplace_back("transported");
  out.motion.reconstruction_notes.push_back(fmt::format(
      "transported: {} is {:.0f} mm from its recorded position, rotated by {:.0f} degrees{}",
      target->name, 1e3 * shift.translation.norm(),
      180 / std::numbers::pi * angle_between(shift.rotation, Quat::Identity()),
      out_of_reach > 0
          ? fmt::format("; the person's arm would not reach it in {} frames", out_of_reach)
          : ""));

  if (const auto table = infer_table(options.table, out.motion, movement)) {
    if (SceneObject* old = find_object(out.scene.objects, table->name)) *old = *table;
  }
  return out;
}

}  // namespace morphe::scene
