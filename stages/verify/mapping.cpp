#include "stages/verify/mapping.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/goal_errors.hpp"
#include "stages/verify/pad.hpp"

namespace morphe::verify {
namespace {

constexpr double kMappedTolerance = 1e-6;
constexpr double kGoalMetTolerance_m = 0.001, kRoundingTolerance_m = 1e-9;

/// The largest relative difference in a column; infinite where one of two values only is NaN.
struct LargestDifference {
  double difference = 0, stored = 0, recomputed = 0;
  void compare(double stored_value, double own_value) {
    if (std::isnan(stored_value) && std::isnan(own_value)) return;
    const double relative = std::abs(stored_value - own_value) / std::max(1.0, std::abs(own_value));
    if (relative <= difference) return;
    difference = std::isnan(relative) ? kInfinity : relative;
    stored = stored_value;
    recomputed = own_value;
  }
  void note(const char* subject, ViolationLog& violations) const {
    if (difference > kMappedTolerance) violations.note_plan("mapped", subject, stored, recomputed);
  }
};

class MappingVerifier {
 public:
  MappingVerifier(const RobotModel& robot, const Plan& plan)
      : robot_(robot), plan_(plan), pads_(pad_spheres(robot)) {}

  void run(ViolationLog& violations) {
    for (int frame = 0; frame < std::ssize(plan_.goals.time); ++frame) verify_frame(frame);
    position_.note("tip_error", violations);
    orientation_.note("tip_orientation_error", violations);
    humanlikeness_.note("humanlikeness", violations);
    status_.note("status", violations);
  }

 private:
  void verify_frame(int frame) {
    const MappingResult& mapped = plan_.mapped;
    frame_poses(robot_, mapped.position.row(frame).transpose(), poses_);
    bool seen = false, met = true, nearly_met = true, in_reach = true;
    for (int tip = 0; tip < std::ssize(robot_.tips); ++tip) {
      orientation_.compare(mapped.tip_orientation_error(frame, tip), rotation_error(frame, tip));
      const double error = position_error(frame, tip);
      position_.compare(mapped.tip_error(frame, tip), error);
      if (std::isnan(error)) continue;
      seen = true;
      met = met && error < kGoalMetTolerance_m - kRoundingTolerance_m;
      nearly_met = nearly_met && error < kGoalMetTolerance_m + kRoundingTolerance_m;
      in_reach = in_reach && plan_.goals.reachable(frame, tip) != 0;
    }
    const FrameStatus missed = in_reach ? FrameStatus::compromise : FrameStatus::out_of_reach;
    const FrameStatus own = !seen ? FrameStatus::no_goal : met ? FrameStatus::met : missed;
    const FrameStatus stored = mapped.status[frame];
    const bool agrees = stored == own || (seen && nearly_met && stored == FrameStatus::met);
    if (!agrees) status_.compare(static_cast<double>(stored), static_cast<double>(own));
    humanlikeness_.compare(mapped.humanlikeness(frame, 0), humanlikeness(frame));
  }

  double position_error(int frame, int tip) const {
    const Goals& goals = plan_.goals;
    const Vec3& goal = goals.tip_position(frame, tip);
    if (!is_known(goal)) return kUnknown;
    const Vec3 tracked = tracked_point(robot_, pads_, goals, tip, goals.time[frame]);
    return (to_base_frame(poses_, robot_.tips[tip].frame, tracked) - goal).norm();
  }

  double rotation_error(int frame, int tip) const {
    const Quat& goal = plan_.goals.tip_orientation(frame, tip);
    const RobotModel::Tip& own = robot_.tips[tip];
    return is_known(goal) ? rotation_angle(poses_[own.frame] * own.transform, goal.coeffs())
                          : kUnknown;
  }

  double humanlikeness(int frame) const {
    const Vec3& elbow = plan_.goals.elbow_position[frame];
    const bool has_arm =
        find_index(robot_.joint_centres, "arm", &RobotModel::JointCentre::chain) >= 0;
    return has_arm && is_known(elbow) ? squared_elbow_distances(robot_, poses_, elbow) : kUnknown;
  }

  const RobotModel& robot_;
  const Plan& plan_;
  std::vector<PadSphere> pads_;
  std::vector<Pose> poses_;
  LargestDifference position_, orientation_, humanlikeness_, status_;
};

}  // namespace

void verify_mapping(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const MappingResult& mapped = plan.mapped;
  const Eigen::Index frames = std::ssize(plan.goals.time), tips = std::ssize(robot.tips);
  const auto has_shape = [&](const JointRows& table, Eigen::Index cols) {
    return table.rows() == frames && table.cols() == cols;
  };
  const bool complete = mapped.position.rows() == frames && has_shape(mapped.tip_error, tips) &&
                        has_shape(mapped.tip_orientation_error, tips) &&
                        has_shape(mapped.humanlikeness, 3) && std::ssize(mapped.status) == frames &&
                        mapped.position.allFinite();
  if (!complete) {
    violations.note_plan("mapped", "position", static_cast<double>(mapped.position.rows()),
                         static_cast<double>(frames));
    return;
  }
  if (!std::ranges::all_of(mapped.objective, [](double value) { return std::isfinite(value); }))
    violations.note_plan("mapped", "objective", kUnknown, kUnknown);
  MappingVerifier(robot, plan).run(violations);
}

}  // namespace morphe::verify
