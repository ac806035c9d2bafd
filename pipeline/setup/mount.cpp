#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/find_allowed_links.hpp"
#include "pipeline/setup/merge_sections.hpp"
#include "pipeline/setup/setup.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;

std::string relative_to_output(const fs::path& file, const fs::path& out) {
  return fs::absolute(file).lexically_proximate(fs::absolute(out).parent_path()).string();
}

std::set<std::string> names_of_robot(const robot::RobotDescription& robot) {
  std::set<std::string> names;
  for (const auto& frame : robot.table.frames) names.insert(frame.name);
  for (const auto& tip : robot.table.tips) names.insert(tip.name);
  for (const auto& capsule : robot.table.capsules) names.insert(capsule.name);
  return names;
}

bool share_names(const robot::RobotDescription& one, const robot::RobotDescription& other) {
  const std::set<std::string> names = names_of_robot(one);
  return std::ranges::any_of(names_of_robot(other),
                             [&](const std::string& name) { return names.contains(name); });
}

/// Returns flange_from_base of the hand with the palm's axes parallel to the flange's, its origin
/// on the flange's z axis, and the hand's rear touching the flange.
Pose default_mount(const robot::RobotDescription& hand) {
  const RobotModel& table = hand.table;
  std::vector<Pose> poses;
  robot::forward_kinematics(table, rest_position(table), poses);
  const Pose palm_from_base = poses[table.palm_frame].inverse();
  double back_m = 0;
  for (const RobotModel::Capsule& capsule : table.capsules) {
    const Pose palm_from_frame =
        capsule.frame < 0 ? palm_from_base : Pose(palm_from_base * poses[capsule.frame]);
    for (const Vec3& end : {capsule.from, capsule.to})
      back_m = std::min(back_m, (palm_from_frame * end).z() - capsule.radius);
  }
  return Eigen::Translation3d(0, 0, -back_m) * palm_from_base;
}

Pose requested_mount(const MountRequest& request) {
  Pose pose = Pose::Identity();
  pose.translate(request.mount->position);
  pose.rotate(Eigen::AngleAxisd(request.mount->rpy.z(), Vec3::UnitZ()) *
              Eigen::AngleAxisd(request.mount->rpy.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(request.mount->rpy.x(), Vec3::UnitX()));
  return pose;
}

}  // namespace

SetupResult mount_hand(const MountRequest& request, const std::optional<std::string>& before) {
  const robot::RobotDescription arm = robot::load_robot(request.arm);
  const robot::RobotDescription hand = robot::load_robot(request.hand);
  const Pose mount = request.mount ? requested_mount(request) : default_mount(hand);
  const std::string name =
      request.name.empty() ? arm.table.name + "_" + hand.table.name : request.name;
  const std::string prefix = share_names(arm, hand) ? "hand_" : "";
  const std::string flange = arm.table.frames[arm.table.palm_frame].name;
  const std::string parts = fmt::format(
      "parts:\n  - {{file: {}}}\n  - {{file: {}, {}parent: {}, mount: {}}}  # {}\n",
      yaml_name(relative_to_output(request.arm, request.out)),
      yaml_name(relative_to_output(request.hand, request.out)),
      prefix.empty() ? "" : fmt::format("prefix: {}, ", prefix), yaml_name(flange),
      yaml_mount(mount), request.mount ? "as given" : "assumed: z on the flange's axis, no roll");
  const std::string named = fmt::format("name: {}\n", yaml_name(name));

  const robot::RobotDescription bare = robot::parse_robot(named + parts, request.out);
  const std::string allowed = allowed_links_yaml(find_allowed_links(bare.table), [&](int frame) {
    return frame < 0 ? std::string("base") : bare.table.frames[frame].name;
  });
  std::vector<Section> sections = {{"name", named}, {"parts", parts}};
  // Without a hand, the wrist of the arm is its end; with a hand, it is a joint like the others.
  const auto wrist = std::ranges::find(arm.table.frames, "wrist_centre", &RobotModel::Frame::name);
  if (wrist != arm.table.frames.end())
    sections.push_back(
        {"joint_centres", "joint_centres:\n  - {chain: arm, frame: wrist_centre}\n"});
  if (!allowed.empty()) sections.push_back({"collision", "collision:\n" + allowed});
  SetupResult result;
  std::vector<std::string> kept;
  result.text =
      "# Made by `morphe robot setup`: what stands below a line that begins with `#:` is "
      "made anew\n# each time, unless somebody changed it: then it stays as it is.\n" +
      (before ? merge_sections(sections, *before, kept) : join_sections(sections));
  if (!kept.empty())
    result.notes.push_back(fmt::format("kept because edited: {}", fmt::join(kept, ", ")));
  if (!request.mount)
    result.to_check.push_back(
        "mount of the hand: assumed (set it with --mount X Y Z ROLL PITCH YAW)");
  (void)robot::parse_robot(result.text, request.out);
  return result;
}

}  // namespace morphe::setup
