#include "stages/simulate/options.hpp"

#include <fmt/format.h>

#include <cmath>

namespace morphe::simulate {

std::string why_invalid(const SimulateOptions& o) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (o.ensemble < 1 || o.ensemble > 10000) return "ensemble must be 1 to 10000";
  if (!positive(o.friction)) return "friction must be above 0";
  if (!(std::isfinite(o.torsion_m) && o.torsion_m >= 0)) return "torsion must not be negative";
  if (!positive(o.mass_kg)) return "mass must be above 0";
  if (!positive(o.force_N)) return "force must be above 0";
  if (!(o.step_s >= 1e-5 && o.step_s <= 0.01)) return "step must be 0.00001 to 0.01 s";
  if (!positive(o.density)) return "density must be above 0";
  if (!positive(o.hand_stiffness)) return "stiffness must be above 0";
  if (!positive(o.hand_torque)) return "torque must be above 0";
  return "";
}

std::string text_of(const SimulateOptions& o) {
  return fmt::format(
      "ensemble {} directions {} friction {} torsion {} mass {} force {} step {} {} density {} "
      "stiffness {} torque {} seed {}",
      o.ensemble, name_of(o.directions), o.friction, o.torsion_m, o.mass_kg, o.force_N, o.step_s,
      o.euler ? "euler" : "implicit", o.density, o.hand_stiffness, o.hand_torque, o.seed);
}

}  // namespace morphe::simulate
