#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <string_view>

#include "core/config/error_list.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/enum_names.hpp"
#include "core/robot/files/mjcf_model.hpp"
#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

using files::XmlElement;

enum class MjcfJointType { free, ball, slide, hinge };
constexpr std::array<std::string_view, 4> names_of(MjcfJointType) {
  return {"free", "ball", "slide", "hinge"};
}

/// The elements of a body from which its robot follows.
enum class BodyElement { body, frame, joint, freejoint, geom, site, inertial };
constexpr std::array<std::string_view, 7> names_of(BodyElement) {
  return {"body", "frame", "joint", "freejoint", "geom", "site", "inertial"};
}

/// Elements that add bodies or joints that only MuJoCo can make.
constexpr std::string_view kGenerators[] = {"replicate", "attach", "composite", "flexcomp"};

struct BodyReader {
  const MjcfSource& source;
  MjcfModel model = {};
  std::map<std::string, MjcfMesh> meshes = {};
  config::ErrorList problems = {};
  std::set<std::string> body_names = {"world"}, joint_names = {};
  std::size_t world_shapes = 0, joint_count = 0;
  bool angles_look_like_radians = true;  ///< no range is above a turn, in the file's unit
  std::string angle_example = {};        ///< a joint with its range, "" without limited hinges

  std::string unused_name(const MjcfElement& element, std::string name, const std::string& derived,
                          std::set<std::string>& taken) const {
    if (name.empty()) {
      name = derived;
      for (int k = 2; taken.contains(name); ++k) name = fmt::format("{}_{}", derived, k);
    }
    if (!taken.insert(name).second) element.fail("name", "appears twice");
    return name;
  }

  /// Reads the elements of a body (-1 = world) or of a `frame` in it.
  void read_elements(const MjcfElement& owner, int body, const Pose& body_from_frame) {
    const std::string scope = owner.inner_scope();
    for (const XmlElement* child : source.file.elements(owner.xml)) {
      problems.attempt([&] { read_element({source, *child, scope}, body, body_from_frame); });
    }
  }

  void read_element(const MjcfElement& element, int body, const Pose& body_from_frame) {
    if (std::ranges::count(kGenerators, std::string_view(element.xml.Value())) > 0) {
      element.fail("",
                   "is not supported; load the model with MuJoCo and save it with mj_saveLastXML, "
                   "which writes what this element makes");
    }
    const auto tag = enum_from_name<BodyElement>(element.xml.Value());
    if (!tag) return;  // lights, cameras, plugins
    if (*tag == BodyElement::body) return read_body(element, body, body_from_frame);
    if (*tag == BodyElement::frame)
      return read_elements(element, body, body_from_frame * element.pose());
    if (body >= 0) return read_part(element, *tag, body, body_from_frame);
    world_shapes += *tag == BodyElement::geom && element.text_or("type", "sphere") != "plane";
  }

  /// Reads a part of a body that is not a body itself.
  void read_part(const MjcfElement& element, BodyElement tag, int body,
                 const Pose& body_from_frame) {
    switch (tag) {
      case BodyElement::joint:
      case BodyElement::freejoint:
        return read_joint(element, body, body_from_frame);
      case BodyElement::geom:
        return read_geom(element, body, body_from_frame);
      case BodyElement::site:
        if (!element.name().empty())
          model.bodies[body].sites.push_back({element.name(), body_from_frame * element.pose()});
        return;
      case BodyElement::inertial:
        model.bodies[body].inertia = read_mjcf_inertial(element);
        model.bodies[body].inertia->link_from_inertia =
            body_from_frame * model.bodies[body].inertia->link_from_inertia;
        return;
      case BodyElement::body:
      case BodyElement::frame:
        return;
    }
  }

  void read_geom(const MjcfElement& element, int body, const Pose& body_from_frame) {
    std::optional<MjcfGeom> geom = read_mjcf_geom(element, meshes, model.notes);
    if (!geom) return;
    geom->shape.link_from_shape = body_from_frame * geom->shape.link_from_shape;
    model.bodies[body].geoms.push_back(std::move(*geom));
  }

  void read_body(const MjcfElement& element, int parent, const Pose& parent_from_frame) {
    if (model.bodies.size() >= kMaxLinkCount)
      element.fail("", fmt::format("at most {} bodies are allowed", kMaxLinkCount));
    MjcfBody body;
    const std::string above = parent < 0 ? "world" : model.bodies[parent].name;
    body.name = unused_name(element, element.name(), above + "_body", body_names);
    body.parent = parent;
    body.parent_from_body = parent_from_frame * element.pose();
    model.bodies.push_back(std::move(body));
    read_elements(element, static_cast<int>(model.bodies.size()) - 1, Pose::Identity());
  }

  void read_joint(const MjcfElement& element, int body, const Pose& body_from_frame) {
    const bool is_free = std::string_view(element.xml.Value()) == "freejoint";
    const std::string word = is_free ? "free" : element.text_or("type", "hinge");
    const std::optional<MjcfJointType> type = enum_from_name<MjcfJointType>(word);
    if (!type)
      element.fail("type", fmt::format("must be {}, not '{}'", list_names<MjcfJointType>(), word));
    MjcfBody& owner = model.bodies[body];
    const std::string name =
        unused_name(element, element.name(), owner.name + "_joint", joint_names);
    if (*type == MjcfJointType::free || *type == MjcfJointType::ball) {
      model.notes.push_back(fmt::format("{}: {} is a {} joint, which is not supported; it is fixed",
                                        source.file.place(element.xml), name, word));
      return;
    }
    MjcfJoint joint = read_mjcf_joint(element, model.notes);
    joint.name = name;
    joint.anchor = body_from_frame * joint.anchor;
    joint.axis = body_from_frame.linear() * joint.axis;
    if (++joint_count > kMaxLinkCount)
      element.fail("", fmt::format("at most {} joints are allowed", kMaxLinkCount));
    if (!joint.slides && joint.range) judge_unit(joint);
    owner.joints.push_back(std::move(joint));
  }

  /// Collects the evidence for angles that are radians in a file that does not state their unit.
  void judge_unit(const MjcfJoint& joint) {
    const auto [lower, upper] = *joint.range;
    const double unit = source.settings.rad_per_angle;
    angles_look_like_radians &=
        std::max(std::abs(lower), std::abs(upper)) / unit <= 2 * std::numbers::pi;
    if (!angle_example.empty()) return;
    angle_example = fmt::format("joint {} turns from {:.4g} to {:.4g} deg", joint.name,
                                lower / unit, upper / unit);
  }

  void note_unit() {
    if (source.settings.angle_stated || angle_example.empty() || !angles_look_like_radians) return;
    model.to_check.push_back(fmt::format(
        "angles are in degrees, MuJoCo's default ({}); if they are radians, add <compiler "
        "angle=\"radian\"/> to {}",
        angle_example, source.file.path().string()));
  }

  /// Removes the bodies that neither have nor carry a hinge or slide, nor are carried by one whose
  /// ancestors do: tables, objects and other surroundings.
  void remove_surroundings() {
    const std::size_t count = model.bodies.size();
    std::vector<char> moves(count, 0);
    std::vector<std::string> removed;
    for (std::size_t k = count; k-- > 0;) {
      const MjcfBody& body = model.bodies[k];
      moves[k] |= !body.joints.empty();
      if (body.parent >= 0) moves[body.parent] |= moves[k];
    }
    std::vector<int> new_index(count, -1);
    std::vector<MjcfBody> kept;
    for (std::size_t k = 0; k < count; ++k) {
      MjcfBody& body = model.bodies[k];
      const bool keep = body.parent < 0 ? moves[k] != 0 : new_index[body.parent] >= 0;
      if (!keep && body.parent < 0) removed.push_back(body.name);
      if (!keep) continue;
      if (body.parent >= 0) body.parent = new_index[body.parent];
      new_index[k] = static_cast<int>(kept.size());
      kept.push_back(std::move(body));
    }
    model.bodies = std::move(kept);
    if (!removed.empty()) {
      model.notes.push_back(
          fmt::format("{}: surroundings are left out (bodies without a joint): {}",
                      source.file.path().string(), fmt::join(removed, ", ")));
    }
    if (world_shapes > 0) {
      model.notes.push_back(fmt::format(
          "{}: surroundings are left out: {} of the world itself; a shape of the robot's base must "
          "be in a body that carries the robot",
          source.file.path().string(), count_with_noun(world_shapes, "shape")));
    }
  }
};

}  // namespace

const MjcfJoint* find_joint(const MjcfModel& model, const std::string& name) {
  for (const MjcfBody& body : model.bodies)
    for (const MjcfJoint& joint : body.joints)
      if (joint.name == name) return &joint;
  return nullptr;
}

MjcfModel read_mjcf(const std::filesystem::path& file) {
  const MjcfSource source = read_mjcf_source(file);
  BodyReader reader{source};
  reader.meshes = read_mjcf_meshes(source);
  for (const XmlElement* world : source.file.sections("worldbody"))
    reader.read_elements({source, *world}, -1, Pose::Identity());
  reader.problems.throw_if_any();
  MjcfModel& model = reader.model;
  model.file = file;
  const char* name = source.file.root().Attribute("model");
  model.name = name && *name ? name : file.stem().string();
  reader.remove_surroundings();
  if (model.bodies.empty())
    source.file.fail(source.file.root(), "worldbody", "has no body with a hinge or slide");
  reader.note_unit();
  read_mjcf_equalities(source, model);
  read_mjcf_actuators(source, model);
  return std::move(model);
}

}  // namespace morphe::robot
