#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

/// The smallest part of a joint's range that a command leaves out and a note mentions.
constexpr double kOmittedRange = 0.01;

double largest(const std::vector<double>& range) {
  double value = 0;
  for (const double end : range) value = std::max(value, std::abs(end));
  return value;
}

/// Returns the largest force of an actuator on its joint, 0 if it is not limited.
double force_on_joint(const MjcfElement& actuator) {
  const std::vector<double> gear = actuator.numbers("gear", 1, 6);
  const double ratio = gear.empty() ? 1 : std::abs(gear.front());
  if (actuator.truth("forcelimited").value_or(true)) {
    if (const double force = largest(actuator.numbers("forcerange", 2, 2)); force > 0)
      return ratio * force;
  }
  const bool is_motor = std::string_view(actuator.xml.Value()) == "motor";
  if (!is_motor || !actuator.truth("ctrllimited").value_or(true)) return 0;
  return ratio * largest(actuator.numbers("ctrlrange", 2, 2));
}

/// Returns true if a position actuator commands less than the range of its joint.
bool commands_less(const MjcfElement& actuator, const MjcfJoint& joint) {
  if (std::string_view(actuator.xml.Value()) != "position" || !joint.range) return false;
  const std::vector<double> command = actuator.numbers("ctrlrange", 2, 2);
  if (largest(command) == 0 || !actuator.truth("ctrllimited").value_or(true)) return false;
  const std::vector<double> gear = actuator.numbers("gear", 1, 6);
  const double ratio = gear.empty() || gear.front() == 0 ? 1 : gear.front();
  const double a = command[0] / ratio, b = command[1] / ratio;
  const auto [lower, upper] = *joint.range;
  const double left_out =
      std::max(0.0, std::min(a, b) - lower) + std::max(0.0, upper - std::max(a, b));
  return left_out > kOmittedRange * (upper - lower);
}

/// The joints of each fixed tendon; those of a spatial one are unknown, its list is empty.
using TendonJoints = std::map<std::string, std::vector<std::string>>;

TendonJoints read_tendons(const MjcfSource& source) {
  TendonJoints tendons;
  for (const files::XmlElement* section : source.file.sections("tendon")) {
    for (const files::XmlElement* xml : source.file.elements(*section)) {
      std::vector<std::string>& joints = tendons[MjcfElement{source, *xml}.name()];
      for (const files::XmlElement* joint : source.file.elements(*xml, "joint"))
        joints.push_back(MjcfElement{source, *joint}.own("joint"));
    }
  }
  return tendons;
}

/// The actuators that a URDF cannot express, as parts of sentences, and the joints that all drive.
struct ActuatorReport {
  std::vector<std::string> through_tendons, others, narrow;
  std::set<std::string> driven;
};

void read_tendon_actuator(const MjcfElement& actuator, const TendonJoints& tendons,
                          const MjcfJointIndex& joints, ActuatorReport& report) {
  const std::string tendon = actuator.own("tendon");
  const auto found = tendons.find(tendon);
  if (found == tendons.end())
    actuator.fail("tendon", fmt::format("there is no tendon '{}'", tendon));
  std::vector<std::string> independent;
  for (const std::string& name : found->second) {
    const auto joint = joints.find(name);
    if (joint != joints.end() && !joint->second->coupling) independent.push_back(name);
    report.driven.insert(name);
  }
  const std::string name = actuator.name().empty() ? tendon : actuator.name();
  if (found->second.empty()) report.others.push_back(name);
  if (independent.size() > 1)
    report.through_tendons.push_back(fmt::format("{} ({})", name, fmt::join(independent, ", ")));
}

void read_actuator(const MjcfElement& actuator, const TendonJoints& tendons,
                   const MjcfJointIndex& joints, ActuatorReport& report) {
  if (!actuator.own("tendon").empty())
    return read_tendon_actuator(actuator, tendons, joints, report);
  const std::string attribute = actuator.own("joint").empty() ? "jointinparent" : "joint";
  const std::string name = actuator.own(attribute.c_str());
  const auto found = joints.find(name);
  if (found == joints.end()) {
    report.others.push_back(actuator.name().empty() ? actuator.xml.Value() : actuator.name());
    return;
  }
  MjcfJoint* const joint = found->second;
  report.driven.insert(name);
  if (commands_less(actuator, *joint)) report.narrow.push_back(joint->name);
  const double force = force_on_joint(actuator);
  if (force > 0) joint->effort = std::min(force, joint->effort.value_or(force));
}

/// Asks about joints without an actuator in a file that has actuators: they may be passive, such
/// as those of a linkage whose loop is left open.
void ask_about_passive_joints(const std::set<std::string>& driven, MjcfModel& model) {
  std::vector<std::string> passive;
  for (const MjcfBody& body : model.bodies)
    for (const MjcfJoint& joint : body.joints)
      if (!is_driven(model, joint, driven)) passive.push_back(joint.name);
  if (passive.empty()) return;
  model.to_check.push_back(
      fmt::format("joints of {} have no actuator, but are taken as driven: {}; hold passive ones "
                  "with `fixed_joints`, or couple them with an equality in the MJCF",
                  model.file.string(), fmt::join(passive, ", ")));
}

}  // namespace

bool is_driven(const MjcfModel& model, const MjcfJoint& joint,
               const std::set<std::string>& driven) {
  if (joint.coupling || driven.contains(joint.name)) return true;
  for (const MjcfBody& body : model.bodies) {
    for (const MjcfJoint& follower : body.joints) {
      if (follower.coupling && follower.coupling->driver == joint.name &&
          driven.contains(follower.name))
        return true;
    }
  }
  return false;
}

void read_mjcf_actuators(const MjcfSource& source, MjcfModel& model) {
  const TendonJoints tendons = read_tendons(source);
  const MjcfJointIndex joints = joints_by_name(model);
  ActuatorReport report;
  for (const files::XmlElement* section : source.file.sections("actuator"))
    for (const files::XmlElement* xml : source.file.elements(*section))
      read_actuator({source, *xml}, tendons, joints, report);
  close_mjcf_loops(report.driven, model);
  if (!report.driven.empty()) ask_about_passive_joints(report.driven, model);
  const auto note = [&](const char* text, const std::vector<std::string>& names) {
    if (names.empty()) return;
    model.notes.push_back(
        fmt::format("{}: {}: {}", source.file.path().string(), text, fmt::join(names, ", ")));
  };
  note(
      "one actuator drives several joints through a tendon, which a URDF cannot express; they are "
      "taken as independent",
      report.through_tendons);
  note("actuators of no hinge or slide are left out", report.others);
  note("the actuators command less than the joint's range, which is taken", report.narrow);
}

}  // namespace morphe::robot
