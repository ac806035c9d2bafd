#include "stages/verify/placement.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

constexpr double kPlacementTolerance = 1e-6;

/// Returns the deviation of a point; infinite if only one of the two is known.
double point_error(const Vec3& stored, const Vec3& expected) {
  if (!is_known(stored) || !is_known(expected))
    return is_known(stored) == is_known(expected) ? 0 : kInfinity;
  return (stored - expected).cwiseAbs().maxCoeff();
}

class PlacementVerifier {
 public:
  PlacementVerifier(const RobotModel& robot, const Plan& plan, const PlanRequest& request,
                    ViolationLog& violations)
      : robot_(robot), plan_(plan), asked_(request.placement), violations_(violations) {
    frame_poses(robot, JointVector::Zero(robot.joints()), at_zero_);
  }

  void run() {
    check("reference_frames/recording", recording_error());
    check("reference_frames/shoulder",
          point_error(plan_.reference_frames.shoulder, shoulder_in_base()));
    check("common_base_offset", point_error(plan_.goals.common_base_offset,
                                            asked_.hand_only ? Vec3(Vec3::Zero()) : arm_offset()));
    check("base_offset", base_offset_excess());
    if (asked_.hand_only) return;
    const std::vector<Vec3>& shoulders = plan_.goals.shoulder_position;
    const auto seen = std::ranges::find_if(shoulders, [](const Vec3& s) { return is_known(s); });
    if (seen != shoulders.end())
      check("goals/shoulder_position", point_error(*seen, robot_shoulder()));
  }

 private:
  Vec3 robot_shoulder() const { return at_zero_[robot_.shoulder_frame].translation(); }
  /// Returns the requested offset with that of the movement, in the world's axes.
  Vec3 offset_in_world() const {
    return asked_.shoulder_offset + plan_.goals.base_offset.value_or(Vec3::Zero());
  }
  /// Returns the translation of the human arm onto the robot's shoulder, in the base frame.
  Vec3 arm_offset() const { return asked_.world_from_base.transpose() * offset_in_world(); }
  /// Returns the person's shoulder; unknown for a hand alone.
  Vec3 shoulder_in_base() const {
    return asked_.hand_only ? unknown_point() : Vec3(robot_shoulder() - arm_offset());
  }

  double recording_error() const {
    const Pose& stored = plan_.reference_frames.base_from_world;
    if (!is_known(stored)) return kInfinity;
    const Eigen::Matrix3d turn = stored.linear() - asked_.world_from_base.transpose();
    if (!asked_.hand_only) return turn.cwiseAbs().maxCoeff();
    Pose hand_from_palm = Pose::Identity();
    hand_from_palm.linear() = asked_.world_from_base;
    hand_from_palm.translation() = offset_in_world();
    const Pose expected = at_zero_[robot_.palm_frame] * hand_from_palm.inverse();
    return (stored.matrix() - expected.matrix()).cwiseAbs().maxCoeff();
  }

  double base_offset_excess() const {
    const std::optional<Vec3>& offset = plan_.goals.base_offset;
    if (offset.has_value() != (asked_.base_offset_limit > 0)) return kInfinity;
    return offset ? offset->cwiseAbs().maxCoeff() - asked_.base_offset_limit : 0;
  }

  void check(const char* name, double error) {
    if (!(error <= kPlacementTolerance))
      violations_.note_plan("config", name, error, kPlacementTolerance);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const PlanRequest::Placement& asked_;
  ViolationLog& violations_;
  std::vector<Pose> at_zero_;
};

}  // namespace

void verify_placement(const RobotModel& robot, const Plan& plan, const PlanRequest& request,
                      ViolationLog& violations) {
  PlacementVerifier(robot, plan, request, violations).run();
}

}  // namespace morphe::verify
