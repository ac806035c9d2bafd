#include "stages/export/lerobot/robot_episode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/files/printable.hpp"
#include "core/motion/scene.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::exports {
namespace {

constexpr double kTimeTolerance_s = 1e-9;  ///< of frames and samples at the same time

const SceneObject* target_of(const Plan& plan) {
  return find_object(plan.scene.objects, plan.movement.target);
}

/// The target along a plan: as recorded, then rigidly with the frame of the hand to which it is
/// attached, then where it was released, or where the trajectory ended. The samples at which this
/// changes are those of `verify`.
class TargetMotion {
 public:
  TargetMotion(const RobotModel& robot, const Plan& plan) : target_(*target_of(plan)) {
    const auto frame =
        std::ranges::find(robot.frames, target_.attached_frame, &RobotModel::Frame::name);
    const std::vector<double>& time = plan.trajectory.demonstration_time;
    const auto attach = std::ranges::lower_bound(time, target_.attach_s);
    if (std::isnan(target_.attach_s) || frame == robot.frames.end() || attach == time.end() ||
        *attach >= time.back())
      return;
    frame_ = static_cast<int>(frame - robot.frames.begin());
    attach_s_ = *attach;
    const auto base_from_hand = [&](auto sample) {
      std::vector<Pose> base_from_frame;
      robot::forward_kinematics(
          robot, plan.trajectory.position.row(sample - time.begin()).transpose(), base_from_frame);
      return base_from_frame[frame_];
    };
    frame_from_target_ = base_from_hand(attach).inverse() * recorded_pose(target_, attach_s_);
    auto release = std::ranges::lower_bound(time, target_.release_s);
    if (std::isnan(target_.release_s) || release == time.end())
      release = time.end() - 1;
    else
      release_s_ = *release;
    base_from_released_ = base_from_hand(release) * frame_from_target_;
  }

  /// Returns the pose at a demonstration time at which the robot's frames have these poses, during
  /// the trajectory or after it.
  Pose at(double time_s, bool has_ended, const std::vector<Pose>& base_from_frame) const {
    if (frame_ < 0 || time_s < attach_s_) return recorded_pose(target_, time_s);
    if (has_ended || time_s > release_s_) return base_from_released_;
    return base_from_frame[frame_] * frame_from_target_;
  }
  /// Returns the demonstration time from which on the hand has let go; infinite if never.
  double release_s() const { return release_s_; }

 private:
  const SceneObject& target_;
  int frame_ = -1;
  double attach_s_ = kInfinity, release_s_ = kInfinity;
  Pose frame_from_target_ = Pose::Identity(), base_from_released_ = Pose::Identity();
};

std::vector<std::string> pose_names(const std::string& body) {
  std::vector<std::string> names;
  for (const char* part : {"x", "y", "z", "qw", "qx", "qy", "qz"})
    names.push_back(fmt::format("{}.{}", body, part));
  return names;
}

std::vector<std::string> joint_names(const RobotModel& robot, const char* part) {
  std::vector<std::string> names;
  for (const std::string& joint : robot.joint_names)
    names.push_back(fmt::format("{}.{}", joint, part));
  return names;
}

/// Writes a pose to a row; the sign of the quaternion is that of the row above.
void set_pose(const Pose& pose, Eigen::Index row, JointRows& rows) {
  const Quat q(pose.linear());
  rows.row(row) << pose.translation().transpose(), q.w(), q.x(), q.y(), q.z();
  if (row > 0 && rows.row(row).tail<4>().dot(rows.row(row - 1).tail<4>()) < 0)
    rows.row(row).tail<4>() *= -1;
}

/// Returns for each tip whether its pad touches the target in the grasp, 1 or 0.
Eigen::RowVectorXd touching_tips(const RobotModel& robot, const Plan& plan) {
  Eigen::RowVectorXd touching = Eigen::RowVectorXd::Zero(std::ssize(robot.tips));
  for (const PadContact& contact : plan.grasp.contacts) {
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    if (tip != robot.tips.end() && contact.state == ContactState::touching)
      touching[tip - robot.tips.begin()] = 1;
  }
  return touching;
}

}  // namespace

OptionalFeatures optional_features(const Plan& plan) {
  const SceneObject* target = target_of(plan);
  const bool has_pose =
      target &&
      std::ranges::all_of(target->position, [](const Vec3& point) { return point.allFinite(); }) &&
      std::ranges::all_of(target->orientation,
                          [](const Quat& rotation) { return is_known(rotation); });
  return {has_pose, has_pose && plan.grasp.sample >= 0 && !plan.grasp.contacts.empty()};
}

std::vector<Feature> robot_features(const RobotModel& robot, const OptionalFeatures& optional) {
  std::vector<Feature> features{{"observation.state", joint_names(robot, "pos")},
                                {"observation.velocity", joint_names(robot, "vel")},
                                {"observation.palm", pose_names("palm")},
                                {"observation.tips", {}}};
  std::vector<std::string> contacts;
  for (const RobotModel::Tip& tip : robot.tips) {
    for (const char* axis : {"x", "y", "z"})
      features.back().names.push_back(fmt::format("{}.{}", tip.name, axis));
    contacts.push_back(tip.name + ".contact");
  }
  if (robot.tips.empty()) features.pop_back();
  if (optional.target) features.push_back({"observation.environment_state", pose_names("target")});
  if (optional.contacts) features.push_back({"observation.contact", contacts});
  features.push_back({"action", joint_names(robot, "pos")});
  features.push_back({"phase", {"phase"}, true});
  return features;
}

Episode robot_episode(const RobotModel& robot, const Plan& plan, const EpisodeMotion& motion,
                      const OptionalFeatures& optional) {
  const Trajectory& frames = motion.frames;
  const Eigen::Index count = std::ssize(frames.time), tips = std::ssize(robot.tips);
  JointRows palm(count, 7), tip_positions(count, 3 * tips), target(count, 7),
      contact = JointRows::Zero(count, tips), action(count, frames.position.cols()),
      phase(count, 1);
  action << frames.position.bottomRows(count - 1), frames.position.bottomRows(1);
  std::optional<TargetMotion> target_motion;
  if (optional.target) target_motion.emplace(robot, plan);
  const Eigen::RowVectorXd touching = touching_tips(robot, plan);
  std::vector<Pose> base_from_frame;
  for (Eigen::Index k = 0; k < count; ++k) {
    robot::forward_kinematics(robot, frames.position.row(k).transpose(), base_from_frame);
    set_pose(base_from_frame[robot.palm_frame], k, palm);
    for (Eigen::Index tip = 0; tip < tips; ++tip)
      tip_positions.block<1, 3>(k, 3 * tip) =
          robot::tip_pose(robot, base_from_frame, tip).translation().transpose();
    phase(k, 0) = static_cast<double>(frames.phase[k]);
    if (!target_motion) continue;
    const double time_s = frames.demonstration_time[k];
    const bool has_ended = frames.time[k] > motion.end_s + kTimeTolerance_s;
    const bool has_grasped = frames.time[k] >= motion.grasp_s - kTimeTolerance_s;
    set_pose(target_motion->at(time_s, has_ended, base_from_frame), k, target);
    if (has_grasped && !has_ended && time_s <= target_motion->release_s())
      contact.row(k) = touching;
  }
  Episode episode{task_sentence(plan), {frames.position, frames.velocity, palm}};
  if (tips > 0) episode.values.push_back(tip_positions);
  if (optional.target) episode.values.push_back(target);
  if (optional.contacts) episode.values.push_back(contact);
  episode.values.push_back(action);
  episode.values.push_back(phase);
  return episode;
}

std::string task_sentence(const Plan& plan) {
  const std::string take =
      plan.movement.target.empty()
          ? fmt::format("reach with the {} hand", name_of(plan.hand))
          : fmt::format("take {} with the {} hand", plan.movement.target, name_of(plan.hand));
  return files::make_printable(plan.task.empty() ? take : fmt::format("{}: {}", plan.task, take));
}

}  // namespace morphe::exports
