#include "core/robot/files/read_urdf.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {
namespace {

/// Suppresses urdfdom's console messages during its lifetime.
class QuietConsole : console_bridge::OutputHandler {
 public:
  QuietConsole() { console_bridge::useOutputHandler(this); }
  ~QuietConsole() override { console_bridge::restorePreviousOutputHandler(); }
  std::string first = "is not a URDF";

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && !said_) first = text;
    said_ = said_ || level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR;
  }
  bool said_ = false;
};

/// Adds limits and efforts that urdfdom requires although they may come from the description or are
/// not needed, and removes the visual elements that are not used.
void simplify(tinyxml2::XMLDocument& document) {
  tinyxml2::XMLElement* robot = document.RootElement();
  for (const char* tag : {"material", "transmission", "gazebo", "sensor"}) {
    while (tinyxml2::XMLElement* extra = robot->FirstChildElement(tag)) robot->DeleteChild(extra);
  }
  for (auto* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    for (const char* tag : {"visual", "inertial"}) {
      while (tinyxml2::XMLElement* extra = link->FirstChildElement(tag)) link->DeleteChild(extra);
    }
  }
  for (auto* joint = robot->FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    for (const char* tag : {"safety_controller", "calibration", "dynamics"}) {
      while (tinyxml2::XMLElement* extra = joint->FirstChildElement(tag)) joint->DeleteChild(extra);
    }
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
  if (!model) text.fail(text.root(), "robot", console.first);
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
  [[noreturn]] void fail(const UrdfJoint& joint, const char* part, const std::string& what) const {
    text.fail(*joint.element, fmt::format("joint {}{}", joint.name, part), what);
  }
  bool is_actuated(const UrdfJoint& joint) const {
    return joint.kind != JointKind::fixed && !urdf_joint(joint).mimic;
  }
  const UrdfJoint* find(const std::string& name) const {
    const auto found = std::ranges::find(tree.joints, name, &UrdfJoint::name);
    return found == tree.joints.end() ? nullptr : &*found;
  }

  /// Returns the limit that the description gives for this joint, else the one in the URDF, else
  /// the one that the description gives for all joints.
  std::optional<double> limit_value(const UrdfJoint& joint, const char* key,
                                    std::optional<double> written = std::nullopt) const {
    const auto entry = own.find(joint.name);
    if (entry != own.end() && entry->second.has(key)) return entry->second[key].number();
    if (written) return written;
    if (node.has(key)) return node[key].number();
    return std::nullopt;
  }

  void read_limit_overrides() {
    for (const char* key : {"velocity", "acceleration", "jerk"}) {
      if (node.has(key) && !(node[key].number() > 0)) node[key].fail("must be above 0");
    }
    if (!node.has("limits")) return;
    for (const config::ConfigNode& entry : node["limits"].items()) {
      assembly.problems.attempt([&] {
        const UrdfJoint* joint = find(entry["joint"].text());
        if (!joint || joint->kind == JointKind::fixed) {
          entry["joint"].fail(
              fmt::format("there is no joint '{}' that moves", entry["joint"].text()));
        }
        if (!own.emplace(joint->name, entry).second) entry["joint"].fail("appears twice");
      });
    }
  }

  double positive(const UrdfJoint& joint, const char* key, std::optional<double> written) const {
    const std::optional<double> value = limit_value(joint, key, written);
    if (value && *value > 0 && std::isfinite(*value)) return *value;
    if (value && *value < 0) fail(joint, fmt::format(".{}", key).c_str(), "must be above 0");
    node.fail(
        fmt::format("joint '{}' needs a{} {} above 0: give it in the URDF, for all joints in "
                    "urdf.{} or for this one in urdf.limits",
                    joint.name, *key == 'a' ? "n" : "", key, key));
  }

  void add_limits(const UrdfJoint& joint) {
    const bool turns_round = joint.kind == JointKind::continuous;
    const double round = 2 * std::numbers::pi;
    const auto lower = limit_value(joint, "lower", turns_round ? -round : joint.lower);
    const auto upper = limit_value(joint, "upper", turns_round ? round : joint.upper);
    if (!lower || !upper) {
      fail(joint, ".limit",
           "is missing; add it to the URDF or give `lower` and `upper` in urdf.limits");
    }
    if (*lower > *upper) own.at(joint.name)["upper"].fail("must be above lower");
    const double velocity = positive(joint, "velocity", joint.velocity);
    const double acceleration = positive(joint, "acceleration", std::nullopt);
    const double jerk = positive(joint, "jerk", std::nullopt);
    const std::string name = scope.prefix + joint.name;
    if (std::ranges::count(assembly.table.joint_names, name) > 0) {
      fail(joint, "", fmt::format("a joint '{}' already exists; give this part a `prefix`", name));
    }
    if (*lower == *upper) assembly.fixed_joints.push_back({name, *lower});
    read_braking(joint);
    assembly.lower.push_back(*lower);
    assembly.upper.push_back(*upper);
    assembly.velocity.push_back(velocity);
    assembly.acceleration.push_back(acceleration);
    assembly.jerk.push_back(jerk);
    assembly.table.joint_names.push_back(name);
  }

  /// Reads `braking: {slope, drop, lower_end, upper_end}` of the next joint to be added.
  void read_braking(const UrdfJoint& joint) {
    const auto entry = own.find(joint.name);
    if (entry == own.end() || !entry->second.has("braking")) return;
    const config::ConfigNode braking = entry->second["braking"];
    RobotModel::BrakingCurve curve;
    curve.joint = static_cast<int>(assembly.table.joints());
    curve.twice_deceleration = braking["twice_deceleration"].number();
    curve.velocity_offset = braking["velocity_offset"].number();
    curve.lower_end = braking["lower_end"].number();
    curve.upper_end = braking["upper_end"].number();
    if (!(curve.twice_deceleration > 0)) braking["twice_deceleration"].fail("must be above 0");
    if (!(curve.velocity_offset >= 0)) braking["velocity_offset"].fail("must not be negative");
    assembly.table.braking_curves.push_back(curve);
  }

  /// Resolves value = ratio * (driven joint) + offset through any number of joints that mimic each
  /// other.
  void resolve_mimic(const UrdfJoint& joint, RobotModel::Frame& frame) const {
    const UrdfJoint* at = &joint;
    for (std::size_t steps = 0; !is_actuated(*at); ++steps) {
      const urdf::Joint& urdf = urdf_joint(*at);
      if (steps > tree.joints.size()) fail(joint, ".mimic", "is coupled to itself (mimic loop)");
      const UrdfJoint* next = urdf.mimic ? find(urdf.mimic->joint_name) : nullptr;
      if (!next || next->kind == JointKind::fixed) {
        fail(joint, ".mimic",
             fmt::format("there is no joint '{}' to mimic", urdf.mimic->joint_name));
      }
      frame.offset += frame.ratio * urdf.mimic->offset;
      frame.ratio *= urdf.mimic->multiplier;
      at = next;
    }
    if (frame.ratio == 0) fail(joint, ".mimic.multiplier", "must not be 0");
    frame.joint =
        static_cast<int>(std::ranges::find(assembly.table.joint_names, scope.prefix + at->name) -
                         assembly.table.joint_names.begin());
  }

  /// Reads the limits of a mimic joint; `enforce: false` omits those of its position.
  void limit_coupled(const UrdfJoint& joint, int frame) {
    RobotModel::CoupledLimit limit;
    limit.frame = frame;
    const auto entry = own.find(joint.name);
    const bool enforced = entry == own.end() || !entry->second.has("enforce_position_limits") ||
                          entry->second["enforce_position_limits"].boolean();
    if (enforced) {
      limit.lower = limit_value(joint, "lower", joint.lower).value_or(limit.lower);
      limit.upper = limit_value(joint, "upper", joint.upper).value_or(limit.upper);
    }
    const auto most = [&](const char* key, std::optional<double> written, double& value) {
      if (const auto given = limit_value(joint, key, written); given && *given > 0) value = *given;
    };
    most("velocity", joint.velocity, limit.velocity);
    most("acceleration", std::nullopt, limit.acceleration);
    most("jerk", std::nullopt, limit.jerk);
    assembly.table.coupled_limits.push_back(limit);
  }

  /// Returns a frame name that is not in use: the joint's name, or the link's if it is fixed.
  /// Joints and links have separate name spaces in a URDF, frames do not.
  std::string free_name(const UrdfJoint& joint) const {
    const bool fixed = joint.kind == JointKind::fixed;
    const std::string name = scope.prefix + (fixed ? joint.child : joint.name);
    if (!has_frame_or_chain(assembly, name)) return name;
    const std::string other = scope.prefix + (fixed ? joint.name : joint.child);
    if (!scope.links.contains(name) && !find(name)) {
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
    assembly.table.frames.push_back(std::move(frame));
    const int index = static_cast<int>(assembly.table.frames.size()) - 1;
    if (urdf.mimic && joint.kind != JointKind::fixed) limit_coupled(joint, index);
    return index;
  }

  int add_root_frame() {
    RobotModel::Frame frame;
    frame.name = scope.prefix + tree.root;
    frame.parent = scope.base.frame;
    frame.transform = scope.base.frame_from_mount;
    const bool taken = has_frame_or_chain(assembly, frame.name) || find(tree.root);
    if (taken) frame.name += "_link";
    if (has_frame_or_chain(assembly, frame.name)) {
      text.fail(text.root(), "robot",
                fmt::format("a frame '{}' already exists; give this part a `prefix`", frame.name));
    }
    assembly.table.frames.push_back(std::move(frame));
    return static_cast<int>(assembly.table.frames.size()) - 1;
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
  const files::XmlText text(file, "robot");
  assembly.files.push_back(file);
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
  for (const UrdfJoint& joint : reader.tree.joints) {
    reader.add_link(joint.child, reader.add_joint_frame(joint));
  }
  const bool use_shapes = read_shapes_key(node);
  const auto shapes_of = [&](const std::string& link) {
    add_link_shapes(assembly, text, *model->links_.at(link), scope.links.at(scope.prefix + link),
                    use_shapes, scope.prefix);
  };
  shapes_of(reader.tree.root);
  for (const UrdfJoint& joint : reader.tree.joints) shapes_of(joint.child);
  if (node.has("srdf")) read_srdf(assembly, scope, node.folder() / node["srdf"].text());
}

}  // namespace morphe::robot
