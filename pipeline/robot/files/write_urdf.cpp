#include "pipeline/robot/files/write_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/files/markup.hpp"

namespace morphe::robot {
namespace {

std::string numbers(const Vec3& v) {
  const Vec3 positive = v.array() + 0.0;  // no -0
  return fmt::format("{} {} {}", positive.x(), positive.y(), positive.z());
}

/// Roll, pitch, yaw with R = Rz(yaw) Ry(pitch) Rx(roll), exact at pitch ±90 degrees too: what yaw
/// cannot tell there, roll takes up.
Vec3 rpy_of(const Eigen::Matrix3d& r) {
  const double yaw = std::atan2(r(1, 0), r(0, 0));
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  const Eigen::Matrix3d rolled =
      (Eigen::AngleAxisd(-pitch, Vec3::UnitY()) * Eigen::AngleAxisd(-yaw, Vec3::UnitZ()))
          .toRotationMatrix() *
      r;
  return {std::atan2(rolled(2, 1), rolled(1, 1)), pitch, yaw};
}

std::string origin(const Pose& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers(pose.translation()),
                     numbers(rpy_of(pose.linear())));
}

std::string shape(const std::string& name, const Pose& pose, const std::string& geometry) {
  return fmt::format("    <collision name=\"{}\">{}<geometry>{}</geometry></collision>\n",
                     files::xml_escaped(name), origin(pose), geometry);
}

std::string capsule_shapes(const RobotTable::Capsule& capsule) {
  const auto sphere = [&](const std::string& name, const Vec3& at) {
    return shape(name, make_pose(at, Quat::Identity()),
                 fmt::format("<sphere radius=\"{}\"/>", capsule.radius));
  };
  const Vec3 axis = capsule.to - capsule.from;
  if (axis.isZero(0)) return sphere(capsule.name, capsule.from);
  Pose middle = Pose::Identity();
  middle.translation() = 0.5 * (capsule.from + capsule.to);
  middle.linear().col(2) = axis.normalized();
  middle.linear().col(0) = axis.unitOrthogonal();
  middle.linear().col(1) = middle.linear().col(2).cross(middle.linear().col(0));
  return shape(
             capsule.name, middle,
             fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", capsule.radius, axis.norm())) +
         sphere(capsule.name + "_from", capsule.from) + sphere(capsule.name + "_to", capsule.to);
}

std::string link(const RobotTable& robot, const std::string& name, int frame) {
  std::string shapes;
  for (const RobotTable::Capsule& capsule : robot.capsules) {
    if (capsule.frame == frame) shapes += capsule_shapes(capsule);
  }
  if (shapes.empty()) return fmt::format("  <link name=\"{}\"/>\n", files::xml_escaped(name));
  return fmt::format("  <link name=\"{}\">\n{}  </link>\n", files::xml_escaped(name), shapes);
}

std::string joint(const std::string& name, const char* type, const std::string& parent,
                  const Pose& pose, const std::string& more) {
  return fmt::format(
      "  <joint name=\"{0}\" type=\"{1}\">\n    <parent link=\"{2}\"/>\n    <child link=\"{0}\"/>\n"
      "    {3}\n{4}  </joint>\n",
      files::xml_escaped(name), type, files::xml_escaped(parent), origin(pose), more);
}

/// Of the root link, which is no frame: one that no frame has.
std::string root_name(const RobotTable& robot) {
  std::string name = "base";
  const auto taken = [&] {
    return std::ranges::count(robot.frames, name, &RobotTable::Frame::name);
  };
  while (taken() > 0) name += "_root";
  return name;
}

std::string parent_name(const RobotTable& robot, int frame) {
  return frame < 0 ? root_name(robot) : robot.frames[static_cast<std::size_t>(frame)].name;
}

/// A joint that turns; `driven` by its own angle, else by that of another.
std::string turning(const RobotTable& robot, const RobotTable::Frame& frame, bool driven) {
  Pose pose = frame.transform;
  const Eigen::Index k = frame.joint;
  std::string more = fmt::format("    <axis xyz=\"{}\"/>\n", numbers(frame.axis));
  double lower = robot.lower[k], upper = robot.upper[k];
  if (driven) {
    if (frame.slides) {
      pose = pose * Eigen::Translation3d(frame.offset * frame.axis);
    } else {
      pose = pose * Eigen::AngleAxisd(frame.offset, frame.axis);
    }
  } else {
    lower = frame.ratio * robot.lower[k] + frame.offset;
    upper = frame.ratio * robot.upper[k] + frame.offset;
    more += fmt::format("    <mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
                        files::xml_escaped(robot.joint_names[static_cast<std::size_t>(k)]),
                        frame.ratio, frame.offset);
  }
  more += fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"0\" velocity=\"{}\"/>\n",
                      std::min(lower, upper), std::max(lower, upper),
                      std::abs(frame.ratio) * robot.velocity[k]);
  return joint(frame.name, frame.slides ? "prismatic" : "revolute",
               parent_name(robot, frame.parent), pose, more);
}

}  // namespace

std::string urdf_of(const RobotTable& robot) {
  std::string text =
      fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", files::xml_escaped(robot.name));
  text += link(robot, root_name(robot), -1);
  std::set<int> driven;
  std::set<std::string> names = {root_name(robot)};
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const RobotTable::Frame& frame = robot.frames[i];
    text += frame.joint < 0
                ? joint(frame.name, "fixed", parent_name(robot, frame.parent), frame.transform, "")
                : turning(robot, frame, driven.insert(frame.joint).second);
    text += link(robot, frame.name, static_cast<int>(i));
    names.insert(frame.name);
  }
  for (const RobotTable::Tip& tip : robot.tips) {
    std::string name = tip.name;
    while (!names.insert(name).second) name += "_tip";
    text += joint(name, "fixed", parent_name(robot, tip.frame), tip.transform, "");
    text += link(robot, name, static_cast<int>(robot.frames.size()));
  }
  return text + "</robot>\n";
}

}  // namespace morphe::robot
