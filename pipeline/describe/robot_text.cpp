#include "pipeline/describe/robot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/motion/human_motion.hpp"

namespace morphe::describe {
namespace {

using Json = nlohmann::ordered_json;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string frame_name(const RobotModel& robot, int frame) {
  return frame < 0 ? "base" : robot.frames[frame].name;
}

std::string finger_of(const RobotModel::Tip& tip) {
  if (tip.finger < 0) return "wrist";
  if (!std::isnan(tip.finger_curve_share))
    return fmt::format("{:.0f} % from index to little", 100 * tip.finger_curve_share);
  return kFingerNames[tip.finger];
}

/// Returns the frames that are driven by a joint that also drives an earlier frame: all frames of a
/// joint except the first.
std::vector<const RobotModel::Frame*> coupled_frames(const RobotModel& robot) {
  std::vector<const RobotModel::Frame*> found;
  std::vector<bool> driven(robot.joints(), false);
  for (const RobotModel::Frame& frame : robot.frames) {
    if (frame.joint < 0) continue;
    const auto joint = static_cast<std::size_t>(frame.joint);
    if (driven[joint]) found.push_back(&frame);
    driven[joint] = true;
  }
  return found;
}

double reach_of(const RobotModel& robot) {
  double reach = 0;
  for (const RobotModel::Tip& tip : robot.tips)
    reach = std::max(reach, stretched_reach(robot, tip));
  return reach;
}

/// Returns the width that fits every name.
int name_width(const RobotModel& robot) {
  std::size_t width = 10;
  for (const RobotModel::Frame& frame : robot.frames) width = std::max(width, frame.name.size());
  for (const RobotModel::Tip& tip : robot.tips) width = std::max(width, tip.name.size());
  return static_cast<int>(width);
}

std::string joint_lines(const RobotModel& robot, int width) {
  std::string text =
      fmt::format("{:{}}  {:>8} {:>8} {:>8} {:>8} {:>8}\n{:{}}  {:>8} {:>8} {:>8} {:>8} {:>8}\n",
                  "joint", width, "lower", "upper", "velocity", "accel.", "jerk", "", width, "deg",
                  "deg", "rad/s", "rad/s^2", "rad/s^3");
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    text += fmt::format("{:{}}  {:8.1f} {:8.1f} {:8.3g} {:8.3g} {:8.3g}\n", robot.joint_names[k],
                        width, degrees(robot.lower[i]), degrees(robot.upper[i]), robot.velocity[i],
                        robot.acceleration[i], robot.jerk[i]);
  }
  const std::vector<const RobotModel::Frame*> coupled = coupled_frames(robot);
  if (!coupled.empty())
    text += fmt::format(
        "\n"
        "{:{}}  follows\n",
        "coupled", width);
  for (const RobotModel::Frame* frame : coupled) {
    text += fmt::format("{:{}}  {:.4g} x {} + {:.4g} deg\n", frame->name, width, frame->ratio,
                        robot.joint_names[frame->joint], degrees(frame->offset));
  }
  return text;
}

std::string frame_lines(const RobotModel& robot, int width) {
  std::string text = fmt::format(
      "\n"
      "{:{}}  {:{}}  {:>8} {:>8} {:>8}  mm from its parent frame\n",
      "frame", width, "parent", width, "x", "y", "z");
  for (const RobotModel::Frame& frame : robot.frames) {
    const Vec3 at = 1000 * frame.transform.translation();
    const auto number = [](double x) { return std::abs(x) < 5e-3 ? 0.0 : x; };  // avoids -0.00
    text += fmt::format("{:{}}  {:{}}  {:8.2f} {:8.2f} {:8.2f}{}\n", frame.name, width,
                        frame_name(robot, frame.parent), width, number(at.x()), number(at.y()),
                        number(at.z()), frame.joint < 0 ? "  fixed" : "");
  }
  return text;
}

std::string tip_lines(const RobotModel& robot, int width) {
  std::string text =
      fmt::format("\n{:{}}  {:{}}  {:>8}  finger\n", "tip", width, "frame", width, "reach m");
  for (const RobotModel::Tip& tip : robot.tips) {
    text +=
        fmt::format("{:{}}  {:{}}  {:8.3f}  {}\n", tip.name, width, frame_name(robot, tip.frame),
                    width, stretched_reach(robot, tip), finger_of(tip));
  }
  text += fmt::format("\n{:{}}  chain\n", "centre", width);
  for (const RobotModel::JointCentre& centre : robot.joint_centres) {
    text += fmt::format("{:{}}  {}\n", frame_name(robot, centre.frame), width, centre.chain);
  }
  return text;
}

}  // namespace

std::string robot_text(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  const int width = name_width(robot);
  std::string text = fmt::format(
      "{}: joints {}, coupled {}, tips {}, capsules {}; shoulder {}, palm {}, reach {:.3f} "
      "m\n\n",
      robot.name, robot.joints(), coupled_frames(robot).size(), robot.tips.size(),
      robot.capsules.size(), frame_name(robot, robot.shoulder_frame),
      frame_name(robot, robot.palm_frame), reach_of(robot));
  text += joint_lines(robot, width) + frame_lines(robot, width) + tip_lines(robot, width);
  const std::vector<std::string> found = plausibility_notes(description);
  if (!found.empty()) text += "\n";
  for (const std::string& remark : found) text += fmt::format("note: {}\n", remark);
  return text;
}

std::string robot_json(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  Json joints = Json::array(), coupled = Json::array(), frames = Json::array(),
       tips = Json::array(), centres = Json::array();
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    joints.push_back({{"name", robot.joint_names[k]},
                      {"lower", robot.lower[i]},
                      {"upper", robot.upper[i]},
                      {"velocity", robot.velocity[i]},
                      {"acceleration", robot.acceleration[i]},
                      {"jerk", robot.jerk[i]}});
  }
  for (const RobotModel::Frame* frame : coupled_frames(robot)) {
    coupled.push_back({{"frame", frame->name},
                       {"joint", robot.joint_names[frame->joint]},
                       {"ratio", frame->ratio},
                       {"offset", frame->offset}});
  }
  for (const RobotModel::Frame& frame : robot.frames) {
    frames.push_back({{"name", frame.name},
                      {"parent", frame_name(robot, frame.parent)},
                      {"fixed", frame.joint < 0}});
  }
  for (const RobotModel::Tip& tip : robot.tips) {
    const Json along =
        std::isnan(tip.finger_curve_share) ? Json(nullptr) : Json(tip.finger_curve_share);
    tips.push_back({{"name", tip.name},
                    {"frame", frame_name(robot, tip.frame)},
                    {"finger", tip.finger < 0 ? "wrist" : kFingerNames[tip.finger]},
                    {"finger_curve_share", along},
                    {"reach_m", stretched_reach(robot, tip)}});
  }
  for (const RobotModel::JointCentre& centre : robot.joint_centres) {
    centres.push_back({{"frame", frame_name(robot, centre.frame)}, {"chain", centre.chain}});
  }
  const Json json = {{"robot", robot.name},
                     {"shoulder", frame_name(robot, robot.shoulder_frame)},
                     {"palm", frame_name(robot, robot.palm_frame)},
                     {"reach_m", reach_of(robot)},
                     {"joints", joints},
                     {"coupled", coupled},
                     {"frames", frames},
                     {"tips", tips},
                     {"joint_centres", centres},
                     {"capsules", robot.capsules.size()},
                     {"notes", plausibility_notes(description)}};
  return json.dump(2);
}

}  // namespace morphe::describe
