#include "pipeline/setup/items_to_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/motion/count_with_noun.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

std::string joints_of(const UrdfAnalysis& found, const std::vector<int>& frames) {
  std::vector<std::string> names;
  for (const int frame : frames) names.push_back(found.joint(frame));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Describes an assumed wrist.
std::string doubtful_wrist(const UrdfAnalysis& found, const JointCentre& wrist) {
  if (wrist.axis_distance_m > 0)
    return fmt::format(
        "wrist: no two axes beyond the elbow meet; those of {} and the next joint "
        "pass each other at {:.0f} mm",
        found.joint(wrist.frame), 2e3 * wrist.axis_distance_m);
  return "wrist: no two axes beyond the elbow define it, so it is assumed at the end of the arm";
}

void add_arm(const UrdfAnalysis& found, std::vector<std::string>& check) {
  if (!found.roles) return;
  const Arm& arm = *found.roles;
  if (!arm.trunk.empty())
    check.push_back(
        fmt::format("trunk: joints before the shoulder are fixed: {} (section fixed_joints)",
                    joints_of(found, arm.trunk)));
  if (arm.centres.shoulder.sure == Provenance::assumed)
    check.push_back(fmt::format("shoulder: its height on the axis of {} is assumed",
                                found.joint(arm.centres.shoulder.frame)));
  if (!arm.other_elbows.empty())
    check.push_back(fmt::format("elbow: {}; {} would fit as well (--elbow)", found.joint(arm.elbow),
                                joints_of(found, arm.other_elbows)));
  if (arm.centres.wrist.sure == Provenance::assumed)
    check.push_back(doubtful_wrist(found, arm.centres.wrist));
}

std::string finger_text(const UrdfAnalysis& found, const Finger& finger) {
  if (finger.frames.empty())
    return fmt::format("{} = {}, the fixed jaw ({})", found.finger_name(finger),
                       found.link(finger.body), name_of(finger.finger_provenance));
  return fmt::format("{} = {} ({})", found.finger_name(finger), found.joint(finger.frames.back()),
                     name_of(finger.finger_provenance));
}

/// Returns the side of a hand; of a gripper also its opening.
std::string kind_text(const UrdfAnalysis& found) {
  const Hand& hand = *found.hand;
  const std::string evidence =
      hand.side_evidence.empty() ? "" : fmt::format(" ({})", hand.side_evidence);
  const std::string side = hand.side ? fmt::format("a {} ", name_of(*hand.side)) : "a ";
  if (!hand.gripper) return side + "hand" + evidence;
  return fmt::format("{}gripper{}{}, which opens {:.1f} mm between its pads", side, evidence,
                     hand.side ? ""
                               : " without a side (recordings of left hands are mirrored for "
                                 "it, unless `side: left` is written)",
                     1e3 * found.opening_m);
}

void add_hand_items(const UrdfAnalysis& found, std::vector<std::string>& check) {
  std::vector<std::string> fingers;
  for (const Finger& finger : found.hand->fingers) fingers.push_back(finger_text(found, finger));
  check.push_back(fmt::format("fingers: {}; {}", fmt::join(fingers, ", "), kind_text(found)));
  for (const LeftOut& left : found.hand->left_out)
    check.push_back(
        fmt::format("{} is no finger and is not used: {}", found.link(left.frame), left.reason));
  if (std::ranges::any_of(found.pads, &Pad::assumed_to_meet))
    check.push_back("pads of the jaws: without shapes they are assumed to meet at the closed end");
  for (int i = 0; i < std::ssize(found.pads); ++i)
    if (found.pads[i].sure == Provenance::assumed)
      check.push_back(fmt::format(
          "tip of {0}: the end of the finger is unknown (give meshes with --package, or "
          "write the pose of {0}_tip in tips)",
          found.finger_name(found.hand->fingers[i])));
}

/// Returns the joints that move a tip or the wrist.
std::set<std::string> used_joints(const UrdfAnalysis& found) {
  std::set<std::string> joints;
  std::vector<int> frames = found.arm;
  if (found.hand)
    for (const Finger& finger : found.hand->fingers)
      frames.insert(frames.end(), finger.frames.begin(), finger.frames.end());
  const RobotModel& table = found.robot.table();
  for (const int f : frames) joints.insert(table.joint_names[found.robot.frame(f).joint]);
  for (const robot::UrdfJoint& joint : found.robot.model->tree.joints) {
    const int frame = found.robot.model->links.at(joint.child);
    const auto below = [&](int f) { return robot::is_in_subtree(table, f, frame); };
    if (!found.robot.moves(frame) && std::ranges::any_of(frames, below)) joints.insert(joint.name);
  }
  return joints;
}

}  // namespace

std::vector<std::string> items_to_check(const UrdfAnalysis& found,
                                        const std::vector<JointLimits>& limits) {
  std::vector<std::string> check;
  if (found.hand) add_hand_items(found, check);
  add_arm(found, check);
  for (const std::string& item : limit_items(*found.robot.model, limits, used_joints(found)))
    check.push_back(item);
  const auto assumed = std::ranges::count(limits, Provenance::assumed, &JointLimits::sure);
  if (assumed > 0)
    check.push_back(fmt::format("acceleration and jerk of {} assumed",
                                count_with_noun(assumed, "joint is", "joints are")));
  std::vector<std::string> beyond;
  for (const Pad& pad : found.pads)
    if (pad.tip_beyond_shapes) beyond.push_back(found.link(pad.frame));
  if (!beyond.empty())
    check.push_back(fmt::format(
        "shapes of {} end before the fingertips of the URDF: the rest of these fingers is assumed",
        fmt::join(beyond, ", ")));
  if (!found.placeholder_shape_links.empty())
    check.push_back(fmt::format(
        "shapes of {} that contain the finger pads are skipped: the fingers have their own shapes",
        fmt::join(found.placeholder_shape_links, ", ")));
  std::vector<std::string> bones;
  for (const LinkCapsules& link : found.capsules)
    if (link.sure == Provenance::assumed) bones.push_back(found.link(link.frame));
  if (!bones.empty())
    check.push_back(
        fmt::format("shapes of {} are assumed: capsules with the thickness of the link's inertia",
                    fmt::join(bones, ", ")));
  return check;
}

}  // namespace morphe::setup
