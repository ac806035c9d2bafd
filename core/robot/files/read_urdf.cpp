#include "core/robot/files/read_urdf.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/robot/files/limit_bounds.hpp"
#include "core/robot/files/robot_file.hpp"
#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {
namespace {

/// Keeps urdfdom from writing to the console while it exists, and records its first error.
class QuietConsole : console_bridge::OutputHandler {
 public:
  QuietConsole() { console_bridge::useOutputHandler(this); }
  ~QuietConsole() override { console_bridge::restorePreviousOutputHandler(); }
  std::string first_error = "is not a URDF";

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    if (!failed_) first_error = text;
    failed_ = true;
  }
  bool failed_ = false;
};

/// Adds limits and efforts, which urdfdom requires, removes elements that are not used, and makes
/// planar and floating joints fixed.
void simplify(tinyxml2::XMLDocument& document) {
  tinyxml2::XMLElement* robot = document.RootElement();
  const auto remove = [](tinyxml2::XMLElement* parent, std::initializer_list<const char*> tags) {
    for (const char* tag : tags) {
      while (auto* child = parent->FirstChildElement(tag)) parent->DeleteChild(child);
    }
  };
  remove(robot, {"material", "transmission", "gazebo", "sensor"});
  for (auto* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    remove(link, {"visual", "inertial"});
  }
  for (auto* joint = robot->FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    remove(joint, {"safety_controller", "calibration", "dynamics"});
    const std::string type = joint->Attribute("type");
    if (type == "planar" || type == "floating") joint->SetAttribute("type", "fixed");
    if (type != "revolute" && type != "prismatic" && type != "continuous") continue;
    tinyxml2::XMLElement* limit = joint->FirstChildElement("limit");
    if (!limit) limit = joint->InsertNewChildElement("limit");
    for (const char* needed : {"effort", "velocity"}) {
      if (!limit->Attribute(needed)) limit->SetAttribute(needed, 0);
    }
  }
}

urdf::ModelInterfaceSharedPtr parse_with_urdfdom(const files::XmlText& text) {
  tinyxml2::XMLDocument simple;
  text.document.DeepCopy(&simple);
  simplify(simple);
  tinyxml2::XMLPrinter printer;
  simple.Print(&printer);
  QuietConsole console;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(printer.CStr());
  if (!model) text.fail(text.root(), "robot", console.first_error);
  return model;
}

struct Reader {
  Assembly& assembly;
  FileScope& scope;
  const config::ConfigNode& node;  ///< of the key `urdf`
  const files::XmlText& text;
  const urdf::ModelInterface& model;
  UrdfTree tree;
  std::map<std::string, config::ConfigNode> own;  ///< limits that the description gives for a joint

  const urdf::Joint& urdf_joint(const UrdfJoint& joint) const {
    return *model.joints_.at(joint.name);
  }
  [[noreturn]] void fail(const UrdfJoint& joint, const char* part,
                         const std::string& message) const {
    text.fail(*joint.element, fmt::format("joint {}{}", joint.name, part), message);
  }
  bool is_actuated(const UrdfJoint& joint) const {
    return joint.kind != JointKind::fixed && !urdf_joint(joint).mimic;
  }

  /// Returns the limit that the description gives for this joint, else the one in the URDF, else
  /// the one that the description gives for all joints.
  std::optional<double> limit_value(const UrdfJoint& joint, const char* key,
                                    std::optional<double> written = std::nullopt) const {
    const KeyBounds& bounds = limit_bounds(key);
    const auto entry = own.find(joint.name);
    if (entry != own.end() && entry->second.has(key)) return entry->second[key].number(bounds);
    if (written) return written;
    if (node.has(key)) return node[key].number(bounds);
    return std::nullopt;
  }

  void read_limit_overrides() {
    for (const char* key : {"velocity", "acceleration", "jerk"})
      if (node.has(key)) node[key].number(limit_bounds(key));
    for (const config::ConfigNode& entry : optional_items(node, "limits")) {
      assembly.problems.attempt([&] {
        const UrdfJoint* joint = find_joint(tree, entry["joint"].text());
        if (!joint || joint->kind == JointKind::fixed) {
          entry["joint"].fail(
              fmt::format("there is no joint '{}' that moves", entry["joint"].text()));
        }
        if (!own.emplace(joint->name, entry).second) entry["joint"].fail("appears twice");
      });
    }
  }

  double positive_limit(const UrdfJoint& joint, const char* key,
                        std::optional<double> written) const {
    const std::optional<double> value = limit_value(joint, key, written);
    if (value && *value > 0 && std::isfinite(*value)) return *value;
    if (value && *value < 0) fail(joint, fmt::format(".{}", key).c_str(), "must be above 0");
    node.fail(
        fmt::format("joint '{}' needs a{} {} above 0: give it in the URDF, for all joints in "
                    "urdf.{} or for this one in urdf.limits",
                    joint.name, *key == 'a' ? "n" : "", key, key));
  }

  /// Refuses limits of the file in another unit, unless the description replaces them.
  void expect_believed_limits(const UrdfJoint& joint) const {
    const auto entry = own.find(joint.name);
    const bool replaced =
        entry != own.end() && entry->second.has("lower") && entry->second.has("upper");
    if (!joint.lower || replaced) return;
    const bool slides = joint.kind == JointKind::prismatic;
    const double most = slides ? kMaxBelievedLimit_m : kMaxBelievedLimit_rad;
    if (std::max(std::abs(*joint.lower), std::abs(*joint.upper)) <= most) return;
    const double unit = slides ? 1e-3 : std::numbers::pi / 180;
    const double lower = unit * *joint.lower, upper = unit * *joint.upper;
    fail(joint, ".limit",
         fmt::format(
             "{:g} to {:g} {} are {} or wrong (beyond {:.3g} {}): correct the file, or give "
             "{{joint: {}, lower: {:.4g}, upper: {:.4g}}} in urdf.limits (robot setup: "
             "--limit {}={:.4g}..{:.4g})",
             *joint.lower, *joint.upper, slides ? "m" : "rad", slides ? "millimetres" : "degrees",
             most, slides ? "m" : "rad", joint.name, lower, upper, joint.name, lower, upper));
  }

  void add_limits(const UrdfJoint& joint) {
    expect_believed_limits(joint);
    const bool turns_round = joint.kind == JointKind::continuous;
    const double round = 2 * std::numbers::pi;
    const auto lower = limit_value(joint, "lower", turns_round ? -round : joint.lower);
    const auto upper = limit_value(joint, "upper", turns_round ? round : joint.upper);
    if (!lower || !upper) {
      fail(joint, ".limit",
           "is missing; add it to the URDF or give `lower` and `upper` in urdf.limits");
    }
    if (*lower > *upper) own.at(joint.name)["upper"].fail("must be above lower");
    const bool locked = *lower == *upper;  // needs no other limits
    const auto rate = [&](const char* key, std::optional<double> written) {
      return locked ? 1 : positive_limit(joint, key, written);
    };
    const double velocity = rate("velocity", joint.velocity);
    const double acceleration = rate("acceleration", std::nullopt);
    const double jerk = rate("jerk", std::nullopt);
    const std::string name = scope.prefix + joint.name;
    if (std::ranges::count(assembly.table.joint_names, name) > 0)
      fail(joint, "", fmt::format("a joint '{}' already exists; give this part a `prefix`", name));
    if (locked) assembly.fixed_joints.push_back({name, *lower});
    const int index = append_joint(assembly, name, {*lower, *upper, velocity, acceleration, jerk});
    read_braking(joint, index);
  }

  /// Reads `braking: {twice_deceleration, velocity_offset, lower_end, upper_end}` of a joint.
  void read_braking(const UrdfJoint& joint, int index) {
    const auto entry = own.find(joint.name);
    if (entry == own.end() || !entry->second.has("braking")) return;
    const config::ConfigNode braking = entry->second["braking"];
    RobotModel::BrakingCurve curve;
    curve.joint = index;
    curve.twice_deceleration = braking["twice_deceleration"].number(bounds::kJointAcceleration);
    curve.velocity_offset = braking["velocity_offset"].number(bounds::kSpeedOffset);
    curve.lower_end = braking["lower_end"].number(bounds::kJointPosition);
    curve.upper_end = braking["upper_end"].number(bounds::kJointPosition);
    assembly.table.braking_curves.push_back(curve);
  }

  /// Computes the driven joint, ratio and offset of a frame through joints that mimic one another.
  void resolve_mimic(const UrdfJoint& joint, RobotModel::Frame& frame) const {
    const UrdfJoint* driver = &joint;
    for (int steps = 0; !is_actuated(*driver); ++steps) {
      const urdf::Joint& urdf = urdf_joint(*driver);
      if (steps > std::ssize(tree.joints))
        fail(joint, ".mimic", "is coupled to itself (mimic loop)");
      const UrdfJoint* next = urdf.mimic ? find_joint(tree, urdf.mimic->joint_name) : nullptr;
      if (!next || next->kind == JointKind::fixed) {
        fail(joint, ".mimic",
             fmt::format("there is no joint '{}' to mimic", urdf.mimic->joint_name));
      }
      frame.offset += frame.ratio * urdf.mimic->offset;
      frame.ratio *= urdf.mimic->multiplier;
      driver = next;
    }
    if (frame.ratio == 0) fail(joint, ".mimic.multiplier", "must not be 0");
    frame.joint = find_joint(assembly.table, scope, driver->name);
  }

  /// Reads the limits of a mimic joint; `enforce_position_limits: false` omits those of position.
  void limit_coupled(const UrdfJoint& joint, int frame) {
    expect_believed_limits(joint);
    RobotModel::CoupledLimit limit;
    limit.frame = frame;
    const auto entry = own.find(joint.name);
    const bool enforced = entry == own.end() || !entry->second.has("enforce_position_limits") ||
                          entry->second["enforce_position_limits"].boolean();
    if (enforced) {
      limit.lower = limit_value(joint, "lower", joint.lower).value_or(limit.lower);
      limit.upper = limit_value(joint, "upper", joint.upper).value_or(limit.upper);
    }
    const auto read = [&](const char* key, std::optional<double> written, double& value) {
      const std::optional<double> entry_value = limit_value(joint, key, written);
      if (entry_value && *entry_value > 0) value = *entry_value;
    };
    read("velocity", joint.velocity, limit.velocity);
    read("acceleration", std::nullopt, limit.acceleration);
    read("jerk", std::nullopt, limit.jerk);
    assembly.table.coupled_limits.push_back(limit);
  }

  /// Returns a name for the joint's frame: the joint's, or its child link's if it is fixed. If the
  /// same URDF has used it, the other one or a new name, because only frames share one name space.
  std::string free_name(const UrdfJoint& joint) const {
    const bool fixed = joint.kind == JointKind::fixed;
    const std::string name = scope.prefix + (fixed ? joint.child : joint.name);
    if (!has_frame_or_chain(assembly, name)) return name;
    const std::string other = scope.prefix + (fixed ? joint.name : joint.child);
    if (!scope.links.contains(name) && !find_joint(tree, name)) {
      fail(joint, "",
           fmt::format("a frame or chain '{}' already exists; give this part a `prefix`", name));
    }
    if (!has_frame_or_chain(assembly, other)) return other;
    return name + (fixed ? "_link" : "_joint");
  }

  int add_joint_frame(const UrdfJoint& joint) {
    const urdf::Joint& urdf = urdf_joint(joint);
    RobotModel::Frame frame;
    frame.name = free_name(joint);
    frame.parent = scope.links.at(scope.prefix + joint.parent);
    frame.transform = pose_of(urdf.parent_to_joint_origin_transform);
    if (joint.kind != JointKind::fixed) {
      frame.axis = Vec3(urdf.axis.x, urdf.axis.y, urdf.axis.z).normalized();
      frame.prismatic = joint.kind == JointKind::prismatic;
      resolve_mimic(joint, frame);
    }
    const int index = append_frame(assembly.table, std::move(frame));
    if (urdf.mimic && joint.kind != JointKind::fixed) limit_coupled(joint, index);
    return index;
  }

  int add_root_frame() {
    RobotModel::Frame frame{scope.prefix + tree.root, scope.base.frame,
                            scope.base.frame_from_mount};
    const bool taken = has_frame_or_chain(assembly, frame.name) || find_joint(tree, tree.root);
    if (taken) frame.name += "_link";
    if (has_frame_or_chain(assembly, frame.name)) {
      text.fail(text.root(), "robot",
                fmt::format("a frame '{}' already exists; give this part a `prefix`", frame.name));
    }
    return append_frame(assembly.table, std::move(frame));
  }

  void add_link(const std::string& link, int frame) {
    scope.links[scope.prefix + link] = frame;
    assembly.links[scope.prefix + link] = frame;
    assembly.urdfs.back().links[link] = frame;
  }
};

bool read_shapes_key(const config::ConfigNode& node) {
  if (!node.has("shapes")) return true;
  const std::string word = node["shapes"].text();
  if (word != "use" && word != "ignore") node["shapes"].fail("must be use or ignore");
  return word == "use";
}

}  // namespace

Pose pose_of(const urdf::Pose& pose) {
  const auto& [x, y, z, w] = pose.rotation;
  return make_pose({pose.position.x, pose.position.y, pose.position.z},
                   Quat(w, x, y, z).normalized());
}

void read_urdf(Assembly& assembly, FileScope& scope, const config::ConfigNode& node) {
  const std::filesystem::path file = node.folder() / node["file"].text();
  const files::XmlText text = read_urdf_text(file, node.given());
  assembly.files.push_back(text.file);
  UrdfTree tree = urdf_tree(text);
  const urdf::ModelInterfaceSharedPtr model = parse_with_urdfdom(text);
  Reader reader{assembly, scope, node, text, *model, std::move(tree), {}};
  std::ranges::copy(reader.tree.notes, std::back_inserter(assembly.notes));
  reader.read_limit_overrides();
  config::ErrorList problems;
  for (const UrdfJoint& joint : reader.tree.joints) {
    if (reader.is_actuated(joint)) problems.attempt([&] { reader.add_limits(joint); });
  }
  problems.throw_if_any();
  assembly.urdfs.push_back({file, scope.prefix, {}});
  reader.add_link(reader.tree.root, reader.add_root_frame());
  for (const UrdfJoint& joint : reader.tree.joints)
    reader.add_link(joint.child, reader.add_joint_frame(joint));
  const bool use_shapes = read_shapes_key(node);
  const auto shapes_of = [&](const std::string& link) {
    add_link_shapes(assembly, text, *model->links_.at(link), scope.links.at(scope.prefix + link),
                    use_shapes, scope.prefix);
  };
  shapes_of(reader.tree.root);
  for (const UrdfJoint& joint : reader.tree.joints) shapes_of(joint.child);
  if (node.has("srdf"))
    read_srdf(assembly, scope, node.folder() / node["srdf"].text(), node.given());
}

}  // namespace morphe::robot
