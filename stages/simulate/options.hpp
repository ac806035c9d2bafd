#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "stages/simulate/servo_file.hpp"

namespace morphe::simulate {

/// The rollouts in which the target is also loaded in six directions; the first one has nominal
/// values.
enum class Directions { none, first, every };
constexpr std::array<std::string_view, 3> names_of(Directions) {
  return {"none", "first", "every"};
}

/// The squeeze: the plan's, or one at the points of the fingers that are nearest to the target,
/// which also replaces a missing squeeze of the plan.
enum class ContactSource { planned, nearest };
constexpr std::array<std::string_view, 2> names_of(ContactSource) { return {"planned", "nearest"}; }

/// A range that includes both ends.
struct Range {
  double from = 0, to = 0;
};

/// The parameters of the simulation that a plan does not contain or that a laboratory would change.
struct SimulateOptions {
  int rollouts = 16;  ///< number of rollouts per plan; the first one has nominal values
  Directions load_directions = Directions::first;
  double friction = 0.8;                ///< Coulomb coefficient between hand and target
  double torsional_friction_m = 0.002;  ///< for a pad with a contact radius of 4 mm
  double mass_kg = 0.3;                 ///< mass of the target
  /// log-uniform in all rollouts but the first; if absent, uniform up to kVariationShare off
  /// nominal
  std::optional<Range> friction_range, mass_range;
  ContactSource contacts = ContactSource::planned;
  double force_N = 8;  ///< force of the thumb and of the other fingers together, if not planned
  double step_s = 0.002;
  bool euler = false;          ///< semi-implicit Euler instead of the implicit integrator
  double density = 1000;       ///< of the robot's capsules [kg/m^3]
  double hand_stiffness = 10;  ///< of revolute finger joints, unpublished for most hands [N m/rad]
  double hand_torque_limit = 1;  ///< 10 N at 0.1 m [N m]
  ServoTable servos;       ///< parameters of individual joints, which override all of the above
  std::uint64_t seed = 1;  ///< of the variations
};
template <class Fields>
void fields(Fields& f, const SimulateOptions& o) {
  f("rollouts", o.rollouts);
  f("load_directions", name_of(o.load_directions));
  f("friction", o.friction);
  f("torsional_friction_m", o.torsional_friction_m);
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
  f("hand_torque_limit", o.hand_torque_limit);
  f("servos", text_of(o.servos));
  f("seed", o.seed);
}
/// Returns an error sentence, or "" if the options are valid.
std::string validation_error(const SimulateOptions& options);
/// Returns all options as text, one per line.
std::string text_of(const SimulateOptions& options);
/// Returns the assumptions made for every plan, one sentence each.
std::vector<std::string> assumptions(const SimulateOptions& options);

// Contact parameters of the engine [DexGraspBench's, softness 0.1 mm at 30 N].
inline constexpr const char* kContactSolref = "0.005 1";
inline constexpr const char* kContactSolimp = "0.5 0.99 0.0001";
// For elliptic friction cones; with pyramidal ones, a block falls that Coulomb friction holds.
inline constexpr int kImpratio = 10, kNoslipIterations = 5;
inline constexpr double kRollingFriction_m = 0.001;
inline constexpr double kSupportFriction = 0.5;  ///< neither helps nor hinders the test
// The servo that lifts a hand without an arm [N/m, N s/m]; it yields by 0.1 mm under 2 kg.
inline constexpr double kBaseStiffness = 2e5, kBaseVelocityGain = 2e3;
// Couplings are as stiff as the time step permits.
inline constexpr const char* kCouplingSolref = "0.004 1";
inline constexpr const char* kCouplingSolimp = "0.95 0.99 0.001";

// The test protocol.
inline constexpr double kClosingTime_s = 0.5, kForceRampTime_s = 0.5, kSettle_s = 0.3;
inline constexpr double kLiftHeight_m = 0.1, kLiftTime_s = 1, kHold_s = 5;
inline constexpr double kDroopTime_s = 1;                        ///< settling time under load
inline constexpr double kLoadRampTime_s = 0.2, kLoadTime_s = 5;  ///< in each of six directions
inline constexpr double kMaxPregraspDisplacement_m = 0.01;       ///< larger ones fail the rollout
/// Errors above which a failure is attributed to the servos [degrees, or mm for prismatic joints].
inline constexpr double kArmTrackingTolerance_deg = 1, kHandTrackingTolerance_deg = 5;
inline constexpr double kMaxDrift_m = 0.001, kMaxDrift_deg = 1;  ///< while the target is held
/// Limits of the displacement from the squeezed state, in the palm's frame.
inline constexpr double kMaxInHandDisplacement_m = 0.02, kMaxInHandDisplacement_deg = 25;

// The protocol for a plan that carries its target.
/// The trajectory's clock starts and stops within this time. Chosen by hand: the cups of the
/// shipped drinks move at 0.05 to 0.1 m/s at the end of the grasp and at the release, arm joints at
/// up to 1 rad/s. A stop within one step would be a blow.
inline constexpr double kClockRamp_s = 0.2;
inline constexpr double kStandTime_s = 1;  ///< after the trajectory, as long as kDroopTime_s
/// Limits of the target's pose after it was put down. Chosen by hand: the cups of the shipped
/// drinks are tilted by 0.9 to 5.5 degrees at their planned release; one that falls over turns
/// by 90.
inline constexpr double kMaxPlaceError_m = 0.01, kMaxTilt_deg = 10;
/// Share of the planned rise that the target must reach to count as lifted. Chosen by hand: fingers
/// that yield by kMaxInHandDisplacement_m must not decide alone, and a target left behind has 0.
inline constexpr double kMinRiseShare = 0.5;
inline constexpr double kLoadInterval_s = 0.1;  ///< between the loads of the force prediction

// The ensemble's variations.
inline constexpr double kVariationShare = 0.2;  ///< share of friction, torsion and mass
inline constexpr double kTargetShift_m = 0.002, kTargetTurn_deg = 2;

}  // namespace morphe::simulate
