#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/motion/robot_table.hpp"

namespace morphe::simulate {

/// What a laboratory knows of a joint's servo (servos.hpp); what it does not say stays as it is.
struct ServoGains {
  std::optional<double> stiffness, resistance;  ///< [N m/rad, N m s/rad], or [N/m, N s/m]
  std::optional<double> armature, damping;      ///< [kg m^2, N m s/rad], or [kg, N s/m]
  std::optional<double> torque;                 ///< limit [N m] or [N]
};
template <class Fields>
void fields(Fields& f, ServoGains& o) {
  f("stiffness", o.stiffness);
  f("resistance", o.resistance);
  f("armature", o.armature);
  f("damping", o.damping);
  f("torque", o.torque);
}
std::string why_invalid(const ServoGains& gains);

using ServoTable = std::map<std::string, ServoGains>;  ///< by the joint's name

/// A YAML file: joint: {stiffness: …, resistance: …, armature: …, damping: …, torque: …}, all of
/// them optional. InputError: no such joint, no such key, a value that cannot be.
ServoTable read_servos(const std::filesystem::path& file, const RobotTable& robot);

/// "joint stiffness 12 …", a line a joint.
std::string text_of(const ServoTable& table);

}  // namespace morphe::simulate
