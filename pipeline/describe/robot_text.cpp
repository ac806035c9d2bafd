#include "pipeline/describe/robot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/motion/assumption_text.hpp"
#include "core/motion/human_motion.hpp"
#include "core/robot/opening.hpp"
#include "core/robot/standing.hpp"

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

/// Returns the frames that a joint moves, except the first frame of each joint.
std::vector<const RobotModel::Frame*> coupled_frames(const RobotModel& robot) {
  std::vector<const RobotModel::Frame*> coupled;
  std::vector<bool> driven(robot.joints(), false);
  for (const RobotModel::Frame& frame : robot.frames) {
    if (frame.joint < 0) continue;
    if (driven[frame.joint]) coupled.push_back(&frame);
    driven[frame.joint] = true;
  }
  return coupled;
}

double reach_of(const RobotModel& robot) {
  double reach = 0;
  for (const RobotModel::Tip& tip : robot.tips)
    reach = std::max(reach, stretched_reach(robot, tip));
  return reach;
}
std::size_t name_width(const RobotModel& robot) {
  std::size_t width = 10;
  for (const RobotModel::Frame& frame : robot.frames) width = std::max(width, frame.name.size());
  for (const RobotModel::Tip& tip : robot.tips) width = std::max(width, tip.name.size());
  return width;
}

std::string joint_lines(const RobotModel& robot, std::size_t width) {
  std::string text =
      fmt::format("{:{}}  {:>8} {:>8} {:>8} {:>8} {:>8}\n{:{}}  {:>8} {:>8} {:>8} {:>8} {:>8}\n",
                  "joint", width, "lower", "upper", "velocity", "accel.", "jerk", "", width, "deg",
                  "deg", "rad/s", "rad/s^2", "rad/s^3");
  for (int k = 0; k < std::ssize(robot.joint_names); ++k)
    text += fmt::format("{:{}}  {:8.1f} {:8.1f} {:8.3g} {:8.3g} {:8.3g}\n", robot.joint_names[k],
                        width, degrees(robot.lower[k]), degrees(robot.upper[k]), robot.velocity[k],
                        robot.acceleration[k], robot.jerk[k]);
  const std::vector<const RobotModel::Frame*> coupled = coupled_frames(robot);
  if (!coupled.empty()) text += fmt::format("\n{:{}}  follows\n", "coupled", width);
  for (const RobotModel::Frame* frame : coupled)
    text += fmt::format("{:{}}  {:.4g} x {} + {:.4g} deg\n", frame->name, width, frame->ratio,
                        robot.joint_names[frame->joint], degrees(frame->offset));
  return text;
}

std::string frame_lines(const RobotModel& robot, std::size_t width) {
  std::string text = fmt::format("\n{:{}}  {:{}}  {:>8} {:>8} {:>8}  mm from its parent frame\n",
                                 "frame", width, "parent", width, "x", "y", "z");
  const auto number = [](double x) { return std::abs(x) < 5e-3 ? 0.0 : x; };  // avoids -0.00
  for (const RobotModel::Frame& frame : robot.frames) {
    const Vec3 origin_mm = 1000 * frame.transform.translation();
    text +=
        fmt::format("{:{}}  {:{}}  {:8.2f} {:8.2f} {:8.2f}{}\n", frame.name, width,
                    frame_name(robot, frame.parent), width, number(origin_mm.x()),
                    number(origin_mm.y()), number(origin_mm.z()), frame.joint < 0 ? "  fixed" : "");
  }
  return text;
}

/// Returns how a robot with a body stands; "" for all others, whose base may have any direction.
std::string standing_line(const RobotModel& robot) {
  const robot::Standing standing = robot::standing_of(robot);
  if (!standing.has_body()) return "";
  return fmt::format(
      "stands upright on its body ({}): up is ({:.0f} {:.0f} {:.0f}), forward ({:.2f} {:.2f} "
      "{:.2f}) in the base frame\n\n",
      standing.evidence, standing.up.x(), standing.up.y(), standing.up.z(), standing.forward.x(),
      standing.forward.y(), standing.forward.z());
}

std::string tip_lines(const RobotModel& robot, std::size_t width) {
  std::string text =
      fmt::format("\n{:{}}  {:{}}  {:>8}  finger\n", "tip", width, "frame", width, "reach m");
  for (const RobotModel::Tip& tip : robot.tips)
    text +=
        fmt::format("{:{}}  {:{}}  {:8.3f}  {}\n", tip.name, width, frame_name(robot, tip.frame),
                    width, stretched_reach(robot, tip), finger_of(tip));
  if (const double opening_m = robot::widest_opening(robot); !std::isnan(opening_m))
    text += fmt::format("thumb and index open to {:.1f} mm between their tips\n", 1e3 * opening_m);
  text += fmt::format("\n{:{}}  chain\n", "centre", width);
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    text += fmt::format("{:{}}  {}\n", frame_name(robot, centre.frame), width, centre.chain);
  return text;
}

}  // namespace

std::string robot_text(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  const std::size_t width = name_width(robot);
  std::string text = fmt::format(
      "{}: joints {}, coupled {}, tips {}, capsules {}; shoulder {}, palm {}, reach {:.3f} "
      "m\n\n",
      robot.name, robot.joints(), coupled_frames(robot).size(), robot.tips.size(),
      robot.capsules.size(), frame_name(robot, robot.shoulder_frame),
      frame_name(robot, robot.palm_frame), reach_of(robot));
  text += standing_line(robot);
  text += joint_lines(robot, width) + frame_lines(robot, width) + tip_lines(robot, width);
  const std::vector<std::string> notes = plausibility_notes(description);
  if (!notes.empty() || !description.checks.empty() || !description.assumed.empty()) text += "\n";
  for (const Assumption& each : description.assumed)
    text += fmt::format("assumed: {}\n", phrase(each));
  for (const std::string& note : notes) text += fmt::format("note: {}\n", note);
  for (const std::string& check : description.checks) text += fmt::format("check: {}\n", check);
  return text;
}

std::string robot_json(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  Json joints = Json::array(), coupled = Json::array(), frames = Json::array(),
       tips = Json::array(), centres = Json::array();
  for (int k = 0; k < std::ssize(robot.joint_names); ++k)
    joints.push_back({{"name", robot.joint_names[k]},
                      {"lower", robot.lower[k]},
                      {"upper", robot.upper[k]},
                      {"velocity", robot.velocity[k]},
                      {"acceleration", robot.acceleration[k]},
                      {"jerk", robot.jerk[k]}});
  for (const RobotModel::Frame* frame : coupled_frames(robot))
    coupled.push_back({{"frame", frame->name},
                       {"joint", robot.joint_names[frame->joint]},
                       {"ratio", frame->ratio},
                       {"offset", frame->offset}});
  for (const RobotModel::Frame& frame : robot.frames)
    frames.push_back({{"name", frame.name},
                      {"parent", frame_name(robot, frame.parent)},
                      {"fixed", frame.joint < 0}});
  for (const RobotModel::Tip& tip : robot.tips) {
    const Json along =
        std::isnan(tip.finger_curve_share) ? Json(nullptr) : Json(tip.finger_curve_share);
    tips.push_back({{"name", tip.name},
                    {"frame", frame_name(robot, tip.frame)},
                    {"finger", tip.finger < 0 ? "wrist" : kFingerNames[tip.finger]},
                    {"finger_curve_share", along},
                    {"reach_m", stretched_reach(robot, tip)}});
  }
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    centres.push_back({{"frame", frame_name(robot, centre.frame)}, {"chain", centre.chain}});
  Json assumed = Json::array();
  for (const Assumption& each : description.assumed)
    assumed.push_back({{"subject", each.subject}, {"value", each.value}});
  const Json json = {{"robot", robot.name},
                     {"shoulder", frame_name(robot, robot.shoulder_frame)},
                     {"palm", frame_name(robot, robot.palm_frame)},
                     {"reach_m", reach_of(robot)},
                     {"joints", joints},
                     {"coupled", coupled},
                     {"frames", frames},
                     {"tips", tips},
                     {"joint_centres", centres},
                     {"opening_m", robot::widest_opening(robot)},
                     {"capsules", robot.capsules.size()},
                     {"notes", plausibility_notes(description)},
                     {"assumed", assumed},
                     {"checks", description.checks}};
  return json.dump(2);
}

}  // namespace morphe::describe
