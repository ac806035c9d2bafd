#include "stages/verify/violation_unit.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace morphe::verify {
namespace {

using Units = std::map<std::string_view, std::string_view, std::less<>>;

std::string unit_in(const Units& units, std::string_view name) {
  const auto found = units.find(name);
  return found == units.end() ? "" : std::string(found->second);
}

/// Returns true for a prismatic joint, or a prismatic coupled frame that is checked against its own
/// limits.
bool is_prismatic(const RobotModel& robot, const std::string& subject) {
  return std::ranges::any_of(robot.frames, [&](const RobotModel::Frame& frame) {
    const bool named =
        frame.name == subject || (frame.joint >= 0 && robot.joint_names[frame.joint] == subject);
    return named && frame.prismatic;
  });
}

}  // namespace

std::string unit_of(const RobotModel& robot, const Violation& violation) {
  static const Units of_joint = {{"position", ""},
                                 {"velocity", "/s"},
                                 {"acceleration", "/s^2"},
                                 {"jerk", "/s^3"},
                                 {"rest", "/s or /s^2"}};
  static const Units of_cause = {
      {"tracking", "m"}, {"self_collision", "m"}, {"object_collision", "m"}, {"time", "s"}};
  static const std::set<std::string_view, std::less<>> of_the_grasp = {"grasp", "contact",
                                                                       "quality", "grasp_force"};
  static const Units of_grasp = {{"tips_in_object", "m"},
                                 {"grasp_posture", "rad"},
                                 {"desired_point", "m"},
                                 {"point", "m"},
                                 {"pad", "m"},
                                 {"signed_distance", "m"},
                                 {"penetration", "m"},
                                 {"normal", "rad"},
                                 {"pad_angle", "rad"},
                                 {"torsional_friction", "m"},
                                 {"mass", "kg"},
                                 {"centre_of_mass", "m"},
                                 {"characteristic_length", "m"},
                                 {"required_force_worst", "N"},
                                 {"required_force_gravity", "N"},
                                 {"available_force", "N"},
                                 {"normal_force", "N"},
                                 {"friction_cone", "N"},
                                 {"force_balance", "N"},
                                 {"torque", "N m"},
                                 {"servo_target", "rad"},
                                 {"trajectory", "rad"}};
  static const Units of_subject = {
      {"max_tip_error", "m"},          {"clearance", "m"},
      {"tip_error_max", "m"},          {"tip_error_mean", "m"},
      {"tip_error_grasp", "m"},        {"tip_orientation_error_max", "rad"},
      {"upper_arm_error_mean", "rad"}, {"upper_arm_error_max", "rad"},
      {"humanlikeness_mapped", "m^2"}, {"humanlikeness_final", "m^2"}};
  const auto joint = of_joint.find(violation.cause);
  if (joint != of_joint.end()) {
    return (is_prismatic(robot, violation.subject) ? "m" : "rad") + std::string(joint->second);
  }
  if (violation.cause == "status" || violation.cause == "certificate") {
    return unit_in(of_subject, violation.subject);
  }
  if (of_the_grasp.contains(violation.cause)) {
    return unit_in(of_grasp, violation.subject.substr(violation.subject.rfind('/') + 1));
  }
  return unit_in(of_cause, violation.cause);
}

}  // namespace morphe::verify
