#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/motion/key_bounds.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::simulate {

/// The known parameters of a joint's servo (servos.hpp); absent ones keep their defaults.
struct ServoGains {
  std::optional<double> stiffness, velocity_gain;  ///< [N m/rad, N m s/rad], or [N/m, N s/m]
  std::optional<double> armature, damping;         ///< [kg m^2, N m s/rad], or [kg, N s/m]
  std::optional<double> torque_limit;              ///< [N m] or [N]
};
template <class Fields>
void fields(Fields& f, ServoGains& o) {
  f("stiffness", o.stiffness, bounds::kStiffness);
  f("velocity_gain", o.velocity_gain, bounds::kGain);
  f("armature", o.armature, bounds::kGain);
  f("damping", o.damping, bounds::kGain);
  f("torque_limit", o.torque_limit, bounds::kTorque);
}

using ServoTable = std::map<std::string, ServoGains>;  ///< by joint name

/// Reads a YAML file with a map for each joint. Throws InputError for unknown joints or keys and
/// for invalid values.
ServoTable read_servos(const std::filesystem::path& file, const RobotModel& robot);

/// Returns the table as text, "joint stiffness 12 …", one line per joint.
std::string text_of(const ServoTable& table);

}  // namespace morphe::simulate
