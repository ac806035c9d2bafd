#include "core/robot/files/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/human_motion.hpp"
#include "core/robot/files/assembly.hpp"
#include "core/robot/files/robot_file.hpp"
#include "core/robot/files/robot_schema.hpp"

namespace morphe::robot {
namespace {

int read_finger(const config::ConfigNode& node) {
  const std::string word = node.text();
  if (word == "wrist") return -1;
  for (int finger = 0; finger < std::ssize(kFingerNames); ++finger) {
    if (word == kFingerNames[finger]) return finger;
  }
  if (word.size() == 1 && word[0] >= '0' && word[0] <= '4') return word[0] - '0';
  node.fail(
      fmt::format("must be thumb, index, middle, ring, little, wrist or 0 … 4, not '{}'", word));
}

void read_tip(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const char* key = node.has("chain") ? "chain" : "frame";
  const MountPoint mount = find_mount_point(assembly, scope, node[key]);
  RobotModel::Tip tip;
  tip.name = scope.prefix + node["name"].text();
  tip.frame = mount.frame;
  if (tip.frame < 0) node[key].fail("a tip must be attached to a frame that moves");
  tip.transform = mount.frame_from_mount * read_optional_mount(node);
  if (node.has("pad_depth"))
    tip.transform.translate(Vec3(-node["pad_depth"].number(bounds::kLength), 0, 0));
  if (node.has("finger_curve_share")) {
    tip.finger_curve_share = node["finger_curve_share"].number(bounds::kShare);
    tip.finger = 1 + static_cast<int>(std::lround(3 * tip.finger_curve_share));
  } else {
    tip.finger = read_finger(node["finger"]);
  }
  if (std::ranges::count(assembly.table.tips, tip.name, &RobotModel::Tip::name) > 0)
    node["name"].fail(fmt::format("a tip '{}' already exists", tip.name));
  assembly.table.tips.push_back(std::move(tip));
}

/// Adds the fixed frames whose parents exist; the others remain in the list.
void add_ready_frames(Assembly& assembly, const FileScope& scope,
                      std::vector<config::ConfigNode>& nodes) {
  for (auto node = nodes.begin(); node != nodes.end();) {
    if (node->has("parent") && !has_mount_point(assembly, scope, (*node)["parent"].text())) {
      ++node;
      continue;
    }
    const MountPoint mount = read_mount_point(assembly, scope, *node);
    add_frame(assembly, scope, (*node)["name"], {"", mount.frame, mount.frame_from_mount});
    node = nodes.erase(node);
  }
}

void read_chains_and_frames(Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& root) {
  DhConvention convention = DhConvention::modified;
  if (root.has("convention")) convention = read_convention(root["convention"]);
  std::vector<config::ConfigNode> fixed = optional_items(root, "frames");
  add_ready_frames(assembly, scope, fixed);
  for (const config::ConfigNode& chain : optional_items(root, "chains")) {
    assembly.problems.attempt([&] {
      if (chain.has("joints")) {
        read_chain(assembly, scope, convention, chain);
      } else {
        read_urdf_chain(assembly, scope, chain);
      }
      add_ready_frames(assembly, scope, fixed);
    });
  }
  if (!assembly.problems.none()) return;
  for (const config::ConfigNode& node : fixed) {
    const config::ConfigNode parent = node["parent"];
    const auto same = [&](const config::ConfigNode& other) {
      return other["name"].text() == parent.text();
    };
    if (std::ranges::any_of(fixed, same)) continue;
    (void)find_mount_point(assembly, scope, parent);
  }
  if (!fixed.empty()) fixed.front()["parent"].fail("is a loop: the frame is its own ancestor");
}

void read_centres(Assembly& assembly, const FileScope& scope,
                  const std::vector<config::ConfigNode>& nodes) {
  for (const config::ConfigNode& node : nodes) {
    const config::ConfigNode chain = node["chain"];
    const auto same = [&](const Chain& c) {
      return c.name == scope.prefix + chain.text() || c.name == chain.text();
    };
    const auto found = std::ranges::find_if(assembly.chains, same);
    if (found == assembly.chains.end())
      chain.fail(fmt::format("there is no chain '{}'", chain.text()));
    const config::ConfigNode frame = node["frame"];
    (void)find_mount_point(assembly, scope, frame);
    const int index = find_frame(assembly, scope, frame.text());
    if (index < 0) frame.fail("must be a frame");
    assembly.table.joint_centres.push_back({index, found->arm ? "arm" : found->name});
  }
}

/// Reads a frame's name below `key`, which replaces that of an earlier file.
void read_frame_name(const Assembly& assembly, const FileScope& scope,
                     const config::ConfigNode& root, const char* key, std::string& name) {
  if (!root.has(key)) return;
  const int frame = find_frame(assembly, scope, root[key].text());
  if (frame < 0) root[key].fail(fmt::format("there is no frame or link '{}'", root[key].text()));
  name = assembly.table.frames[frame].name;
}

FileScope read_description(const config::ConfigNode& root, const MountPoint& base,
                           const std::string& prefix, Assembly& assembly);

int read_joint(const Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const int joint = find_joint(assembly.table, scope, node.text());
  if (joint < 0) node.fail(fmt::format("there is no actuated joint '{}'", node.text()));
  return joint;
}

/// Reads `fixed_joints: [{joint, position}]`.
void read_fixed_joints(Assembly& assembly, const FileScope& scope, const config::ConfigNode& root) {
  for (const config::ConfigNode& node : optional_items(root, "fixed_joints")) {
    assembly.problems.attempt([&] {
      const int joint = read_joint(assembly, scope, node["joint"]);
      const double position =
          node.has("position") ? node["position"].number(bounds::kJointPosition) : 0;
      const JointLimits& limits = assembly.limits[joint];
      if (position < limits.lower || position > limits.upper)
        node[node.has("position") ? "position" : "joint"].fail(fmt::format(
            "{} is outside its limits, {} to {}", position, limits.lower, limits.upper));
      assembly.fixed_joints.push_back({assembly.table.joint_names[joint], position});
    });
  }
}

/// Reads `assumed: {limits: TEXT, mount: TEXT, geometry: TEXT}`. The values begin with the name of
/// the file's robot. A file without the key, which states limits or mounts parts, leaves it open
/// where they are from.
void read_assumed(Assembly& assembly, const config::ConfigNode& root) {
  const auto add = [&](Knowable subject, const std::string& value) {
    assembly.assumed.push_back({AssumptionKind::assumed, std::string(name_of(subject)),
                                fmt::format("{}: {}", root["name"].text(), value)});
  };
  if (!root.has("assumed")) {
    const char* open = "its description does not say where they are from (key `assumed`)";
    if (root.has("chains") || root.has("generate")) add(Knowable::limits, open);
    if (root.has("parts")) add(Knowable::mount, open);
    return;
  }
  for (const Knowable subject : kAssumedSubjects) {
    const std::string key(name_of(subject));
    if (root["assumed"].has(key))
      assembly.problems.attempt([&] { add(subject, root["assumed"][key].text()); });
  }
}

/// Reads `natural_posture: [{joint, follow, value}]`.
void read_natural_posture(Assembly& assembly, const FileScope& scope,
                          const config::ConfigNode& root) {
  const auto joint_named = [&](const config::ConfigNode& node) {
    return assembly.table.joint_names[read_joint(assembly, scope, node)];
  };
  for (const config::ConfigNode& node : optional_items(root, "natural_posture")) {
    assembly.problems.attempt([&] {
      NaturalJoint joint{joint_named(node["joint"]), "", 0};
      if (node.has("follow")) joint.follow = joint_named(node["follow"]);
      if (node.has("value")) joint.value = node["value"].number(bounds::kJointPosition);
      assembly.natural.push_back(joint);
    });
  }
}

/// Reads the YAML of a description. Throws InputError for a file of another kind.
config::ConfigNode load_node(const std::filesystem::path& file, const files::GivenFiles* given) {
  if (files::is_readable_file(file, given)) {
    const RobotFile kind = robot_file_kind(file, given);
    if (kind != RobotFile::description) {
      throw InputError(
          fmt::format("{0}: is {1}, not a robot description; make one: morphe robot setup {0} "
                      "--out OUT.yaml",
                      file.string(), kind == RobotFile::urdf ? "a URDF" : "an MJCF"));
    }
  }
  return config::ConfigNode::load(file, given);
}

void read_part(Assembly& assembly, FileScope& scope, const config::ConfigNode& node) {
  const MountPoint mount = read_mount_point(assembly, scope, node);
  remove_parent_wrist_tip(assembly, mount);
  if (node.has("generate")) return read_generated(assembly, mount, node["generate"]);
  const config::ConfigNode file = node["file"];
  if (assembly.files.size() > 32) file.fail("more than 32 files; does a file include itself?");
  const std::string prefix = node.has("prefix") ? node["prefix"].text() : "";
  const FileScope part = read_description(load_node(node.folder() / file.text(), node.given()),
                                          mount, scope.prefix + prefix, assembly);
  scope.links.insert(part.links.begin(), part.links.end());
}

FileScope read_description(const config::ConfigNode& root, const MountPoint& base,
                           const std::string& prefix, Assembly& assembly) {
  assembly.files.push_back(root.file());
  FileScope scope{base, prefix, std::ssize(assembly.table.capsules)};
  const auto attempt = [&](const auto& step) { assembly.problems.attempt(step); };
  config::report_unknown_keys(root, robot_schema(), assembly.problems);
  const std::string name = root["name"].text();
  for (const config::ConfigNode& part : optional_items(root, "parts"))
    read_part(assembly, scope, part);
  assembly.table.name = name;
  if (root.has("generate")) read_generated(assembly, base, root["generate"]);
  if (root.has("urdf")) read_urdf(assembly, scope, root["urdf"]);
  read_chains_and_frames(assembly, scope, root);
  assembly.problems.throw_if_any();  // further errors would only be consequences
  read_fixed_joints(assembly, scope, root);
  attempt([&] { read_frame_name(assembly, scope, root, "shoulder", assembly.shoulder); });
  attempt([&] { read_frame_name(assembly, scope, root, "palm", assembly.palm); });
  for (const config::ConfigNode& tip : optional_items(root, "tips"))
    attempt([&] { read_tip(assembly, scope, tip); });
  if (root.has("side")) {
    const std::optional<Side> side = morphe::enum_from_name<Side>(root["side"].text());
    if (!side) attempt([&] { root["side"].fail("must be left or right"); });
    assembly.table.side = side.value_or(assembly.table.side);
  }
  read_natural_posture(assembly, scope, root);
  attempt([&] { read_centres(assembly, scope, optional_items(root, "joint_centres")); });
  for (const config::ConfigNode& sentence : optional_items(root, "check"))
    attempt([&] { assembly.checks.push_back(sentence.text()); });
  read_assumed(assembly, root);
  if (root.has("collision")) read_collision(assembly, scope, root["collision"]);
  if (assembly.problems.none()) root.require_all_keys_read();
  if (assembly.chains.empty() && assembly.problems.none()) root.fail("has no chains");
  return scope;
}

RobotDescription build_description(const config::ConfigNode& root) {
  const std::string file = root.file().string();
  Assembly assembly;
  config::ErrorList& problems = assembly.problems;
  problems.attempt([&] { read_description(root, MountPoint{}, "", assembly); });
  problems.throw_if_any();
  if (assembly.palm.empty() && std::ranges::none_of(assembly.chains, &Chain::arm)) {
    problems.add(fmt::format(
        "{}:1: palm: is missing, and there is no chain 'arm' whose end could be used", file));
  }
  if (assembly.table.tips.empty()) problems.add(fmt::format("{}:1: tips: are missing", file));
  problems.throw_if_any();
  finalize_robot(assembly);
  problems.throw_if_any();
  return {std::move(assembly.table),   std::move(assembly.files),  std::move(assembly.notes),
          std::move(assembly.natural), std::move(assembly.links),  std::move(assembly.urdfs),
          std::move(assembly.checks),  std::move(assembly.assumed)};
}

}  // namespace

RobotDescription load_robot(const std::filesystem::path& file, const files::GivenFiles* given) {
  return build_description(load_node(file, given));
}

RobotDescription parse_robot(const std::string& text, const std::filesystem::path& file) {
  return build_description(config::ConfigNode::parse(text, file.string()));
}

}  // namespace morphe::robot
