#include "core/robot/files/urdf_model.hpp"

#include <fmt/format.h>

#include "core/motion/enum_names.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/assembly.hpp"
#include "core/robot/files/robot_file.hpp"

namespace morphe::robot {
namespace {

using files::XmlElement;

std::vector<double> attribute_numbers(const XmlElement* element, const char* name) {
  const char* text = element ? element->Attribute(name) : nullptr;
  return text ? numbers_of(text) : std::vector<double>{};
}

Vec3 vector_of(const XmlElement* element, const char* name, const Vec3& otherwise) {
  const std::vector<double> n = attribute_numbers(element, name);
  return n.size() == 3 ? Vec3(n[0], n[1], n[2]) : otherwise;
}

double number_of(const XmlElement* element, const char* name) {
  const std::vector<double> n = attribute_numbers(element, name);
  return n.size() == 1 ? n.front() : 0;
}

Pose origin_of(const XmlElement& owner) {
  const XmlElement* origin = owner.FirstChildElement("origin");
  const Vec3 rpy = vector_of(origin, "rpy", Vec3::Zero());
  Pose pose = Pose::Identity();
  pose.translate(vector_of(origin, "xyz", Vec3::Zero()));
  pose.rotate(Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) *
              Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()));
  return pose;
}

/// Reads a shape; returns false if the element contains no supported shape.
bool read_shape(const XmlElement& element, UrdfShape& shape) {
  const XmlElement* geometry = element.FirstChildElement("geometry");
  const XmlElement* found = geometry ? geometry->FirstChildElement() : nullptr;
  if (!found) return false;
  shape.link_from_shape = origin_of(element);
  const std::optional<Shape> kind = morphe::enum_from_name<Shape>(found->Value());
  if (!kind) return false;
  shape.kind = *kind;
  switch (*kind) {
    case Shape::sphere:
      shape.size = {number_of(found, "radius"), 0, 0};
      break;
    case Shape::box:
      shape.size = vector_of(found, "size", Vec3::Zero());
      break;
    case Shape::cylinder:
    case Shape::capsule:
      shape.size = {number_of(found, "radius"), number_of(found, "length"), 0};
      break;
    case Shape::mesh:
      const char* file = found->Attribute("filename");
      shape.mesh = file ? file : "";
      shape.size = vector_of(found, "scale", Vec3::Ones());
  }
  return true;
}

void read_link(const XmlElement& link, UrdfModel& model) {
  const std::string name = link.Attribute("name");
  for (const char* tag : {"collision", "visual"}) {
    for (const XmlElement* element : files::children(link, tag)) {
      UrdfShape shape;
      shape.link = name;
      shape.visual = *tag == 'v';
      if (read_shape(*element, shape)) model.shapes.push_back(shape);
    }
  }
  const XmlElement* inertial = link.FirstChildElement("inertial");
  if (!inertial) return;
  UrdfInertia inertia;
  inertia.mass = number_of(inertial->FirstChildElement("mass"), "value");
  inertia.link_from_inertia = origin_of(*inertial);
  const XmlElement* tensor = inertial->FirstChildElement("inertia");
  const auto entry = [&](const char* key) { return number_of(tensor, key); };
  inertia.inertia << entry("ixx"), entry("ixy"), entry("ixz"), entry("ixy"), entry("iyy"),
      entry("iyz"), entry("ixz"), entry("iyz"), entry("izz");
  model.inertias.emplace(name, inertia);
}

/// Returns the text of a description with only the key `urdf`, the limits that the URDF lacks, and
/// those that replace it.
std::string urdf_key_text(const UrdfModel& model, const GivenLimits& given,
                          const AssumedLimits& assumed) {
  std::string text = fmt::format(
      "urdf:\n  file: '{}'\n  velocity: {}\n  acceleration: {}\n  jerk: {}\n  limits:\n",
      model.file.filename().string(), assumed.velocity, assumed.acceleration, assumed.jerk);
  for (const auto& [joint, limits] : given) {
    const UrdfJoint* found = model.joint(joint);
    if (!found || found->kind == JointKind::fixed)
      throw InputError(
          fmt::format("{}: limits are given for '{}', but there is no such joint that "
                      "moves",
                      model.file.string(), joint));
    text +=
        fmt::format("    - {{joint: '{}', lower: {}, upper: {}}}\n", joint, limits[0], limits[1]);
  }
  for (const UrdfJoint& joint : model.tree.joints) {
    if (given.contains(joint.name)) continue;
    const bool bounded = joint.kind == JointKind::revolute || joint.kind == JointKind::prismatic;
    if (!bounded || joint.lower || joint.element->FirstChildElement("mimic")) continue;
    text += fmt::format("    - {{joint: '{}', lower: -{}, upper: {}}}\n", joint.name,
                        assumed.position, assumed.position);
  }
  if (text.ends_with("limits:\n")) text.erase(text.size() - 10);  // an empty `  limits:`
  return text;
}

}  // namespace

std::vector<std::string> UrdfModel::link_of_frame() const {
  std::vector<std::string> names(table.frames.size());
  for (const auto& [link, frame] : links) names[frame] = link;
  return names;
}

UrdfModel load_urdf_model(const std::filesystem::path& file, const GivenLimits& given,
                          const AssumedLimits& assumed) {
  UrdfModel model;
  model.file = file;
  const files::XmlText text = read_urdf_text(file);
  model.tree = urdf_tree(text);
  const char* name = text.root().Attribute("name");
  model.name = name && *name ? name : file.stem().string();
  for (const XmlElement* link : files::children(text.root(), "link")) read_link(*link, model);

  Assembly assembly;
  FileScope scope;
  const std::filesystem::path label = file.parent_path() / "of the URDF";
  const config::ConfigNode node =
      config::ConfigNode::parse(urdf_key_text(model, given, assumed), label.string());
  read_urdf(assembly, scope, node["urdf"]);
  assembly.problems.throw_if_any();
  for (UrdfJoint& joint : model.tree.joints) joint.element = nullptr;  // the text is destroyed here
  fix_joints(assembly);  // those that the file locks, as long as there are no tips
  set_limits(assembly);
  model.table = std::move(assembly.table);
  model.table.capsules.clear();
  model.links = std::move(assembly.links);
  model.notes = std::move(assembly.notes);
  return model;
}

}  // namespace morphe::robot
