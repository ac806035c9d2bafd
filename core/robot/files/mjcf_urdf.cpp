#include "core/robot/files/mjcf_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/files/markup.hpp"
#include "core/robot/files/urdf_text.hpp"

namespace morphe::robot {
namespace {

constexpr const char* kMark = "<!-- Converted from MJCF ";

struct MjcfUrdfWriter {
  const MjcfModel& model;
  const std::filesystem::path& folder;
  MjcfUrdf urdf = {};
  std::set<std::string> links = {}, joints = {};  ///< names in use
  std::map<std::string, const MjcfJoint*> joint_by_name = {};

  static std::string unused(std::string name, std::set<std::string>& taken) {
    const std::string stem = name;
    for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{}_{}", stem, k);
    return name;
  }

  void add_link(const std::string& name, const std::string& body) {
    urdf.text += body.empty() ? fmt::format("  <link name=\"{}\"/>\n", files::escape_xml(name))
                              : fmt::format("  <link name=\"{}\">\n{}  </link>\n",
                                            files::escape_xml(name), body);
  }

  void add_fixed_joint(const std::string& parent, const std::string& child, const Pose& pose) {
    add_joint(unused(child + "_fixed", joints), "fixed", parent, child, pose);
  }

  void add_joint(const std::string& name, const char* type, const std::string& parent,
                 const std::string& child, const Pose& pose, const std::string& more = "") {
    urdf.text += fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n"
        "    {}\n{}  </joint>\n",
        files::escape_xml(name), type, files::escape_xml(parent), files::escape_xml(child),
        urdf_origin(pose), more);
  }

  std::string mesh_path(const std::string& file) const {
    std::error_code ignored;
    const std::filesystem::path base = std::filesystem::absolute(folder, ignored);
    return std::filesystem::absolute(file, ignored)
        .lexically_normal()
        .lexically_proximate(base.lexically_normal())
        .generic_string();
  }

  std::string geometry(const UrdfShape& shape) const {
    switch (shape.kind) {
      case Shape::sphere:
        return fmt::format("<sphere radius=\"{}\"/>", shape.size.x());
      case Shape::box:
        return fmt::format("<box size=\"{}\"/>", urdf_numbers(shape.size));
      case Shape::mesh:
        return fmt::format("<mesh filename=\"{}\" scale=\"{}\"/>",
                           files::escape_xml(mesh_path(shape.mesh)), urdf_numbers(shape.size));
      case Shape::capsule:
      case Shape::cylinder:
        break;
    }
    return fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", shape.size.x(), shape.size.y());
  }

  std::string element(const char* tag, const std::string& name, const UrdfShape& shape) const {
    const std::string named =
        name.empty() ? "" : fmt::format(" name=\"{}\"", files::escape_xml(name));
    std::string text = fmt::format("    <{0}{1}>{2}<geometry>{3}</geometry></{0}>\n", tag, named,
                                   urdf_origin(shape.link_from_shape), geometry(shape));
    if (shape.kind != Shape::capsule) return text;
    for (const double end : {-0.5, 0.5}) {
      UrdfShape ball = shape;
      ball.kind = Shape::sphere;
      ball.link_from_shape =
          shape.link_from_shape * Eigen::Translation3d(0, 0, end * shape.size.y());
      text += element(tag, name.empty() ? "" : name + (end < 0 ? "_from" : "_to"), ball);
    }
    return text;
  }

  /// Writes the shapes of a body: colliding ones are also visual if the body has no other visuals.
  std::string shapes(const MjcfBody& body, const Pose& link_from_body) const {
    const bool has_visuals =
        std::ranges::any_of(body.geoms, [](const MjcfGeom& geom) { return !geom.collides; });
    std::string text;
    for (const MjcfGeom& geom : body.geoms) {
      UrdfShape shape = geom.shape;
      shape.link_from_shape = link_from_body * shape.link_from_shape;
      if (!geom.collides || (!has_visuals && geom.shown))
        text += element("visual", geom.name, shape);
      if (geom.collides) text += element("collision", geom.name, shape);
    }
    return text;
  }

  std::string inertial(const UrdfInertia& inertia, const Pose& link_from_body) const {
    const Eigen::Matrix3d& m = inertia.inertia;
    return fmt::format(
        "    <inertial>{}<mass value=\"{}\"/><inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" "
        "iyz=\"{}\" izz=\"{}\"/></inertial>\n",
        urdf_origin(link_from_body * inertia.link_from_inertia), inertia.mass, m(0, 0), m(0, 1),
        m(0, 2), m(1, 1), m(1, 2), m(2, 2));
  }

  /// Returns the position of a joint that couplings hold, no value if it moves.
  std::optional<double> held_position(const MjcfJoint& joint) const {
    double ratio = 1, position = 0;
    for (const MjcfJoint* next = &joint; next->coupling;
         next = joint_by_name.at(next->coupling->driver)) {
      position += ratio * next->coupling->offset;
      ratio *= next->coupling->ratio;
      if (next->coupling->driver.empty()) return position;
    }
    return std::nullopt;
  }

  std::string joint_details(const MjcfJoint& joint) const {
    std::string text = fmt::format("    <axis xyz=\"{}\"/>\n    <limit", urdf_numbers(joint.axis));
    if (joint.range)
      text += fmt::format(" lower=\"{}\" upper=\"{}\"", (*joint.range)[0], (*joint.range)[1]);
    text += fmt::format(" effort=\"{}\" velocity=\"0\"/>\n", joint.effort.value_or(0));
    if (joint.coupling) {
      const auto& [driver, ratio, offset] = *joint.coupling;
      text += fmt::format("    <mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
                          files::escape_xml(driver), ratio, offset);
    }
    return text;
  }

  /// Writes a joint from `parent` to `child`. `parent_from_body` is the pose of the body before the
  /// joint moves it; returns the pose of the body in the child.
  Pose add_body_joint(const MjcfJoint& joint, const std::string& parent, const std::string& child,
                      const Pose& parent_from_body) {
    const Vec3 anchor = joint.slides ? Vec3(Vec3::Zero()) : joint.anchor;
    const Pose origin = parent_from_body * Eigen::Translation3d(anchor);
    MjcfJoint about_origin = joint;
    about_origin.anchor.setZero();
    if (const std::optional<double> held = held_position(joint)) {
      add_joint(joint.name, "fixed", parent, child, origin * about_origin.motion(*held));
    } else {
      const char* type = joint.slides ? "prismatic" : joint.range ? "revolute" : "continuous";
      add_joint(joint.name, type, parent, child, origin * about_origin.motion(0),
                joint_details(joint));
    }
    return Pose(Eigen::Translation3d(-anchor));
  }

  void add_sites(const MjcfBody& body, const std::string& link, const Pose& link_from_body) {
    for (const MjcfSite& site : body.sites) {
      const std::string name = unused(site.name, links);
      add_link(name, "");
      add_fixed_joint(link, name, link_from_body * site.body_from_site);
    }
  }

  void add_body(const MjcfBody& body, const std::string& root) {
    const std::string parent = body.parent < 0 ? root : model.bodies[body.parent].name;
    Pose link_from_body = body.parent_from_body;
    if (body.parent >= 0) link_from_body = urdf.link_from_body.at(parent) * body.parent_from_body;
    std::string above = parent;
    for (std::size_t k = 0; k < body.joints.size(); ++k) {
      const bool last = k + 1 == body.joints.size();
      const std::string link =
          last ? body.name : unused(body.name + "_" + body.joints[k].name, links);
      if (!last) add_link(link, "");
      link_from_body = add_body_joint(body.joints[k], above, link, link_from_body);
      above = link;
    }
    if (body.name == root) {
      urdf.world_from_root = body.parent_from_body;
      link_from_body = Pose::Identity();
    } else if (body.joints.empty()) {
      add_fixed_joint(parent, body.name, link_from_body);
      link_from_body = Pose::Identity();
    }
    urdf.link_from_body.emplace(body.name, link_from_body);
    add_link(body.name, (body.inertia ? inertial(*body.inertia, link_from_body) : "") +
                            shapes(body, link_from_body));
    add_sites(body, body.name, link_from_body);
  }
};

/// Returns the name of the root link: see MjcfUrdf::world_from_root.
std::string root_link(const MjcfModel& model) {
  const auto below_world =
      std::ranges::count_if(model.bodies, [](const MjcfBody& body) { return body.parent < 0; });
  const MjcfBody& first = model.bodies.front();
  return below_world == 1 && first.joints.empty() ? first.name : std::string(kMjcfWorld);
}

}  // namespace

MjcfUrdf urdf_of(const MjcfModel& model, const std::filesystem::path& folder) {
  MjcfUrdfWriter writer{model, folder};
  for (const MjcfBody& body : model.bodies) {
    writer.links.insert(body.name);
    for (const MjcfJoint& joint : body.joints) {
      writer.joints.insert(joint.name);
      writer.joint_by_name.emplace(joint.name, &joint);
    }
  }
  const std::string root = root_link(model);
  std::string source = model.file.filename().string();
  if (source.find("--") != source.npos) source = "a file";  // "--" would end the comment
  writer.urdf.text = fmt::format(
      "<?xml version=\"1.0\"?>\n{}{} by `morphe robot setup`. MJCF states no velocity limits, so "
      "velocity=\"0\" means: not given. -->\n<robot name=\"{}\">\n",
      kMark, source, files::escape_xml(model.name));
  if (root == kMjcfWorld) writer.add_link(root, "");
  for (const MjcfBody& body : model.bodies) writer.add_body(body, root);
  writer.urdf.text += "</robot>\n";
  return std::move(writer.urdf);
}

bool is_converted_mjcf(const std::string& text) { return text.find(kMark) != text.npos; }

}  // namespace morphe::robot
