#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

MjcfJoint& joint_of(const MjcfElement& element, const char* attribute,
                    const MjcfJointIndex& joints) {
  const std::string name = element.own(attribute);
  const auto found = joints.find(name);
  if (found == joints.end())
    element.fail(attribute, fmt::format("there is no hinge or slide '{}'", name));
  return *found->second;
}

/// Returns true if `joint` is this one or follows it through couplings.
bool follows(const MjcfJointIndex& joints, const MjcfJoint& joint, const std::string& leader) {
  const MjcfJoint* next = &joint;
  while (next->name != leader) {
    if (!next->coupling || next->coupling->driver.empty()) return false;
    next = joints.at(next->coupling->driver);
  }
  return true;
}

/// Couples two joints, q1 - ref1 = a0 + a1 (q2 - ref2) + …, of which only the linear part is taken.
void read_joint_equality(const MjcfElement& element, const MjcfJointIndex& joints,
                         std::vector<std::string>& notes) {
  MjcfJoint& joint = joint_of(element, "joint1", joints);
  const auto note = [&](const std::string& text) {
    notes.push_back(fmt::format("{}: equality of joint {}: {}",
                                element.source.file.place(element.xml), joint.name, text));
  };
  std::vector<double> polynomial = element.numbers("polycoef", 1, 5);
  if (polynomial.empty()) polynomial = {0, 1};
  polynomial.resize(5, 0);
  if (joint.coupling) return note("is left out, as the joint already follows another");
  MjcfCoupling coupling;
  coupling.offset = joint.reference + polynomial[0];
  if (!element.own("joint2").empty() && polynomial[1] != 0) {
    const MjcfJoint& driver = joint_of(element, "joint2", joints);
    if (follows(joints, driver, joint.name))
      return note(fmt::format("is left out, as joint {} already follows it", driver.name));
    coupling.driver = driver.name;
    coupling.ratio = polynomial[1];
    coupling.offset -= polynomial[1] * driver.reference;
  }
  if (std::any_of(polynomial.begin() + 2, polynomial.end(), [](double a) { return a != 0; }))
    note("only the constant and the linear coefficient of polycoef are taken");
  joint.coupling = std::move(coupling);
}

std::string ends_of(const MjcfElement& element) {
  for (const auto& [first, second] : {std::pair{"body1", "body2"}, std::pair{"site1", "site2"},
                                      std::pair{"tendon1", "tendon2"}}) {
    const std::string one = element.own(first), other = element.own(second);
    if (!one.empty()) return fmt::format("{}-{}", one, other.empty() ? "world" : other);
  }
  return element.name().empty() ? element.xml.Value() : element.name();
}

int body_index(const MjcfElement& element, const char* attribute, const MjcfModel& model) {
  const std::string name = element.own(attribute);
  if (name.empty() || name == kMjcfWorld) return -1;
  const auto found = std::ranges::find(model.bodies, name, &MjcfBody::name);
  if (found == model.bodies.end())
    element.fail(attribute, fmt::format("there is no body '{}' in the robot", name));
  return static_cast<int>(found - model.bodies.begin());
}

/// Returns the pose of a body in the world with all joints at their reference.
Pose reference_pose(const MjcfModel& model, int body) {
  Pose pose = Pose::Identity();
  for (; body >= 0; body = model.bodies[body].parent)
    pose = model.bodies[body].parent_from_body * pose;
  return pose;
}

/// Reads a point that is the same of both bodies with all joints at their reference.
MjcfLoop read_connect(const MjcfElement& element, const MjcfModel& model) {
  MjcfLoop loop;
  loop.name = ends_of(element);
  loop.first = body_index(element, "body1", model);
  loop.second = body_index(element, "body2", model);
  loop.point_in_first = element.vector("anchor", Vec3::Zero());
  loop.point_in_second = reference_pose(model, loop.second).inverse() *
                         reference_pose(model, loop.first) * loop.point_in_first;
  return loop;
}

}  // namespace

void read_mjcf_equalities(const MjcfSource& source, MjcfModel& model) {
  const MjcfJointIndex joints = joints_by_name(model);
  std::vector<std::string> others;
  for (const files::XmlElement* section : source.file.sections("equality")) {
    for (const files::XmlElement* xml : source.file.elements(*section)) {
      const MjcfElement element{source, *xml};
      const std::string_view tag = xml->Value();
      if (element.truth("active") == false) continue;
      if (tag == "joint")
        read_joint_equality(element, joints, model.notes);
      else if (tag == "connect" && !element.own("body1").empty())
        model.loops.push_back(read_connect(element, model));
      else
        others.push_back(ends_of(element));
    }
  }
  if (!others.empty())
    model.notes.push_back(fmt::format("{}: equalities are left out: {}",
                                      source.file.path().string(), fmt::join(others, ", ")));
}

}  // namespace morphe::robot
