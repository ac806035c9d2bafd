#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/bounding_box.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// Returns the point between thumb and index finger, or the one of them that was seen.
Vec3 between_tips(const HumanMotion& motion, int frame) {
  const Vec3 thumb = motion.tip(frame, kThumb), index = motion.tip(frame, kIndex);
  if (!is_known(thumb)) return index;
  return is_known(index) ? Vec3((thumb + index) / 2) : thumb;
}

/// Returns the least distance between the tips and the box around an object between two
/// times; NaN if neither tip was seen.
double least_gap_m(const HumanMotion& motion, double begin_s, double end_s,
                   const SceneObject& object) {
  double gap_m = kUnknown;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const double time_s = motion.time[i];
    if (time_s < begin_s || time_s > end_s) continue;
    const Vec3 tips = between_tips(motion, i);
    if (!is_known(tips)) continue;
    const Pose pose = recorded_pose(object, time_s);
    gap_m = std::fmin(
        gap_m,
        (bounding_box(object, Pose::Identity()).exteriorDistance(Vec3(pose.inverse() * tips))));
  }
  return gap_m;
}

/// Returns the recorded objects that the hand may have taken: the movement's target, otherwise the
/// configured one, otherwise all that fit into a hand.
std::vector<const SceneObject*> possible_targets(const AuditedMovement& audited) {
  const std::vector<SceneObject>& objects = audited.recording.objects;
  for (const std::string& name : {audited.movement.target, audited.target_name}) {
    const SceneObject* const target = find_object(objects, name);
    if (target && !target->time.empty()) return {target};
  }
  const SceneObject* const table = find_object(objects, "table");
  std::vector<const SceneObject*> targets;
  for (const SceneObject& object : objects) {
    const bool obstacle = &object == table || std::ranges::find(audited.obstacles, object.name) !=
                                                  audited.obstacles.end();
    const double width_m = bounding_box(object, Pose::Identity()).sizes().minCoeff();
    if (!object.time.empty() && !obstacle && width_m <= kMaxGraspWidth_m)
      targets.push_back(&object);
  }
  return targets;
}

}  // namespace

std::vector<RecordingFlag> check_target(const AuditedMovement& audited, const AuditOptions&) {
  const Movement& movement = audited.movement;
  const Phase* const grasp = last_phase(movement, PhaseKind::grasp);
  const double begin_s = grasp ? grasp->begin_s : movement.begin_s;
  const double end_s = grasp ? grasp->end_s : movement.end_s;
  const double limit_m = grasp ? kMaxTipObjectDistance_m : kMaxReachObjectDistance_m;
  const SceneObject* nearest = nullptr;
  double nearest_m = kInfinity;
  for (const SceneObject* object : possible_targets(audited)) {
    const double gap_m = least_gap_m(audited.motion, begin_s, end_s, *object);
    if (!(gap_m < nearest_m)) continue;
    nearest_m = gap_m;
    nearest = object;
  }
  if (!nearest || nearest_m <= limit_m) return {};
  return {{.code = FlagCode::target_away,
           .begin_s = begin_s,
           .end_s = end_s,
           .subject = nearest->name,
           .value = nearest_m,
           .limit = limit_m,
           .unit = "m",
           .text = fmt::format("thumb and index {} {:.2f} m from {}: is it in another frame or "
                               "unit?",
                               grasp ? "close" : "stay", nearest_m, nearest->name)}};
}

}  // namespace morphe::imports
