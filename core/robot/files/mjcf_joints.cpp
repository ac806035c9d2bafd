#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

/// Returns the range if it limits the joint, in rad or m.
std::optional<std::array<double, 2>> limiting_range(const MjcfElement& element, double unit,
                                                    const std::string& name,
                                                    std::vector<std::string>& notes) {
  const std::vector<double> range = element.numbers("range", 2, 2);
  const std::optional<bool> limited = element.truth("limited");
  const bool given = !range.empty() && (range[0] != 0 || range[1] != 0);
  if (limited == true && range.empty()) element.fail("range", "is missing, although limited");
  if (!limited.value_or(given)) return std::nullopt;
  if (range[0] > range[1]) element.fail("range", "must not end below its begin");
  if (!limited && !element.source.settings.limits_by_range) {
    notes.push_back(
        fmt::format("{}: joint {}: its range is taken as its limits, although autolimits is false "
                    "and `limited` "
                    "is missing",
                    element.source.file.place(element.xml), name));
  }
  return std::array{range[0] * unit, range[1] * unit};
}

}  // namespace

MjcfJoint read_mjcf_joint(const MjcfElement& element, std::vector<std::string>& notes) {
  MjcfJoint joint;
  joint.name = element.name();
  joint.slides = element.text_or("type", "hinge") == "slide";
  joint.anchor = element.vector("pos", Vec3::Zero());
  joint.axis = element.vector("axis", Vec3::UnitZ());
  if (!(joint.axis.norm() > 0)) element.fail("axis", "must not be zero");
  joint.axis.normalize();
  const double unit = joint.slides ? 1 : element.source.settings.rad_per_angle;
  joint.reference = unit * element.number("ref", 0);
  joint.range = limiting_range(element, unit, joint.name, notes);
  joint.stiffness = std::max(0.0, element.number("stiffness", 0));
  joint.spring_reference = unit * element.number("springref", 0);
  const std::vector<double> force = element.numbers("actuatorfrcrange", 2, 2);
  if (!force.empty() && element.truth("actuatorfrclimited").value_or(true))
    joint.effort = std::max(std::abs(force[0]), std::abs(force[1]));
  return joint;
}

Pose MjcfJoint::motion(double position) const {
  Pose pose = Pose::Identity();
  if (slides) {
    pose.translation() = (position - reference) * axis;
    return pose;
  }
  pose.linear() = Eigen::AngleAxisd(position - reference, axis).toRotationMatrix();
  pose.translation() = anchor - pose.linear() * anchor;
  return pose;
}

MjcfJointIndex joints_by_name(MjcfModel& model) {
  MjcfJointIndex index;
  for (MjcfBody& body : model.bodies)
    for (MjcfJoint& joint : body.joints) index.emplace(joint.name, &joint);
  return index;
}

UrdfInertia read_mjcf_inertial(const MjcfElement& element) {
  UrdfInertia inertia;
  inertia.mass = element.number("mass", 0);
  if (!(inertia.mass >= 0)) element.fail("mass", "must not be negative");
  inertia.link_from_inertia = element.pose();
  const std::vector<double> diagonal = element.numbers("diaginertia", 3, 3);
  const std::vector<double> full = element.numbers("fullinertia", 6, 6);
  if (!diagonal.empty()) {
    inertia.inertia = Vec3(diagonal[0], diagonal[1], diagonal[2]).asDiagonal();
  } else if (!full.empty()) {
    inertia.inertia << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5],
        full[2];
  }
  return inertia;
}

}  // namespace morphe::robot
