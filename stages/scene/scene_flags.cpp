#include "stages/scene/scene_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/collision/distance.hpp"
#include "core/motion/bounding_box.hpp"
#include "stages/scene/infer_objects.hpp"

namespace morphe::scene {
namespace {

RecordingFlag flag_of(FlagCode code, const Phase& grasp, const std::string& subject, double value_m,
                      double limit_m, std::string text) {
  return {.code = code,
          .begin_s = grasp.begin_s,
          .end_s = grasp.end_s,
          .subject = subject,
          .value = value_m,
          .limit = limit_m,
          .unit = "m",
          .text = std::move(text)};
}

/// Returns the doubt about the width of an inferred cylinder between the tips.
std::vector<RecordingFlag> width_flags(const TargetOptions& options, const GraspTips& tips,
                                       const Phase& grasp, const SceneObject& target) {
  if (target.shape != Shape::cylinder || options.radius) return {};
  const double wanted_m = 2 * radius_between(options, tips), width_m = 2 * target.size[0];
  if (wanted_m == width_m) return {};
  return {
      flag_of(FlagCode::unlikely_target, grasp, target.name, wanted_m, width_m,
              fmt::format("thumb and index are {:.0f} mm apart horizontally at the grasp, which "
                          "holds something {} than an inferred {} may be: it is taken as {:.0f} "
                          "mm wide; give its shape with scene.target.body, or its radius with "
                          "scene.target.radius",
                          1e3 * horizontal_aperture(tips), wanted_m < width_m ? "thinner" : "wider",
                          target.name, 1e3 * width_m))};
}

/// Returns the doubt about a target that would be too tall if it stood on the table.
std::vector<RecordingFlag> height_flags(const TargetOptions& options, const GraspTips& tips,
                                        const Phase& grasp, const SceneObject& target,
                                        const SceneObject* table) {
  if (!table || table->shape != Shape::box || target.shape != Shape::cylinder) return {};
  const double height_m = rim_height(options, tips) - table_top_height(*table);
  constexpr double kMaxHeight_m = bounds::kInferredExtent.upper;
  if (!(height_m > kMaxHeight_m)) return {};
  return {
      flag_of(FlagCode::unlikely_target, grasp, target.name, height_m, kMaxHeight_m,
              fmt::format("a {} that stands on the table would be {:.0f} mm tall, more than an "
                          "inferred one may be: it is taken as {:.0f} mm tall and in the air at "
                          "the grasp; give its shape with scene.target.body, or the table's "
                          "height with scene.table.height",
                          target.name, 1e3 * height_m, 1e3 * target.size[1]))};
}

/// Returns by how much a tip is too far from the surface of an object to touch it, or too deep
/// inside it [m]; 0 for an unseen tip. A mesh counts as its box, and a tip is never inside it.
double misplacement_m(const SceneObject& object, const Pose& pose, const Vec3& tip,
                      double pad_depth_m) {
  if (!is_known(tip)) return 0;
  const Vec3 in_object = pose.inverse() * tip;
  if (object.shape == Shape::mesh) {
    const double gap_m = bounding_box(object, Pose::Identity()).exteriorDistance(in_object);
    return std::max(0.0, gap_m - pad_depth_m);
  }
  Vec3 gradient;
  return std::abs(collision::signed_distance(object, in_object, gradient) - pad_depth_m);
}

/// Returns the doubt about the pose of a recorded target.
std::vector<RecordingFlag> offset_flags(const TargetOptions& options, const GraspTips& tips,
                                        const Phase& grasp, const SceneObject& target) {
  const Pose pose = recorded_pose(target, grasp.end_s);
  const double thumb_m = misplacement_m(target, pose, tips.thumb, options.pad_depth),
               index_m = misplacement_m(target, pose, tips.index, options.pad_depth);
  const double offset_m = std::max(thumb_m, index_m);
  if (!(offset_m > kMaxTargetOffset_m)) return {};
  return {flag_of(
      FlagCode::target_offset, grasp, target.name, offset_m, kMaxTargetOffset_m,
      fmt::format("at the grasp, the {} is {:.0f} mm from where it would touch {} as "
                  "recorded; the recorded pose is used",
                  thumb_m > index_m ? "thumb" : "index finger", 1e3 * offset_m, target.name))};
}

/// Adds the distance of wrist and tips from an object in one frame to the least one.
void add_distance(const HumanMotion& motion, std::size_t frame, const SceneObject& object,
                  double& least_m, double& at_s) {
  const Pose pose = recorded_pose(object, motion.time[frame]);
  const Eigen::AlignedBox3d box = bounding_box(object, Pose::Identity());
  const auto add = [&](const Vec3& point) {
    if (!is_known(point)) return;
    const double distance_m = box.exteriorDistance(Vec3(pose.inverse() * point));
    if (!(distance_m < least_m)) return;
    least_m = distance_m;
    at_s = motion.time[frame];
  };
  if (frame < motion.wrist.size()) add(motion.wrist[frame]);
  for (std::size_t k = 0; frame < motion.tip.rows && k < motion.tip.cols; ++k)
    add(motion.tip(frame, k));
}

/// Returns the doubt about a recorded object that the hand never comes near.
std::vector<RecordingFlag> distance_flags(const HumanMotion& motion, const Movement& movement,
                                          const SceneObject& object) {
  double least_m = kInfinity, at_s = kUnknown;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (motion.time[i] < movement.begin_s || motion.time[i] > movement.end_s) continue;
    add_distance(motion, i, object, least_m, at_s);
  }
  if (!std::isfinite(least_m) || least_m <= kMaxObjectReach_m) return {};
  return {
      {.code = FlagCode::object_away,
       .begin_s = movement.begin_s,
       .end_s = movement.end_s,
       .subject = object.name,
       .value = least_m,
       .limit = kMaxObjectReach_m,
       .unit = "m",
       .text = fmt::format("{} was recorded {:.2f} m or more from the hand, nearest at {:.2f} s: "
                           "is it in another frame or unit?",
                           object.name, least_m, at_s)}};
}

}  // namespace

std::vector<RecordingFlag> scene_flags(const SceneOptions& options,
                                       const Demonstration& demonstration,
                                       const HumanMotion& motion, const Movement& movement,
                                       const Scene& scene) {
  std::vector<RecordingFlag> flags;
  const auto add = [&](std::vector<RecordingFlag> found) {
    std::ranges::move(found, std::back_inserter(flags));
  };
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  const SceneObject* target = find_object(scene.objects, movement.target);
  if (grasp && target) {
    const GraspTips tips = tips_at_grasp(motion, *grasp);
    if (target->pose_origin == ObjectOrigin::inferred) {
      add(width_flags(options.target, tips, *grasp, *target));
      add(height_flags(options.target, tips, *grasp, *target,
                       find_object(scene.objects, std::string(kTableName))));
    } else if (target->pose_origin == ObjectOrigin::recorded) {
      add(offset_flags(options.target, tips, *grasp, *target));
    }
  }
  for (const SceneObject& object : demonstration.objects) {
    const bool is_other = object.name != movement.target && object.name != kTableName &&
                          !is_other_arm_part(options, object.name);
    if (is_other && !object.time.empty()) add(distance_flags(motion, movement, object));
  }
  return flags;
}

}  // namespace morphe::scene
