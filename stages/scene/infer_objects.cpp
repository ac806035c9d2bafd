#include "stages/scene/infer_objects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"
#include "core/motion/bounding_box.hpp"
#include "stages/scene/configured_body.hpp"

namespace morphe::scene {
namespace {

struct Extent {
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
  void add(const Vec3& point) {
    if (!is_known(point)) return;
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void add_tips(const HumanMotion& motion, int frame) {
    if (motion.tip.rows != motion.time.size()) return;
    for (std::size_t k = 0; k < motion.tip.cols; ++k) add(motion.tip(frame, k));
  }
  bool empty() const { return !low.allFinite(); }
};

Extent planned_tips(const HumanMotion& motion, const Movement& movement) {
  Extent extent;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    if (motion.time[i] < movement.begin_s - kTimeTolerance_s) continue;
    if (motion.time[i] > movement.end_s + kTimeTolerance_s) continue;
    extent.add_tips(motion, i);
  }
  return extent;
}

/// Returns the least y of tips and wrist in the first frame of the movement in which one is seen.
double hand_front(const HumanMotion& motion, const Movement& movement) {
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    if (motion.time[i] < movement.begin_s - kTimeTolerance_s) continue;
    Extent hand;
    if (motion.wrist.size() == motion.time.size()) hand.add(motion.wrist[i]);
    hand.add_tips(motion, i);
    if (!hand.empty()) return hand.low.y();
  }
  return kUnknown;
}

std::optional<double> resting_height(const HumanMotion& motion, double percentile) {
  std::vector<double> heights;
  if (motion.tip.rows != motion.time.size()) return std::nullopt;
  for (const Vec3& tip : motion.tip.values) {
    if (is_known(tip)) heights.push_back(tip.z());
  }
  if (heights.empty()) return std::nullopt;
  return math::lower_quantile(std::move(heights), percentile / 100);
}

SceneObject fixed_body(std::string name, Shape shape, std::vector<double> size, const Vec3& centre,
                       double time_s) {
  SceneObject object;
  object.name = std::move(name);
  object.shape = shape;
  object.size = std::move(size);
  object.time = {time_s};
  object.position = {centre};
  object.orientation = {Quat::Identity()};
  object.pose_origin = object.shape_origin = ObjectOrigin::inferred;
  return object;
}

}  // namespace

std::optional<SceneObject> infer_table(const TableOptions& options, const HumanMotion& motion,
                                       const Movement& movement) {
  if (!options.infer && !options.height) return std::nullopt;
  const Extent tips = planned_tips(motion, movement);
  double top = 0;
  if (options.height) {
    top = *options.height;
  } else {
    const std::optional<double> rest = resting_height(motion, options.resting_height_percentile);
    if (!rest) return std::nullopt;
    top = (tips.empty() ? *rest : std::min(*rest, tips.low.z())) - options.tip_clearance;
  }
  double left = -options.size[0] / 2, right = options.size[0] / 2;
  double back = options.size[1];
  double front = hand_front(motion, movement) - options.front_margin;
  if (!std::isfinite(front)) front = 0;
  if (!tips.empty()) {
    const double middle = (tips.low.x() + tips.high.x()) / 2;
    left = std::min(middle + left, tips.low.x() - options.side_margin);
    right = std::max(middle + right, tips.high.x() + options.side_margin);
    back = std::max(front + back, tips.high.y() + options.side_margin);
  } else {
    back += front;
  }
  const Vec3 centre((left + right) / 2, (front + back) / 2, top - options.thickness / 2);
  SceneObject table =
      fixed_body(std::string(kTableName), Shape::box,
                 {right - left, back - front, options.thickness}, centre, movement.begin_s);
  if (options.height) table.pose_origin = ObjectOrigin::configured;
  return table;
}

GraspTips tips_at_grasp(const HumanMotion& motion, const Phase& grasp) {
  GraspTips tips{unknown_point(), unknown_point()};
  if (motion.tip.rows != motion.time.size() || motion.tip.cols <= kIndex) return tips;
  const double middle_s = (grasp.begin_s + grasp.end_s) / 2;
  const auto mean = [&](std::size_t finger, double from_s) -> Vec3 {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (int i = 0; i < std::ssize(motion.time); ++i) {
      const bool inside = motion.time[i] >= from_s - kTimeTolerance_s &&
                          motion.time[i] <= grasp.end_s + kTimeTolerance_s;
      if (!inside || !is_known(motion.tip(i, finger))) continue;
      sum += motion.tip(i, finger);
      count += 1;
    }
    return count > 0 ? Vec3(sum / count) : unknown_point();
  };
  // A tip hidden while the hand closes takes its position on arrival, when it is already slow.
  for (const double from_s : {middle_s, grasp.begin_s, grasp.begin_s - 0.1}) {
    if (!is_known(tips.thumb)) tips.thumb = mean(kThumb, from_s);
    if (!is_known(tips.index)) tips.index = mean(kIndex, from_s);
  }
  return tips;
}

void set_attachment_times(const Movement& movement, const Phase& grasp, SceneObject& target) {
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  target.attach_s = grasp.end_s;
  target.release_s = transport ? transport->end_s : std::max(movement.end_s, grasp.end_s);
}

double horizontal_aperture(const GraspTips& tips) {
  return (tips.thumb - tips.index).head<2>().norm();
}

double radius_between(const TargetOptions& options, const GraspTips& tips) {
  return horizontal_aperture(tips) / 2 - options.pad_depth;
}

double rim_height(const TargetOptions& options, const GraspTips& tips) {
  return std::max(tips.thumb.z(), tips.index.z()) + options.rim_margin;
}

double table_top_height(const SceneObject& table) {
  return table.position[0].z() + table.size[2] / 2;
}

namespace {

/// Returns the position of the body's frame, with grasp_point below the midpoint between the tips
/// and the lowest point at height `foot`; without that, the centre is at the midpoint's height.
Vec3 position_between_tips(const TargetBody& body, const SceneObject& object, const Quat& rotation,
                           const Vec3& midpoint, std::optional<double> foot) {
  const Eigen::AlignedBox3d extent = bounding_box(object, make_pose(Vec3::Zero(), rotation));
  const Vec3 held = body.grasp_point.empty()
                        ? Vec3(extent.center())
                        : rotation * Vec3(body.grasp_point[0], body.grasp_point[1], 0);
  const double height = foot ? *foot - extent.min().z() : midpoint.z() - extent.center().z();
  return {midpoint.x() - held.x(), midpoint.y() - held.y(), height};
}

SceneObject make_target_body(const TargetOptions& options, const Movement& movement,
                             const Phase& grasp, const GraspTips& tips, const SceneObject* table) {
  SceneObject target = fixed_body(options.name, Shape::mesh, {}, Vec3::Zero(), movement.begin_s);
  set_shape(*options.body, target);
  target.orientation = {rotation_from_rpy(options.body->rpy)};
  const std::optional<double> foot = table ? std::optional(table_top_height(*table)) : std::nullopt;
  target.position = {position_between_tips(*options.body, target, target.orientation[0],
                                           (tips.thumb + tips.index) / 2, foot)};
  set_attachment_times(movement, grasp, target);
  return target;
}

}  // namespace

std::optional<SceneObject> infer_target(const TargetOptions& options, const HumanMotion& motion,
                                        const Movement& movement, const SceneObject* table) {
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  if (!options.infer || !grasp) return std::nullopt;
  const GraspTips tips = tips_at_grasp(motion, *grasp);
  if (!is_known(tips.thumb) || !is_known(tips.index)) return std::nullopt;
  if (options.body) return make_target_body(options, movement, *grasp, tips, table);
  const double radius = options.radius.value_or(
      std::clamp(radius_between(options, tips), options.min_radius, options.max_radius));
  const double middle = (tips.thumb.z() + tips.index.z()) / 2;
  const double rim = rim_height(options, tips);
  const bool stands = table && rim - table_top_height(*table) <= bounds::kInferredExtent.upper;
  const double foot = stands ? table_top_height(*table) : middle - options.height / 2;
  const double height = std::max(options.height, rim - foot);
  const Vec3 midpoint = (tips.thumb + tips.index) / 2;
  SceneObject target =
      fixed_body(options.name, Shape::cylinder, {radius, height},
                 Vec3(midpoint.x(), midpoint.y(), foot + height / 2), movement.begin_s);
  if (options.radius) target.shape_origin = ObjectOrigin::configured;
  set_attachment_times(movement, *grasp, target);
  return target;
}

}  // namespace morphe::scene
