#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/robot/files/mjcf_file.hpp"

namespace morphe::robot {

/// The settings of an MJCF's `compiler` elements; of several, the last that gives a setting holds.
struct MjcfSettings {
  double rad_per_angle = kRadPerDegree;  ///< MuJoCo's angles are degrees by default
  bool angle_stated = false;
  bool limits_by_range = true;      ///< `autolimits`: a range makes a joint limited
  std::string euler_order = "xyz";  ///< upper case: about fixed axes
  std::filesystem::path mesh_folder;
  bool strip_path = false;  ///< of the names of meshes, only the file's name holds
};

/// A default class: the settings of its elements, and the class from which it inherits the others.
struct MjcfClass {
  std::string parent;  ///< "" for the root class
  std::vector<const files::XmlElement*> elements;
};

inline constexpr const char* kRootClass = "main";

/// All that is needed to read the elements of an MJCF.
struct MjcfSource {
  MjcfFile file;
  MjcfSettings settings;
  std::map<std::string, MjcfClass> classes;
};

/// Reads the file with its settings and default classes. Throws InputError if they are invalid.
MjcfSource read_mjcf_source(const std::filesystem::path& file);

/// An element of an MJCF, whose attributes are its own or else those of its default class: the one
/// that it names, otherwise `scope`, the `childclass` of the nearest body above.
struct MjcfElement {
  const MjcfSource& source;
  const files::XmlElement& xml;
  std::string scope = kRootClass;

  /// Returns an attribute, or nullptr if neither the element nor its class has it.
  const char* text(const char* name) const;
  std::string text_or(const char* name, const char* otherwise) const;
  /// Returns the name of the element, "" if it has no name.
  std::string name() const { return own("name"); }
  /// Returns an attribute of the element itself, "" if it is missing.
  std::string own(const char* name) const;
  /// Returns `min` to `max` numbers of an attribute, empty if it is missing.
  std::vector<double> numbers(const char* name, std::size_t min, std::size_t max) const;
  double number(const char* name, double otherwise) const;
  Vec3 vector(const char* name, const Vec3& otherwise) const;
  /// Returns the value of a yes-or-no attribute, nothing if it is missing or "auto".
  std::optional<bool> truth(const char* name) const;
  /// Returns the pose by `pos` and one of quat, axisangle, xyaxes, zaxis and euler.
  Pose pose() const;
  /// Returns the scope of the elements within this one.
  std::string inner_scope() const;
  /// Throws InputError with file, line and "TAG NAME.ATTRIBUTE".
  [[noreturn]] void fail(const std::string& attribute, const std::string& message) const;

 private:
  std::string existing_class(const char* attribute) const;
};

/// Returns the rotation with the smallest angle that turns z into this direction: about x if it is
/// -z. MuJoCo has the same rule.
Quat rotation_from_z_to(const Vec3& direction);

}  // namespace morphe::robot
