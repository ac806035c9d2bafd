#include "pipeline/robot/files/urdf_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace morphe::robot {
namespace {

std::string key_of(const UrdfJoint& joint, const std::string& part) {
  return fmt::format("joint {}{}", joint.name, part);
}

/// The numbers of an attribute; empty if anything in it is none, or not finite.
std::vector<double> numbers(const std::string& text) {
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

/// urdfdom would say what is no number, but not where.
void check_numbers(const files::XmlText& urdf, const files::XmlElement& element,
                   const std::string& owner) {
  static constexpr std::array<const char*, 3> kVectors = {"xyz", "rpy", "size"};
  static constexpr std::array<const char*, 8> kScalars = {
      "radius", "length", "lower", "upper", "velocity", "effort", "multiplier", "offset"};
  const auto check = [&](const char* name, std::size_t count) {
    const char* text = element.Attribute(name);
    if (text && numbers(text).size() != count) {
      urdf.fail(element, fmt::format("{}.{}.{}", owner, element.Value(), name),
                count == 1 ? fmt::format("must be a number, not '{}'", text)
                           : fmt::format("must be {} numbers, not '{}'", count, text));
    }
  };
  for (const char* name : kVectors) check(name, 3);
  for (const char* name : kScalars) check(name, 1);
  for (const files::XmlElement* child = element.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    check_numbers(urdf, *child, owner);
  }
}

void check_turning(const files::XmlText& urdf, const UrdfJoint& joint, bool bounded) {
  if (const files::XmlElement* axis = joint.element->FirstChildElement("axis")) {
    const std::vector<double> xyz = numbers(urdf.attribute(*axis, "xyz"));
    if (std::ranges::all_of(xyz, [](double x) { return x == 0; })) {
      urdf.fail(*axis, key_of(joint, ".axis"), "must not be zero");
    }
  }
  const files::XmlElement* limit = joint.element->FirstChildElement("limit");
  if (!limit && bounded) urdf.fail(*joint.element, key_of(joint, ".limit"), "is missing");
  if (!limit) return;
  for (const char* name : {"velocity", "effort"}) {
    if (!limit->Attribute(name)) {
      urdf.fail(*limit, key_of(joint, fmt::format(".limit.{}", name)), "is missing");
    }
  }
  if (!bounded) return;
  const auto bound = [&](const char* name) {
    double value = 0;
    limit->QueryDoubleAttribute(name, &value);
    return value;
  };
  if (bound("lower") >= bound("upper")) {
    urdf.fail(*limit, key_of(joint, ".limit.upper"), "must be above lower");
  }
}

void check_type(const files::XmlText& urdf, const UrdfJoint& joint) {
  const std::string type = urdf.attribute(*joint.element, "type");
  if (type == "revolute" || type == "continuous") {
    check_turning(urdf, joint, type == "revolute");
  } else if (type != "fixed") {
    urdf.fail(*joint.element, key_of(joint, ".type"),
              fmt::format("must be revolute, continuous or fixed, not '{}'", type));
  }
}

std::map<std::string, const files::XmlElement*> named(const files::XmlText& urdf, const char* tag) {
  std::map<std::string, const files::XmlElement*> found;
  for (const files::XmlElement* element : files::children(urdf.root(), tag)) {
    const std::string name = urdf.attribute(*element, "name");
    if (!found.emplace(name, element).second) {
      urdf.fail(*element, fmt::format("{} {}", tag, name), "stands twice");
    }
    check_numbers(urdf, *element, fmt::format("{} {}", tag, name));
  }
  return found;
}

/// Parents first; whatever cannot be reached from the one root hangs in a loop.
std::vector<UrdfJoint> sorted(const files::XmlText& urdf, std::vector<UrdfJoint> joints,
                              const std::string& root) {
  std::vector<UrdfJoint> order;
  std::set<std::string> reached = {root};
  while (!joints.empty()) {
    const auto ready = std::ranges::find_if(
        joints, [&](const UrdfJoint& joint) { return reached.contains(joint.parent); });
    if (ready == joints.end()) {
      urdf.fail(*joints.front().element, key_of(joints.front(), ""), "is part of a loop");
    }
    reached.insert(ready->child);
    order.push_back(*ready);
    joints.erase(ready);
  }
  return order;
}

}  // namespace

std::vector<UrdfJoint> urdf_joints(const files::XmlText& urdf) {
  const std::map<std::string, const files::XmlElement*> links = named(urdf, "link");
  (void)named(urdf, "joint");
  std::vector<UrdfJoint> joints;
  std::map<std::string, std::string> joint_above;  // of a link
  for (const files::XmlElement* element : files::children(urdf.root(), "joint")) {
    UrdfJoint joint{urdf.attribute(*element, "name"), "", "", element};
    const auto link = [&](const char* end) {
      const files::XmlElement* node = element->FirstChildElement(end);
      if (!node) urdf.fail(*element, key_of(joint, "") + "." + end, "is missing");
      std::string name = urdf.attribute(*node, "link");
      if (!links.contains(name)) {
        urdf.fail(*node, key_of(joint, "") + "." + end, fmt::format("there is no link '{}'", name));
      }
      return name;
    };
    joint.parent = link("parent");
    joint.child = link("child");
    if (const auto [above, first] = joint_above.emplace(joint.child, joint.name); !first) {
      urdf.fail(*element, key_of(joint, ".child"),
                fmt::format("link '{}' hangs on joint '{}' already", joint.child, above->second));
    }
    check_type(urdf, joint);
    joints.push_back(std::move(joint));
  }
  if (joints.empty()) urdf.fail(urdf.root(), "robot", "has no joints");
  std::vector<std::string> roots;
  for (const files::XmlElement* link : files::children(urdf.root(), "link")) {
    const std::string name = link->Attribute("name");
    if (joint_above.contains(name)) continue;
    if (!roots.empty()) {
      urdf.fail(*link, "link " + name,
                fmt::format("hangs on nothing, as '{}' does: there can be one root", roots[0]));
    }
    roots.push_back(name);
  }
  return sorted(urdf, std::move(joints), roots.empty() ? "" : roots.front());
}

}  // namespace morphe::robot
