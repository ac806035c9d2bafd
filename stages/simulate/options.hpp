#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/named.hpp"
#include "stages/simulate/servo_file.hpp"

namespace morphe::simulate {

/// Which rollouts are loaded in six directions, too: none, the first one (of which nothing is
/// varied), every one.
enum class Directions { none, first, every };
constexpr std::array<std::string_view, 3> names_of(Directions) {
  return {"none", "first", "every"};
}

/// Whose squeeze the hand makes: the plan's, or one of the fingers with goals where they are
/// nearest to the target (also of a plan that has none).
enum class Contacts { stored, nearest };
constexpr std::array<std::string_view, 2> names_of(Contacts) { return {"stored", "nearest"}; }

/// From and to, both included.
struct Range {
  double from = 0, to = 0;
};

/// What nobody can read off a plan, and what a lab would change.
struct SimulateOptions {
  int ensemble = 16;  ///< rollouts a plan; of the first one nothing is varied
  Directions directions = Directions::first;
  double friction = 0.8;
  /// Torsional friction, a length: that of a pad whose contact has a radius of 4 mm [m].
  double torsion_m = 0.002;
  double mass_kg = 0.3;  ///< of the target
  /// Of all rollouts but the first: spread evenly in their logarithm over a range. None: both are
  /// within kFactor of what they are in the first.
  std::optional<Range> friction_range, mass_range;
  Contacts contacts = Contacts::stored;
  double force_N = 8;     ///< the thumb's squeeze, the others share as much; of nearest contacts
  double step_s = 0.002;  ///< of the simulation
  bool euler = false;     ///< semi-implicit Euler in place of the implicit integrator
  double density = 1000;  ///< of the robot's capsules [kg/m^3]
  /// Of finger joints that turn. Not published for most hands: 1 N m gives 10 N at 0.1 m.
  double hand_stiffness = 10;  ///< [N m/rad]
  double hand_torque = 1;      ///< [N m]
  ServoTable servos;           ///< of single joints, in place of all these
  std::uint64_t seed = 1;
};
template <class Fields>
void fields(Fields& f, const SimulateOptions& o) {
  f("ensemble", o.ensemble);
  f("directions", name_of(o.directions));
  f("friction", o.friction);
  f("torsion_m", o.torsion_m);
  f("mass_kg", o.mass_kg);
  const auto text = [](const std::optional<Range>& range) {
    return range ? fmt::format("{} to {}", range->from, range->to) : std::string();
  };
  f("friction_range", text(o.friction_range));
  f("mass_range", text(o.mass_range));
  f("contacts", name_of(o.contacts));
  f("force_N", o.force_N);
  f("step_s", o.step_s);
  f("integrator", o.euler ? "euler" : "implicit");
  f("density", o.density);
  f("hand_stiffness", o.hand_stiffness);
  f("hand_torque", o.hand_torque);
  f("servos", text_of(o.servos));
  f("seed", o.seed);
}
/// "", or a sentence.
std::string why_invalid(const SimulateOptions& options);
/// All of them, a line each.
std::string text_of(const SimulateOptions& options);
/// What is taken for true of every plan, a sentence each.
std::vector<std::string> assumptions(const SimulateOptions& options);

// What the engine is told of every contact [DexGraspBench's, softness 0.1 mm at 30 N].
inline constexpr const char* kContactSolref = "0.005 1";
inline constexpr const char* kContactSolimp = "0.5 0.99 0.0001";
// Torsion and rolling with elliptic cones: with pyramids a block is dropped that Coulomb holds.
inline constexpr int kImpratio = 10, kNoslipIterations = 5;
inline constexpr double kRolling_m = 0.001;
/// Of the target on what it stands on: it neither helps nor hinders what is tested.
inline constexpr double kSupportFriction = 0.5;
// What lifts a hand without an arm [N/m, N s/m]: it gives way by 0.1 mm under 2 kg.
inline constexpr double kBaseStiffness = 2e5, kBaseResistance = 2e3;
// Couplings are as stiff as the step bears.
inline constexpr const char* kCouplingSolref = "0.004 1";
inline constexpr const char* kCouplingSolimp = "0.95 0.99 0.001";

// The protocol.
inline constexpr double kClose_s = 0.5, kSqueeze_s = 0.5, kSettle_s = 0.3;
inline constexpr double kLift_m = 0.1, kLift_s = 1, kHold_s = 5;
inline constexpr double kSagTime_s = 1;              ///< then nothing may move any more
inline constexpr double kRamp_s = 0.2, kLoad_s = 5;  ///< of the six directions
inline constexpr double kGravity = 9.81;             ///< [m/s^2]
inline constexpr double kPushed_m = 0.01;            ///< farther before it is held: it failed
/// Farther from the written trajectory a failure is the servos' [degrees, or mm of what slides].
inline constexpr double kArmAstray = 1, kHandAstray = 5;
inline constexpr double kCreep_m = 0.001, kCreep_deg = 1;    ///< while it is held
inline constexpr double kMotion_m = 0.02, kMotion_deg = 25;  ///< in all, in the palm's frame

// The ensemble.
inline constexpr double kFactor = 0.2;  ///< friction, torsion and mass, 1 more or less
inline constexpr double kShift_m = 0.002, kTurn_deg = 2;

}  // namespace morphe::simulate
