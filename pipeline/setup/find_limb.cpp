#include "pipeline/setup/find_limb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/flange.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr std::size_t kMinArmJoints = 3;
/// A chain of three joints or more before a hand is its wrist, not an arm, if it is shorter than
/// this along its links [m], less than half of the shortest arm compared (NAO, 0.16).
constexpr double kMaxWristLength_m = 0.08;
/// A shoulder at least this far from the middle is on one side of the body [m].
constexpr double kMinSideDistance_m = 0.02;
/// Legs end within this share of the robot's height from its lowest end, and begin at least as far
/// below an arm.
constexpr double kLegShare = 0.15;

bool mentions(const std::string& name, std::initializer_list<const char*> words) {
  const std::string text = lower_case(name);
  return std::ranges::any_of(
      words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

bool has_leg_name(const Kinematics& robot, const Limb& limb) {
  return std::ranges::any_of(limb.arm ? limb.arm->frames : limb.path, [&](int frame) {
    return mentions(robot.frame(frame).name, {"hip_", "_hip", "knee", "ankle", "foot", "toe_",
                                              "thigh", "calf", "leg_", "_leg"});
  });
}

double length_along(const Kinematics& robot, const std::vector<int>& path) {
  double length_m = 0;
  for (std::size_t k = 1; k < path.size(); ++k)
    length_m += (robot.pose(path[k]).translation() - robot.pose(path[k - 1]).translation()).norm();
  return length_m;
}

std::optional<Side> side_of(const Kinematics& robot, const Limb& limb) {
  const double y = limb.arm ? position_in_base(robot, limb.arm->centres.shoulder).y()
                            : robot.pose(limb.end).translation().y();
  if (std::abs(y) >= kMinSideDistance_m) return y > 0 ? Side::left : Side::right;
  for (const int frame : limb.path) {
    const std::string name = robot.frame(frame).name;
    if (mentions(name, {"left"}) || mentions(name.substr(0, 2), {"l_"})) return Side::left;
    if (mentions(name, {"right"}) || mentions(name.substr(0, 2), {"r_"})) return Side::right;
  }
  return std::nullopt;
}

/// Returns the moving frame of a joint, or of the joint that moves a link; -1 for "".
int frame_of_joint(const Kinematics& robot, const std::string& name, const char* option) {
  if (name.empty()) return -1;
  for (int f = 0; f < std::ssize(robot.table().frames); ++f)
    if (robot.moves(f) && (robot.frame(f).name == name || robot.link[f] == name)) return f;
  throw InputError(fmt::format("{}: {} {}: no joint of this name moves", robot.model->file.string(),
                               option, name));
}

int frame_of_link(const Kinematics& robot, const std::string& link, const char* option) {
  const auto found = robot.model->links.find(link);
  if (found == robot.model->links.end())
    throw InputError(fmt::format("{}: {} {}: link '{}' does not exist", robot.model->file.string(),
                                 option, link, link));
  return found->second;
}

Limb limb_to(const Kinematics& robot, int end, bool has_hand, const ArmAnswers& answers,
             const LinkShapes& shapes) {
  Limb limb;
  limb.end = end;
  limb.has_hand = has_hand;
  limb.path = joint_frames_between(robot, -1, end);
  if (limb.path.size() >= kMinArmJoints) {
    const std::optional<Vec3> point = has_hand
                                          ? std::optional<Vec3>(robot.pose(end).translation())
                                          : end_of_link(robot, limb.path.back(), shapes.points);
    limb.arm = find_arm(robot, limb.path, point, answers);
  }
  limb.side = side_of(robot, limb);
  return limb;
}

bool moves_below(const Kinematics& robot, int frame) {
  return std::ranges::any_of(robot.children[frame], [&](int child) {
    return robot.moves(child) || moves_below(robot, child);
  });
}

/// Returns the limbs with hands, then those that end without one.
std::vector<Limb> all_limbs(const Kinematics& robot, const ArmAnswers& answers,
                            const LinkShapes& shapes) {
  std::vector<Limb> limbs;
  const std::vector<int> roots = find_hand_roots(robot, shapes.points);
  for (const int root : roots) limbs.push_back(limb_to(robot, root, true, answers, shapes));
  for (int f = 0; f < std::ssize(robot.table().frames); ++f) {
    const bool in_hand = std::ranges::any_of(
        roots, [&](int root) { return robot::is_in_subtree(robot.table(), f, root); });
    if (!robot.moves(f) || moves_below(robot, f) || in_hand) continue;
    Limb limb = limb_to(robot, f, false, answers, shapes);
    if (limb.path.size() >= kMinArmJoints) limbs.push_back(std::move(limb));
  }
  return limbs;
}

/// Takes the legs out: limbs that are called so, or reach the lowest end from below another arm.
void remove_legs(const Kinematics& robot, std::vector<Limb>& limbs) {
  const auto height = [&](const JointCentre& c) { return position_in_base(robot, c).z(); };
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (const Limb& limb : limbs) {
    if (!limb.arm) continue;
    lowest = std::min(lowest, height(limb.arm->centres.wrist));
    highest = std::max(highest, height(limb.arm->centres.shoulder));
  }
  const double share_m = kLegShare * (highest - lowest);
  std::erase_if(limbs, [&](const Limb& limb) {
    if (limb.has_hand) return false;
    if (has_leg_name(robot, limb)) return true;
    return limb.arm && height(limb.arm->centres.wrist) < lowest + share_m &&
           height(limb.arm->centres.shoulder) < highest - share_m;
  });
}

std::string table_of(const Kinematics& robot, const std::vector<Limb>& limbs) {
  std::size_t width = 4;
  for (const Limb& limb : limbs)
    for (const std::string& name : {robot.link[limb.end], robot.frame(limb.path.front()).name})
      width = std::max(width, name.size());
  std::string text =
      fmt::format("  {:{}}  side   {:{}}  {:{}}  joints  length", "LINK", width, "first joint",
                  std::max<std::size_t>(width, 11), "last joint", std::max<std::size_t>(width, 11));
  for (const Limb& limb : limbs) {
    const std::vector<int>& frames = limb.arm ? limb.arm->frames : limb.path;
    text +=
        fmt::format("\n  {:{}}  {:5}  {:{}}  {:{}}  {:6}  {:.3f} m", robot.link[limb.end], width,
                    limb.side ? name_of(*limb.side) : "-", robot.frame(frames.front()).name,
                    std::max<std::size_t>(width, 11), robot.frame(frames.back()).name,
                    std::max<std::size_t>(width, 11), frames.size(), length_along(robot, frames));
  }
  return text;
}

/// Throws an error that asks which of several limbs is meant.
[[noreturn]] void ask_which(const Kinematics& robot, const std::vector<Limb>& limbs) {
  const bool arms =
      std::ranges::all_of(limbs, [](const Limb& limb) { return limb.arm.has_value(); });
  throw InputError(fmt::format("{}: has {} {}: select one with {} LINK (morphe robot setup)\n{}",
                               robot.model->file.string(), limbs.size(), arms ? "arms" : "hands",
                               arms ? "--arm" : "--hand", table_of(robot, limbs)));
}

bool concerns(const Kinematics& robot, const Limb& limb, int link) {
  return robot::is_in_subtree(robot.table(), limb.end, link) ||
         robot::is_in_subtree(robot.table(), link, limb.end);
}

/// Returns the only limb of the best kind: with a hand and an arm, with an arm, with a hand.
std::vector<Limb> best_of(const std::vector<Limb>& limbs) {
  std::vector<Limb> best;
  int best_kind = 0;
  for (const Limb& limb : limbs) {
    const int kind = (limb.arm ? 2 : 0) + (limb.has_hand ? 1 : 0);
    if (kind == 0 || kind < best_kind) continue;
    if (kind > best_kind) best.clear();
    best_kind = kind;
    best.push_back(limb);
  }
  return best;
}

/// Returns how to free joints that an exporter of URDFs may have locked, "" without any.
std::string locked_sentence(const robot::UrdfModel& model) {
  const std::vector<std::string> locked = locked_joints(model);
  if (locked.empty()) return "";
  return fmt::format(
      "; its limits lock {} (lower = upper): free those that move with --limit JOINT=LOWER..UPPER",
      fmt::join(locked, ", "));
}

/// Throws an error that asks for the elbow of a chain that is too long for a wrist.
void expect_arm(const Kinematics& robot, const Limb& limb) {
  if (limb.arm || limb.path.size() < kMinArmJoints) return;
  if (limb.has_hand && length_along(robot, limb.path) < kMaxWristLength_m) return;
  std::vector<std::string> names;
  for (const int frame : limb.path) names.push_back(robot.frame(frame).name);
  throw InputError(fmt::format(
      "{}: shoulder, elbow and wrist cannot be derived: no joint of {} folds two bones of an arm's "
      "proportions; name the elbow in `morphe robot setup` with --elbow JOINT, or the link where "
      "another arm ends with --arm LINK{}",
      robot.model->file.string(), fmt::join(names, ", "), locked_sentence(*robot.model)));
}

std::vector<Limb> limbs_asked_for(const Kinematics& robot, const SetupRequest& request,
                                  const ArmAnswers& answers, const LinkShapes& shapes) {
  if (!request.hand.empty())
    return {limb_to(robot, frame_of_link(robot, request.hand, "--hand"), true, answers, shapes)};
  std::vector<Limb> limbs = all_limbs(robot, answers, shapes);
  if (request.arm.empty() && request.last.empty()) {
    remove_legs(robot, limbs);
    return limbs;
  }
  const int link = request.arm.empty() ? frame_of_joint(robot, request.last, "chain arm: last")
                                       : frame_of_link(robot, request.arm, "--arm");
  std::erase_if(limbs, [&](const Limb& limb) { return !concerns(robot, limb, link); });
  if (limbs.empty()) limbs = {limb_to(robot, link, false, answers, shapes)};
  return limbs;
}

}  // namespace

Limb find_limb(const Kinematics& robot, const SetupRequest& request, const LinkShapes& shapes,
               std::vector<std::string>& notes) {
  const ArmAnswers answers{frame_of_joint(robot, request.first, "chain arm: first"),
                           frame_of_joint(robot, request.elbow, "--elbow")};
  const std::vector<Limb> limbs = limbs_asked_for(robot, request, answers, shapes);
  const std::vector<Limb> best = best_of(limbs);
  if (best.size() > 1) ask_which(robot, best);
  if (best.empty()) {
    for (const Limb& limb : limbs) expect_arm(robot, limb);
    throw InputError(
        fmt::format("{}: contains neither a hand (fingers that branch from one link) nor an arm "
                    "(three consecutive joints){}",
                    robot.model->file.string(), locked_sentence(*robot.model)));
  }
  expect_arm(robot, best.front());
  for (const Limb& other : limbs)
    if (other.arm && other.end != best.front().end)
      notes.push_back(
          fmt::format("the joints of another arm, to {0}, stay fixed: it is set up "
                      "with --arm {0}",
                      robot.link[other.end]));
  return best.front();
}

}  // namespace morphe::setup
