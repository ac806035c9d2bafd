#include "stages/simulate/options.hpp"

#include <fmt/format.h>

#include <cmath>

namespace morphe::simulate {

std::string validation_error(const SimulateOptions& o) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (o.rollouts < 1 || o.rollouts > 10000) return "rollouts must be 1 to 10000";
  if (!positive(o.friction)) return "friction must be above 0";
  if (!(std::isfinite(o.torsional_friction_m) && o.torsional_friction_m >= 0))
    return "torsional-friction must not be negative";
  if (!positive(o.mass_kg)) return "mass must be above 0";
  const auto is_invalid = [&](const std::optional<Range>& r) {
    return r && !(positive(r->from) && std::isfinite(r->to) && r->from <= r->to);
  };
  if (is_invalid(o.friction_range))
    return "friction-range must be two numbers above 0, the smaller first";
  if (is_invalid(o.mass_range)) return "mass-range must be two numbers above 0, the smaller first";
  if (!positive(o.force_N)) return "thumb-force must be above 0";
  if (!(o.step_s >= 1e-5 && o.step_s <= 0.01)) return "time-step must be 0.00001 to 0.01 s";
  if (!positive(o.density)) return "density must be above 0";
  if (!positive(o.hand_stiffness)) return "hand-stiffness must be above 0";
  if (!positive(o.hand_torque_limit)) return "hand-torque-limit must be above 0";
  return "";
}

std::string text_of(const SimulateOptions& options) {
  std::string text;
  const auto add = [&](const char* key, const auto& value) {
    text += fmt::format("{} {}\n", key, value);
  };
  fields(add, options);
  return text;
}

std::vector<std::string> assumptions(const SimulateOptions& o) {
  return {
      fmt::format("links are solid, with the volume of their capsules and {:g} kg/m^3; the "
                  "target is solid, with {:g} kg",
                  o.density, o.mass_kg),
      fmt::format("the motors compensate gravity and the robot's own dynamics, not the target's; "
                  "each arm joint "
                  "has the servo of the PA10 joint at the same position in the arm, finger "
                  "joints have {:g} N m/rad and at most {:g} N m{}",
                  o.hand_stiffness, o.hand_torque_limit,
                  o.servos.empty() ? "" : ", unless the file of servos gives other values"),
      fmt::format("the hand squeezes as planned; if the plan has no squeeze, the thumb presses "
                  "with {:g} N where its tip touches the target, and the other fingers with "
                  "goals press with shares of it",
                  o.force_N),
      "the target rests on a plane through its lowest point; one that is carried, on the object "
      "below it",
      "a plan that carries its target is executed to its end, and the squeeze is added to its "
      "motion until the release; its clock stops while the hand squeezes and lets go"};
}

}  // namespace morphe::simulate
