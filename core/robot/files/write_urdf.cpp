#include "core/robot/files/write_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/files/markup.hpp"
#include "core/robot/files/urdf_extras.hpp"
#include "core/robot/files/urdf_text.hpp"

namespace morphe::robot {
namespace {

std::string shape(const std::string& name, const Pose& pose, const std::string& geometry) {
  return fmt::format("    <collision name=\"{}\">{}<geometry>{}</geometry></collision>\n",
                     files::escape_xml(name), urdf_origin(pose), geometry);
}

std::string capsule_shapes(const RobotModel::Capsule& capsule) {
  const auto sphere = [&](const std::string& name, const Vec3& centre) {
    return shape(name, make_pose(centre, Quat::Identity()),
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

std::string capsules_of(const RobotModel& robot, int frame) {
  std::string shapes;
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    if (capsule.frame == frame) shapes += capsule_shapes(capsule);
  }
  return shapes;
}

std::string link(const std::string& name, const std::string& body) {
  if (body.empty()) return fmt::format("  <link name=\"{}\"/>\n", files::escape_xml(name));
  return fmt::format("  <link name=\"{}\">\n{}  </link>\n", files::escape_xml(name), body);
}

struct Names {
  std::string joint, link;
};

std::string joint(const Names& names, const char* type, const std::string& parent, const Pose& pose,
                  const std::string& more) {
  return fmt::format(
      "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n"
      "    {}\n{}  </joint>\n",
      files::escape_xml(names.joint), type, files::escape_xml(parent),
      files::escape_xml(names.link), urdf_origin(pose), more);
}

struct Writer {
  const RobotModel& robot;
  const std::vector<UrdfExtra>& extras;  ///< [frames], or empty
  std::vector<Names> names;              ///< [frames]
  std::set<std::string> joints_taken, links_taken;
  std::string root;     ///< the name of the root link
  int root_frame = -1;  ///< the frame that is the root link, -1 if there is no such frame
  std::string text;

  const UrdfExtra& extra(int frame) const {
    static const UrdfExtra kNone;
    return extras.empty() ? kNone : extras[frame];
  }

  static std::string free_name(std::string name, const char* ending, std::set<std::string>& taken) {
    while (!taken.insert(name).second) name += ending;
    return name;
  }

  /// Returns the frame that becomes the root link: the only one at the base, if it is a URDF's root
  /// link at the base's pose and the base itself has no capsule; else -1.
  int find_root() const {
    if (extras.empty() || extras.front().link.empty() || !extras.front().joint.empty()) return -1;
    if (std::ranges::count(robot.frames, -1, &RobotModel::Frame::parent) > 1) return -1;
    const RobotModel::Frame& first = robot.frames.front();
    const bool at_base = first.joint < 0 && first.transform.isApprox(Pose::Identity(), 0);
    return at_base && capsules_of(robot, -1).empty() ? 0 : -1;
  }

  void name_all() {
    root_frame = find_root();
    // Names from URDFs come first and are kept; those of other frames are changed if in use.
    names.resize(robot.frames.size());
    for (const bool of_urdf : {true, false}) {
      for (int f = 0; f < std::ssize(robot.frames); ++f) {
        const UrdfExtra& known = extra(f);
        const std::string& name = robot.frames[f].name;
        if (known.link.empty() != of_urdf)
          names[f].link = free_name(of_urdf ? known.link : name, "_frame", links_taken);
        if (f != root_frame && known.joint.empty() != of_urdf)
          names[f].joint = free_name(of_urdf ? known.joint : name, "_joint", joints_taken);
      }
    }
    root = root_frame < 0 ? free_name("base", "_root", links_taken) : names[root_frame].link;
  }

  const std::string& parent_of(int frame) const { return frame < 0 ? root : names[frame].link; }

  /// Returns the frame that moves by the joint's own value: the one with its name, else the first.
  int driver_of(int joint) const {
    int driver = -1;
    for (int f = 0; f < std::ssize(robot.frames); ++f) {
      if (robot.frames[f].joint != joint) continue;
      if (driver < 0 || names[f].joint == robot.joint_names[joint]) driver = f;
    }
    return driver;
  }

  void add_moving(int f) {
    const RobotModel::Frame& frame = robot.frames[f];
    Pose pose = frame.transform;
    const int k = frame.joint;
    std::string more = fmt::format("    <axis xyz=\"{}\"/>\n", urdf_numbers(frame.axis));
    double lower = robot.lower[k], upper = robot.upper[k];
    const int driver = driver_of(k);
    if (driver == f) {
      if (frame.prismatic) {
        pose = pose * Eigen::Translation3d(frame.offset * frame.axis);
      } else {
        pose = pose * Eigen::AngleAxisd(frame.offset, frame.axis);
      }
    } else {
      lower = frame.ratio * robot.lower[k] + frame.offset;
      upper = frame.ratio * robot.upper[k] + frame.offset;
      more += fmt::format("    <mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
                          files::escape_xml(names[driver].joint), frame.ratio, frame.offset);
    }
    more += fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n",
                        std::min(lower, upper), std::max(lower, upper), extra(f).effort.value_or(0),
                        std::abs(frame.ratio) * robot.velocity[k]);
    const double round = 2 * std::numbers::pi;
    const bool continuous = extra(f).continuous && lower == -round && upper == round;
    text += joint(names[f],
                  frame.prismatic ? "prismatic"
                  : continuous    ? "continuous"
                                  : "revolute",
                  parent_of(frame.parent), pose, more + extra(f).dynamics);
  }

  void add_frames() {
    if (root_frame < 0) text += link(root, capsules_of(robot, -1));
    for (int f = 0; f < std::ssize(robot.frames); ++f) {
      const RobotModel::Frame& frame = robot.frames[f];
      if (frame.joint >= 0) {
        add_moving(f);
      } else if (f != root_frame) {
        text += joint(names[f], "fixed", parent_of(frame.parent), frame.transform, "");
      }
      const std::string shapes = extra(f).has_collision ? "" : capsules_of(robot, f);
      text += link(names[f].link, extra(f).link_elements + shapes);
    }
  }

  void add_tips() {
    for (const RobotModel::Tip& tip : robot.tips) {
      std::string name = tip.name;
      while (links_taken.contains(name) || joints_taken.contains(name)) name += "_tip";
      links_taken.insert(name);
      joints_taken.insert(name);
      text += joint({name, name}, "fixed", parent_of(tip.frame), tip.transform, "");
      text += link(name, "");
    }
  }

  std::string write(const std::vector<std::string>& comment) {
    name_all();
    text = "<?xml version=\"1.0\"?>\n";
    for (std::string line : comment) {
      for (std::size_t dashes; (dashes = line.find("--")) != std::string::npos;)
        line.insert(dashes + 1, " ");
      text += fmt::format("<!-- {} -->\n", line);
    }
    text += fmt::format("<robot name=\"{}\">\n", files::escape_xml(robot.name));
    add_frames();
    add_tips();
    return text + "</robot>\n";
  }
};

}  // namespace

std::string urdf_of(const RobotModel& robot) {
  const std::vector<UrdfExtra> none;
  return Writer{robot, none, {}, {}, {}, {}, -1, {}}.write({});
}

WrittenUrdf urdf_of(const RobotDescription& robot, const std::filesystem::path& folder) {
  const std::vector<UrdfExtra> extras = urdf_extras(robot, folder);
  std::vector<std::string> sentences = missing_details(robot.table, extras);
  std::string text = Writer{robot.table, extras, {}, {}, {}, {}, -1, {}}.write(sentences);
  return {std::move(text), std::move(sentences)};
}

}  // namespace morphe::robot
