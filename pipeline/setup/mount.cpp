#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/check_mount.hpp"
#include "pipeline/setup/clear_covers.hpp"
#include "pipeline/setup/description_sections.hpp"
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
/// on the flange's z axis, and the rear of the hand's base touching the flange.
Pose default_mount(const robot::RobotDescription& hand) {
  const RobotModel& table = hand.table;
  std::vector<Pose> poses;
  robot::forward_kinematics(table, rest_position(table), poses);
  const Pose palm_from_base = poses[table.palm_frame].inverse();
  double back_m = 0;
  const auto of_base = [&](const RobotModel::Capsule& capsule) {
    return robot::moving_frame_of(table, capsule.frame) < 0;
  };
  const bool base_known = std::ranges::any_of(table.capsules, of_base);
  for (const RobotModel::Capsule& capsule : table.capsules) {
    if (base_known && !of_base(capsule)) continue;
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

/// Returns X Y Z ROLL PITCH YAW, as --mount takes them.
std::string mount_option(const Pose& pose) {
  const Eigen::Matrix3d& r = pose.linear();
  const double pitch = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  const bool upright = std::hypot(r(2, 1), r(2, 2)) > 1e-9;
  const double roll = upright ? std::atan2(r(2, 1), r(2, 2)) : std::atan2(-r(1, 2), r(1, 1));
  const double yaw = upright ? std::atan2(r(1, 0), r(0, 0)) : 0;
  const Vec3 p = pose.translation();
  return fmt::format("{:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f}", p.x() + 0.0, p.y() + 0.0,
                     p.z() + 0.0, roll + 0.0, pitch + 0.0, yaw + 0.0);
}

/// A hand on a flange, with the parts of both in one robot.
struct MountedHand {
  const MountRequest& request;
  const RobotModel& arm;
  const RobotModel& robot;
  Pose flange_from_hand;

  bool of_arm(int capsule) const {
    return std::ranges::find(arm.capsules, robot.capsules[capsule].name,
                             &RobotModel::Capsule::name) != arm.capsules.end();
  }
  int flange() const {
    const std::string& name = arm.frames[arm.palm_frame].name;
    return static_cast<int>(std::ranges::find(robot.frames, name, &RobotModel::Frame::name) -
                            robot.frames.begin());
  }
  /// Returns true if the fingers point back along the arm.
  bool points_backwards() const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, rest_position(robot), poses);
    return poses[robot.palm_frame].linear().col(2).dot(poses[flange()].linear().col(2)) < 0;
  }
};

/// Throws an error if the hand stands in the arm. Returns a sentence about an overlap that may be
/// one of the capsules only, "" if there is none.
std::string check_clear_of_arm(const MountedHand& hand) {
  const auto collision = find_mount_collision(hand.robot, hand.flange(),
                                              [&](int capsule) { return hand.of_arm(capsule); });
  if (!collision) return "";
  const std::string overlap =
      fmt::format("{} is {:.0f} mm deep in {} in nearly all postures of the wrist",
                  hand.robot.capsules[collision->hand_capsule].name, 1e3 * collision->depth_m,
                  hand.robot.capsules[collision->arm_capsule].name);
  if (!collision->stands_inside)
    return fmt::format("mount of the hand: {}, by their capsules", overlap);
  Pose outwards = hand.flange_from_hand;
  outwards.translation().z() += collision->depth_m;
  throw InputError(fmt::format(
      "{}: the hand stands in the arm: {}; {}", hand.request.out.string(), overlap,
      hand.points_backwards()
          ? "its fingers point back along the arm: turn it with --mount X Y Z ROLL PITCH YAW"
          : "move it outwards: --mount " + mount_option(outwards)));
}

/// Returns the shapes of the robot's URDFs that can be read, by its frames.
std::map<int, std::vector<SceneObject>> shapes_at_hand(const robot::RobotDescription& robot) {
  std::map<int, std::vector<SceneObject>> shapes;
  for (const robot::UrdfSource& source : robot.urdfs) {
    const robot::UrdfModel model = robot::load_urdf_model(source.file);
    const Kinematics kinematics = kinematics_of(model);
    LinkShapes found = read_shapes(kinematics, {});
    for (auto& [frame, objects] : found.shapes_by_frame) {
      const auto link = source.links.find(kinematics.link[frame]);
      if (link != source.links.end()) shapes[link->second] = std::move(objects);
    }
  }
  return shapes;
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
      yaml_mount(mount),
      request.mount ? "as given" : "assumed: fingers along the flange's z, palm towards its x");
  const std::string named = fmt::format("name: {}\n", yaml_name(name));

  std::vector<std::string> kept;
  const auto joined = [&](const std::vector<Section>& sections) {
    kept.clear();
    return before ? merge_sections(sections, *before, kept) : join_sections(sections);
  };
  const std::string assumed =
      request.mount ? "assumed: {}\n"
                    : "assumed:\n  mount: fingers along the flange's z, palm towards its x; the "
                      "adapter is not known\n";
  std::vector<Section> sections = {{"name", named}, {"assumed", assumed}, {"parts", parts}};
  // Without a hand, the wrist of the arm is its end; with a hand, it is a joint like the others.
  const auto wrist = std::ranges::find(arm.table.frames, "wrist_centre", &RobotModel::Frame::name);
  if (wrist != arm.table.frames.end())
    sections.push_back(
        {"joint_centres", "joint_centres:\n  - {chain: arm, frame: wrist_centre}\n"});
  const robot::RobotDescription bare = robot::parse_robot(joined(sections), request.out);
  const bool edited = std::ranges::find(kept, "parts") != kept.end();
  const std::string overlap = check_clear_of_arm({request, arm.table, bare.table, mount});
  const auto name_of_frame = [&](int frame) {
    return frame < 0 ? std::string("base") : bare.table.frames[frame].name;
  };
  const std::vector<LinkPair> pairs =
      judge_pairs(bare.table, link_bodies(shapes_at_hand(bare), bare.table));
  const std::string allowed = allowed_links_yaml(pairs, name_of_frame);
  if (!allowed.empty()) sections.push_back({"collision", "collision:\n" + allowed});
  SetupResult result;
  if (!request.mount && !edited)
    result.to_check.push_back(fmt::format(
        "mount of the hand: assumed: its rear on the flange, its fingers along the flange's z, its "
        "palm towards the flange's x, that is --mount {}",
        mount_option(mount)));
  if (!overlap.empty()) result.to_check.push_back(overlap);
  const robot::RobotDescription checked = robot::parse_robot(joined(sections), request.out);
  for (std::string& sentence : pairs_to_check(checked.table, pairs, name_of_frame))
    result.to_check.push_back(std::move(sentence));
  if (!result.to_check.empty()) sections.push_back({"check", check_section(result.to_check)});
  result.text =
      "# Made by `morphe robot setup`: what stands below a line that begins with `#:` is "
      "made anew\n# each time, unless somebody changed it: then it stays as it is.\n" +
      joined(sections);
  if (!kept.empty())
    result.notes.push_back(fmt::format("kept because edited: {}", fmt::join(kept, ", ")));
  result.to_check = robot::parse_robot(result.text, request.out).checks;
  return result;
}

}  // namespace morphe::setup
