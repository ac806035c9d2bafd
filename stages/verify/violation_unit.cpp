#include "stages/verify/violation_unit.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace morphe::verify {
namespace {

/// A unit and the quantities that have it.
struct UnitOf {
  std::string_view unit;
  std::set<std::string_view> names;
};

std::string unit_in(const std::vector<UnitOf>& units, std::string_view name) {
  const auto has_name = [&](const UnitOf& entry) { return entry.names.contains(name); };
  const auto found = std::ranges::find_if(units, has_name);
  return found == units.end() ? "" : std::string(found->unit);
}

/// Returns true for a prismatic joint, or a prismatic frame with limits of its own.
bool is_prismatic(const RobotModel& robot, const std::string& subject) {
  return std::ranges::any_of(robot.frames, [&](const RobotModel::Frame& frame) {
    const bool named =
        frame.name == subject || (frame.joint >= 0 && robot.joint_names[frame.joint] == subject);
    return named && frame.prismatic;
  });
}

}  // namespace

std::string unit_of(const RobotModel& robot, const Violation& violation) {
  static const std::map<std::string_view, std::string_view> joint_units = {{"position", ""},
                                                                           {"velocity", "/s"},
                                                                           {"acceleration", "/s^2"},
                                                                           {"jerk", "/s^3"},
                                                                           {"rest", "/s or /s^2"}};
  static const std::vector<UnitOf> cause_units = {
      {"m", {"tracking", "self_collision", "object_collision", "release"}}, {"s", {"time"}}};
  static const std::set<std::string_view> grasp_causes = {"grasp", "contact", "quality",
                                                          "grasp_force"};
  static const std::vector<UnitOf> grasp_units = {
      {"m",
       {"tips_in_object", "desired_point", "demonstrated_point", "point", "pad", "signed_distance",
        "penetration", "held_drift", "torsional_friction", "centre_of_mass",
        "characteristic_length"}},
      {"rad", {"held_turn", "grasp_posture", "normal", "pad_angle", "servo_target", "trajectory"}},
      {"kg", {"mass"}},
      {"s", {"opposed"}},
      {"N",
       {"required_force_worst", "required_force_gravity", "available_force", "normal_force",
        "friction_cone", "force_balance"}},
      {"N m", {"torque"}}};
  static const std::vector<UnitOf> subject_units = {
      {"m",
       {"max_tip_error", "clearance", "tip_error_max", "tip_error_mean", "tip_error_grasp",
        "held_drift"}},
      {"s", {"max_goal_gap_s", "delivered_until", "requested_end_s"}},
      {"rad",
       {"tip_orientation_error_max", "upper_arm_error_mean", "upper_arm_error_max",
        "forearm_error_mean", "forearm_error_max", "swivel_error_mean", "swivel_error_max",
        "palm_error_mean", "palm_error_max", "held_turn"}},
      {"m^2", {"humanlikeness_mapped", "humanlikeness_final"}}};
  const auto joint = joint_units.find(violation.cause);
  if (joint != joint_units.end())
    return (is_prismatic(robot, violation.subject) ? "m" : "rad") + std::string(joint->second);
  if (violation.cause == "status" || violation.cause == "certificate")
    return unit_in(subject_units, violation.subject);
  if (grasp_causes.contains(violation.cause))
    return unit_in(grasp_units, violation.subject.substr(violation.subject.rfind('/') + 1));
  return unit_in(cause_units, violation.cause);
}

}  // namespace morphe::verify
