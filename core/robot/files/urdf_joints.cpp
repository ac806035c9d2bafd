#include "core/robot/files/urdf_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <queue>
#include <sstream>

#include "core/config/error_list.hpp"

namespace morphe::robot {
namespace {

std::string key_of(const UrdfJoint& joint, const std::string& part) {
  return fmt::format("joint {}{}", joint.name, part);
}

/// Checks the numbers of an element and its descendants. urdfdom would report invalid ones without
/// their line.
void check_numbers(const files::XmlText& urdf, const files::XmlElement& element,
                   const std::string& owner) {
  const auto check = [&](const char* name, std::size_t count) {
    const char* text = element.Attribute(name);
    if (text && numbers_of(text).size() != count) {
      urdf.fail(element, fmt::format("{}.{}.{}", owner, element.Value(), name),
                count == 1 ? fmt::format("must be a number, not '{}'", text)
                           : fmt::format("must be {} numbers, not '{}'", count, text));
    }
  };
  for (const char* name : {"xyz", "rpy", "size"}) check(name, 3);
  for (const char* name :
       {"radius", "length", "lower", "upper", "velocity", "effort", "multiplier", "offset"}) {
    check(name, 1);
  }
  for (const auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
    check_numbers(urdf, *child, owner);
}

/// Returns a number that check_numbers() has accepted.
std::optional<double> number(const files::XmlElement* element, const char* name) {
  const char* text = element ? element->Attribute(name) : nullptr;
  return text ? std::optional(numbers_of(text).front()) : std::nullopt;
}

void read_limits(const files::XmlText& urdf, UrdfJoint& joint, UrdfTree& tree) {
  if (const files::XmlElement* axis = joint.element->FirstChildElement("axis")) {
    const std::vector<double> xyz = numbers_of(urdf.attribute(*axis, "xyz"));
    if (std::ranges::all_of(xyz, [](double x) { return x == 0; }))
      urdf.fail(*axis, key_of(joint, ".axis"), "must not be zero");
  }
  const files::XmlElement* limit = joint.element->FirstChildElement("limit");
  if (!limit) return;
  joint.velocity = number(limit, "velocity");
  if (joint.velocity && !(*joint.velocity > 0)) joint.velocity.reset();
  if (joint.kind == JointKind::continuous) return;
  const std::optional<double> lower = number(limit, "lower"), upper = number(limit, "upper");
  if (!lower && !upper) return;
  const double least = lower.value_or(0), most = upper.value_or(0);
  if (least > most) urdf.fail(*limit, key_of(joint, ".limit.upper"), "must be above lower");
  if (least == most && joint.element->FirstChildElement("mimic")) return;
  if (joint.kind == JointKind::revolute && least <= -kEndless_rad && most >= kEndless_rad) {
    joint.kind = JointKind::continuous;
    tree.notes.push_back(
        fmt::format("{}:{}: joint {}: {:g} to {:g} rad are no limits; it counts as continuous",
                    urdf.file.string(), joint.element->GetLineNum(), joint.name, least, most));
    return;
  }
  joint.lower = least;
  joint.upper = most;
}

void read_kind(const files::XmlText& urdf, UrdfJoint& joint, UrdfTree& tree) {
  const std::string type = urdf.attribute(*joint.element, "type");
  if (type == "revolute") joint.kind = JointKind::revolute;
  if (type == "continuous") joint.kind = JointKind::continuous;
  if (type == "prismatic") joint.kind = JointKind::prismatic;
  if (joint.kind != JointKind::fixed) return read_limits(urdf, joint, tree);
  if (type == "planar" || type == "floating") {
    tree.notes.push_back(fmt::format("{}:{}: joint {} is {}; assumed fixed", urdf.file.string(),
                                     joint.element->GetLineNum(), joint.name, type));
  } else if (type != "fixed") {
    urdf.fail(*joint.element, key_of(joint, ".type"),
              fmt::format("must be revolute, continuous, prismatic or fixed, not '{}'", type));
  }
}

std::map<std::string, const files::XmlElement*> elements_by_name(const files::XmlText& urdf,
                                                                 const char* tag,
                                                                 config::ErrorList& problems) {
  std::map<std::string, const files::XmlElement*> found;
  for (const files::XmlElement* element : files::children(urdf.root(), tag)) {
    problems.attempt([&] {
      const std::string name = urdf.attribute(*element, "name");
      if (!found.emplace(name, element).second)
        urdf.fail(*element, fmt::format("{} {}", tag, name), "appears twice");
      check_numbers(urdf, *element, fmt::format("{} {}", tag, name));
    });
  }
  return found;
}

UrdfJoint read_joint(const files::XmlText& urdf, const files::XmlElement& element,
                     const std::map<std::string, const files::XmlElement*>& links,
                     std::map<std::string, std::string>& joint_above, UrdfTree& tree) {
  UrdfJoint joint;
  joint.name = urdf.attribute(element, "name");
  joint.element = &element;
  const auto link = [&](const char* end) {
    const files::XmlElement* node = element.FirstChildElement(end);
    if (!node) urdf.fail(element, key_of(joint, "") + "." + end, "is missing");
    std::string name = urdf.attribute(*node, "link");
    if (!links.contains(name))
      urdf.fail(*node, key_of(joint, "") + "." + end, fmt::format("there is no link '{}'", name));
    return name;
  };
  joint.parent = link("parent");
  joint.child = link("child");
  if (const auto [above, first] = joint_above.emplace(joint.child, joint.name); !first) {
    urdf.fail(
        element, key_of(joint, ".child"),
        fmt::format("link '{}' is already the child of joint '{}'", joint.child, above->second));
  }
  read_kind(urdf, joint, tree);
  return joint;
}

/// Sorts parents before their children, otherwise in the file's order. Joints that do not descend
/// from the root are part of a loop or below one, which is an error.
std::vector<UrdfJoint> parents_first(const files::XmlText& urdf, std::vector<UrdfJoint> joints,
                                     const std::string& root) {
  std::multimap<std::string, int> below;
  for (int i = 0; i < std::ssize(joints); ++i) below.emplace(joints[i].parent, i);
  std::priority_queue<int, std::vector<int>, std::greater<>> ready;
  const auto add_joints_below = [&](const std::string& link) {
    for (auto [joint, end] = below.equal_range(link); joint != end; ++joint)
      ready.push(joint->second);
    below.erase(link);
  };
  std::vector<UrdfJoint> order;
  for (add_joints_below(root); !ready.empty();) {
    const int next = ready.top();
    ready.pop();
    order.push_back(joints[next]);
    add_joints_below(joints[next].child);
  }
  if (below.empty()) return order;
  const auto first =
      std::ranges::min_element(below, {}, [](const auto& entry) { return entry.second; });
  const UrdfJoint& joint = joints[first->second];
  urdf.fail(*joint.element, key_of(joint, ""), "is part of a closed loop of joints");
}

/// Returns the command that expands a xacro file: ARM.xacro and ARM.urdf.xacro become ARM.urdf.
std::string xacro_command(const std::filesystem::path& file) {
  const std::filesystem::path stem = file.stem();
  const std::string name = stem.extension() == ".urdf" ? stem.stem().string() : stem.string();
  const bool same = file.extension() == ".urdf";  // which must not be overwritten
  return fmt::format("xacro {} > {}{}.urdf", file.string(), name, same ? "_expanded" : "");
}

void refuse_xacro(const files::XmlText& urdf) {
  const auto is_xacro = [](const files::XmlElement& element) {
    if (std::string_view(element.Value()).starts_with("xacro:")) return true;
    for (const auto* a = element.FirstAttribute(); a; a = a->Next()) {
      const std::string_view name = a->Name(), value = a->Value();
      if (name.starts_with("xmlns:xacro") && element.FirstChildElement("link")) continue;
      if (value.find("${") != std::string_view::npos) return true;
    }
    return false;
  };
  const auto search = [&](const auto& self, const files::XmlElement& element) -> void {
    if (is_xacro(element)) {
      urdf.fail(element, element.Value(),
                fmt::format("is a xacro file; convert it first: `{}`", xacro_command(urdf.file)));
    }
    for (const auto* child = element.FirstChildElement(); child;
         child = child->NextSiblingElement()) {
      self(self, *child);
    }
  };
  search(search, urdf.root());
}

std::string find_root_link(const files::XmlText& urdf,
                           const std::map<std::string, std::string>& joint_above) {
  std::string root;
  for (const files::XmlElement* link : files::children(urdf.root(), "link")) {
    const std::string name = link->Attribute("name");
    if (joint_above.contains(name)) continue;
    if (!root.empty()) {
      urdf.fail(*link, "link " + name,
                fmt::format("is a second root besides '{}'; a URDF must have one root link", root));
    }
    root = name;
  }
  return root;
}

}  // namespace

const UrdfJoint* find_joint(const UrdfTree& tree, const std::string& name) {
  const auto found = std::ranges::find(tree.joints, name, &UrdfJoint::name);
  return found == tree.joints.end() ? nullptr : &*found;
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> values;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    double value = 0;
    if (word.starts_with('+')) word.erase(0, 1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      return {};
    values.push_back(value);
  }
  return values;
}

UrdfTree urdf_tree(const files::XmlText& urdf) {
  refuse_xacro(urdf);
  const std::size_t count = files::children(urdf.root(), "link").size();
  if (count > kMaxLinkCount) {
    urdf.fail(urdf.root(), "robot",
              fmt::format("has {} links; at most {} are allowed", count, kMaxLinkCount));
  }
  config::ErrorList problems;
  const auto links = elements_by_name(urdf, "link", problems);
  (void)elements_by_name(urdf, "joint", problems);
  problems.throw_if_any();
  UrdfTree tree;
  std::vector<UrdfJoint> joints;
  std::map<std::string, std::string> joint_above;  // by link
  for (const files::XmlElement* element : files::children(urdf.root(), "joint")) {
    problems.attempt(
        [&] { joints.push_back(read_joint(urdf, *element, links, joint_above, tree)); });
  }
  problems.throw_if_any();
  if (joints.empty()) urdf.fail(urdf.root(), "robot", "has no joints");
  tree.root = find_root_link(urdf, joint_above);
  tree.joints = parents_first(urdf, std::move(joints), tree.root);
  return tree;
}

}  // namespace morphe::robot
