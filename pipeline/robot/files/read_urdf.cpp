#include "pipeline/robot/files/read_urdf.hpp"
#include "pipeline/robot/files/urdf_joints.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::robot {
namespace {

/// Keeps urdfdom's messages off the console while it lives.
class QuietConsole : console_bridge::OutputHandler {
 public:
  QuietConsole() { console_bridge::useOutputHandler(this); }
  ~QuietConsole() override { console_bridge::restorePreviousOutputHandler(); }
  std::string first = "is no URDF";

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && !said_) first = text;
    said_ = said_ || level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR;
  }
  bool said_ = false;
};

urdf::ModelInterfaceSharedPtr parsed(const files::XmlText& text) {
  tinyxml2::XMLPrinter printer;
  text.document.Print(&printer);
  QuietConsole console;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(printer.CStr());
  if (!model) text.fail(text.root(), "robot", console.first);
  return model;
}

struct Reader {
  Assembly& assembly;
  const config::ConfigNode& node;  ///< of the key `urdf`
  const files::XmlText& text;
  const urdf::ModelInterface& model;
  std::vector<UrdfJoint> joints;

  const urdf::Joint& of(const UrdfJoint& joint) const { return *model.joints_.at(joint.name); }
  [[noreturn]] void fail(const UrdfJoint& joint, const char* part, const std::string& what) const {
    text.fail(*joint.element, fmt::format("joint {}{}", joint.name, part), what);
  }
  bool driven(const UrdfJoint& joint) const {
    return of(joint).type != urdf::Joint::FIXED && !of(joint).mimic;
  }
  const UrdfJoint* find(const std::string& name) const {
    const auto found = std::ranges::find(joints, name, &UrdfJoint::name);
    return found == joints.end() ? nullptr : &*found;
  }

  /// What the description says about a joint's limits, if it does.
  const config::ConfigNode* limits_of(const std::string& joint,
                                      const std::vector<config::ConfigNode>& limits) const {
    const auto found = std::ranges::find_if(
        limits, [&](const config::ConfigNode& entry) { return entry["joint"].text() == joint; });
    return found == limits.end() ? nullptr : &*found;
  }

  void add_limits(const UrdfJoint& joint, const std::vector<config::ConfigNode>& limits) {
    const urdf::Joint& urdf = of(joint);
    const config::ConfigNode* own = limits_of(joint.name, limits);
    const auto stated = [&](const char* key) -> double {
      if (own && own->has(key)) return (*own)[key].number();
      return node.has(key) ? node[key].number() : 0;
    };
    const auto bound = [&](const char* key, double written) {
      return own && own->has(key) ? (*own)[key].number() : written;
    };
    const bool turns_round = urdf.type == urdf::Joint::CONTINUOUS;
    const double lower = bound("lower", turns_round ? -std::numbers::pi : urdf.limits->lower);
    const double upper = bound("upper", turns_round ? std::numbers::pi : urdf.limits->upper);
    if (!(lower < upper)) (*own)["upper"].fail("must be above lower");
    double velocity = stated("velocity");
    if (velocity == 0 && urdf.limits) velocity = urdf.limits->velocity;
    const double acceleration = stated("acceleration"), jerk = stated("jerk");
    if (!(velocity > 0))
      fail(joint, ".limit.velocity", "must be above 0, here or in the description");
    if (!(acceleration > 0) || !(jerk > 0)) {
      node.fail(
          fmt::format("joint '{}' needs an acceleration and a jerk above 0, for all joints or "
                      "in limits",
                      joint.name));
    }
    assembly.lower.push_back(lower);
    assembly.upper.push_back(upper);
    assembly.velocity.push_back(velocity);
    assembly.acceleration.push_back(acceleration);
    assembly.jerk.push_back(jerk);
    assembly.table.joint_names.push_back(joint.name);
  }

  /// angle = ratio * (driven joint) + offset, through any number of joints that copy each other.
  void couple(const UrdfJoint& joint, RobotTable::Frame& frame) const {
    const UrdfJoint* at = &joint;
    for (std::size_t steps = 0; !driven(*at); ++steps) {
      const urdf::Joint& urdf = of(*at);
      if (steps > joints.size()) fail(joint, ".mimic", "is coupled to itself");
      const UrdfJoint* next = urdf.mimic ? find(urdf.mimic->joint_name) : nullptr;
      if (!next || of(*next).type == urdf::Joint::FIXED) {
        fail(joint, ".mimic",
             fmt::format("there is no joint '{}' to copy", urdf.mimic->joint_name));
      }
      frame.offset += frame.ratio * urdf.mimic->offset;
      frame.ratio *= urdf.mimic->multiplier;
      at = next;
    }
    if (frame.ratio == 0) fail(joint, ".mimic.multiplier", "must not be 0");
    frame.joint = static_cast<int>(std::ranges::find(assembly.table.joint_names, at->name) -
                                   assembly.table.joint_names.begin());
  }

  int add_joint_frame(const UrdfJoint& joint, const Anchor& parent) {
    const urdf::Joint& urdf = of(joint);
    const bool fixed = urdf.type == urdf::Joint::FIXED;
    RobotTable::Frame frame;
    frame.name = fixed ? joint.child : joint.name;
    if (has_anchor(assembly, frame.name)) {
      fail(joint, "", fmt::format("a frame or chain '{}' exists already", frame.name));
    }
    frame.parent = parent.frame;
    frame.transform = parent.frame_from_anchor * pose_of(urdf.parent_to_joint_origin_transform);
    if (!fixed) {
      frame.axis = Vec3(urdf.axis.x, urdf.axis.y, urdf.axis.z).normalized();
      couple(joint, frame);
    }
    assembly.table.frames.push_back(std::move(frame));
    return static_cast<int>(assembly.table.frames.size()) - 1;
  }
};

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
  std::vector<UrdfJoint> joints = urdf_joints(text);
  const urdf::ModelInterfaceSharedPtr model = parsed(text);
  Reader reader{assembly, node, text, *model, std::move(joints)};
  std::vector<config::ConfigNode> limits;
  if (node.has("limits")) limits = node["limits"].items();
  for (const config::ConfigNode& entry : limits) {
    const UrdfJoint* joint = reader.find(entry["joint"].text());
    if (!joint || !reader.driven(*joint)) {
      entry["joint"].fail(fmt::format("there is no actuated joint '{}'", entry["joint"].text()));
    }
  }
  for (const UrdfJoint& joint : reader.joints) {
    if (reader.driven(joint)) reader.add_limits(joint, limits);
  }
  const std::string root = model->getRoot()->name;
  scope.links[root] = scope.base;
  for (const UrdfJoint& joint : reader.joints) {
    scope.links[joint.child] = {reader.add_joint_frame(joint, scope.links.at(joint.parent))};
  }
  for (const auto& [link, place] : scope.links) assembly.links.emplace(link, place.frame);
  bool ignore_meshes = false;
  if (node.has("meshes")) {
    const std::string word = node["meshes"].text();
    if (word != "refuse" && word != "ignore") node["meshes"].fail("must be refuse or ignore");
    ignore_meshes = word == "ignore";
  }
  add_link_shapes(assembly, text, *model->getRoot(), scope.base, ignore_meshes);
  for (const UrdfJoint& joint : reader.joints) {
    add_link_shapes(assembly, text, *model->links_.at(joint.child), scope.links.at(joint.child),
                    ignore_meshes);
  }
  if (node.has("srdf")) read_srdf(assembly, scope, node.folder() / node["srdf"].text());
}

}  // namespace morphe::robot
