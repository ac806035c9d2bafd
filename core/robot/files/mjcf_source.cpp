#include "core/robot/files/mjcf_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {

using files::XmlElement;

namespace {

enum class AngleUnit { degree, radian };
constexpr std::array<std::string_view, 2> names_of(AngleUnit) { return {"degree", "radian"}; }

void add_class(const MjcfFile& file, const XmlElement& element, const std::string& parent,
               std::map<std::string, MjcfClass>& classes) {
  const char* written = element.Attribute("class");
  std::string name = written ? written : "";
  if (parent.empty()) {
    if (!name.empty() && name != kRootClass) classes[name].parent = kRootClass;
    name = kRootClass;
  } else if (name.empty()) {
    file.fail(element, "default.class", "is missing");
  } else if (!classes.emplace(name, MjcfClass{parent, {}}).second) {
    file.fail(element, "default.class", fmt::format("'{}' appears twice", name));
  }
  for (const XmlElement* child : file.elements(element)) {
    if (std::string_view(child->Value()) == "default")
      add_class(file, *child, name, classes);
    else
      classes.at(name).elements.push_back(child);
  }
}

void read_setting(const MjcfElement& compiler, MjcfSettings& settings) {
  if (compiler.text_or("coordinate", "local") != "local") {
    compiler.fail("coordinate",
                  "global coordinates are not supported; MuJoCo 2.3.2 or older converts them to "
                  "local ones: load the model and save it with mj_saveLastXML");
  }
  const std::string angle = compiler.own("angle");
  if (!angle.empty()) {
    const std::optional<AngleUnit> unit = enum_from_name<AngleUnit>(angle);
    if (!unit)
      compiler.fail("angle", fmt::format("must be {}, not '{}'", list_names<AngleUnit>(), angle));
    settings.rad_per_angle = *unit == AngleUnit::degree ? kRadPerDegree : 1;
    settings.angle_stated = true;
  }
  const std::string order = compiler.own("eulerseq");
  if (!order.empty()) {
    if (order.size() != 3 || order.find_first_not_of("xyzXYZ") != order.npos)
      compiler.fail("eulerseq",
                    fmt::format("must be three of the letters x, y, z, not '{}'", order));
    settings.euler_order = order;
  }
  settings.limits_by_range = compiler.truth("autolimits").value_or(settings.limits_by_range);
  settings.strip_path = compiler.truth("strippath").value_or(settings.strip_path);
}

void read_mesh_folder(const std::vector<const XmlElement*>& compilers, MjcfSettings& settings) {
  for (const char* name : {"assetdir", "meshdir"}) {  // the second one overrides the first
    for (const XmlElement* compiler : compilers)
      if (const char* folder = compiler->Attribute(name)) settings.mesh_folder = folder;
  }
}

/// Returns true if the default settings of one element hold for the other: all kinds of actuators
/// share theirs.
bool share_defaults(std::string_view one, std::string_view other) {
  static constexpr std::string_view kActuators[] = {"general",     "motor",  "position", "velocity",
                                                    "intvelocity", "damper", "cylinder", "muscle",
                                                    "adhesion",    "plugin"};
  const auto is_actuator = [](std::string_view tag) {
    return std::ranges::count(kActuators, tag) > 0;
  };
  return one == other || (is_actuator(one) && is_actuator(other));
}

const char* attribute_of_class(const MjcfSource& source, const std::string& start,
                               std::string_view tag, const char* name) {
  for (std::string next = start; !next.empty(); next = source.classes.at(next).parent) {
    const std::vector<const XmlElement*>& elements = source.classes.at(next).elements;
    for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
      if (!share_defaults((*element)->Value(), tag)) continue;
      if (const char* value = (*element)->Attribute(name)) return value;
    }
  }
  return nullptr;
}

constexpr std::pair<const char*, std::size_t> kOrientations[] = {
    {"quat", 4}, {"axisangle", 4}, {"xyaxes", 6}, {"zaxis", 3}, {"euler", 3}};

/// Returns the orientation that holds, index into kOrientations: the element's own one, otherwise
/// that of its class; -1 if there is no orientation.
int orientation_given(const MjcfElement& element) {
  int given = -1;
  for (int k = 0; k < std::ssize(kOrientations); ++k) {
    if (!element.xml.Attribute(kOrientations[k].first)) continue;
    if (given >= 0) {
      element.fail(kOrientations[k].first,
                   fmt::format("must not be given beside {}", kOrientations[given].first));
    }
    given = k;
  }
  for (int k = 0; given < 0 && k < std::ssize(kOrientations); ++k)
    if (element.text(kOrientations[k].first)) given = k;
  return given;
}

Vec3 unit_vector(const MjcfElement& element, const char* name, const Vec3& vector) {
  if (!(vector.norm() > 0)) element.fail(name, "must not be zero");
  return vector.normalized();
}

Quat rotation_from_euler(const std::string& order, const Vec3& angles_rad) {
  Quat rotation = Quat::Identity();
  for (int k = 0; k < 3; ++k) {
    const char letter = order[k];
    const bool fixed_axis = letter < 'a';
    const Quat turn(Eigen::AngleAxisd(angles_rad[k], Vec3::Unit((letter | 0x20) - 'x')));
    rotation = fixed_axis ? turn * rotation : rotation * turn;
  }
  return rotation;
}

Eigen::Matrix3d rotation_of(const MjcfElement& element) {
  const int given = orientation_given(element);
  if (given < 0) return Eigen::Matrix3d::Identity();
  const auto [name, count] = kOrientations[given];
  const std::vector<double> n = element.numbers(name, count, count);
  const double unit = element.source.settings.rad_per_angle;
  switch (given) {
    case 0: {
      const Quat quat(n[0], n[1], n[2], n[3]);
      if (!(quat.norm() > 0)) element.fail(name, "must not be zero");
      return quat.normalized().toRotationMatrix();
    }
    case 1:
      return Eigen::AngleAxisd(n[3] * unit, unit_vector(element, name, {n[0], n[1], n[2]}))
          .toRotationMatrix();
    case 2: {
      Eigen::Matrix3d axes;
      axes.col(0) = unit_vector(element, name, {n[0], n[1], n[2]});
      const Vec3 y(n[3], n[4], n[5]);
      axes.col(1) = unit_vector(element, name, y - y.dot(axes.col(0)) * axes.col(0));
      axes.col(2) = axes.col(0).cross(axes.col(1));
      return axes;
    }
    case 3:
      return rotation_from_z_to(unit_vector(element, name, {n[0], n[1], n[2]})).toRotationMatrix();
    default:
      return rotation_from_euler(element.source.settings.euler_order, unit * Vec3(n[0], n[1], n[2]))
          .toRotationMatrix();
  }
}

}  // namespace

MjcfSource read_mjcf_source(const std::filesystem::path& file) {
  MjcfSource source{MjcfFile(file), {}, {{kRootClass, {}}}};
  const std::vector<const XmlElement*> compilers = source.file.sections("compiler");
  for (const XmlElement* compiler : compilers) read_setting({source, *compiler}, source.settings);
  read_mesh_folder(compilers, source.settings);
  for (const XmlElement* defaults : source.file.sections("default"))
    add_class(source.file, *defaults, "", source.classes);
  return source;
}

std::string MjcfElement::own(const char* name) const {
  const char* value = xml.Attribute(name);
  return value ? value : "";
}

std::string MjcfElement::existing_class(const char* attribute) const {
  std::string name = own(attribute);
  if (!name.empty() && !source.classes.contains(name))
    fail(attribute, fmt::format("there is no default class '{}'", name));
  return name;
}

const char* MjcfElement::text(const char* name) const {
  if (const char* value = xml.Attribute(name)) return value;
  const std::string own_class = existing_class("class");
  return attribute_of_class(source, own_class.empty() ? scope : own_class, xml.Value(), name);
}

std::string MjcfElement::text_or(const char* name, const char* otherwise) const {
  const char* value = text(name);
  return value ? value : otherwise;
}

std::vector<double> MjcfElement::numbers(const char* name, std::size_t min, std::size_t max) const {
  const char* value = text(name);
  if (!value) return {};
  std::vector<double> found = numbers_of(value);
  if (found.size() < min || found.size() > max) {
    const std::string count = min == max ? fmt::to_string(min) : fmt::format("{} to {}", min, max);
    fail(name, fmt::format("must be {} number{}, not '{}'", count, max == 1 ? "" : "s", value));
  }
  return found;
}

double MjcfElement::number(const char* name, double otherwise) const {
  const std::vector<double> found = numbers(name, 1, 1);
  return found.empty() ? otherwise : found.front();
}

Vec3 MjcfElement::vector(const char* name, const Vec3& otherwise) const {
  const std::vector<double> found = numbers(name, 3, 3);
  return found.empty() ? otherwise : Vec3(found[0], found[1], found[2]);
}

std::optional<bool> MjcfElement::truth(const char* name) const {
  const std::string word = text_or(name, "auto");
  if (word == "auto") return std::nullopt;
  if (word != "true" && word != "false")
    fail(name, fmt::format("must be true or false, not '{}'", word));
  return word == "true";
}

Pose MjcfElement::pose() const {
  Pose pose = Pose::Identity();
  pose.translation() = vector("pos", Vec3::Zero());
  pose.linear() = rotation_of(*this);
  return pose;
}

std::string MjcfElement::inner_scope() const {
  const std::string inner = existing_class("childclass");
  return inner.empty() ? scope : inner;
}

void MjcfElement::fail(const std::string& attribute, const std::string& message) const {
  const std::string named =
      name().empty() ? xml.Value() : fmt::format("{} {}", xml.Value(), name());
  source.file.fail(xml, attribute.empty() ? named : fmt::format("{}.{}", named, attribute),
                   message);
}

Quat rotation_from_z_to(const Vec3& direction) {
  constexpr double kParallel = 1e-10;  ///< sine below which MuJoCo, too, takes x as the axis
  const Vec3 across = Vec3::UnitZ().cross(direction);
  const double sine = across.norm();
  const Vec3 axis = sine < kParallel ? Vec3(Vec3::UnitX()) : Vec3(across / sine);
  return Quat(Eigen::AngleAxisd(std::atan2(sine, direction.z()), axis));
}

}  // namespace morphe::robot
