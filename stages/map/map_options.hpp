#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/humanlike/frame_objective.hpp"
#include "core/solve/minimise.hpp"
#include "core/solve/minimise_movement.hpp"
#include "stages/map/clearance_term.hpp"
#include "stages/map/movement_cost.hpp"
#include "stages/map/phase_weights.hpp"

namespace morphe::map {

/// The mapping method. The last three are the baselines with which the paper compares its method.
/// Clearance, movement cost and the natural posture of fingers without a goal are part of all
/// modes, and all results are evaluated alike.
///   humanlike           the objective with all its terms
///   joint_to_joint      the human's joint angles instead of its fingertips (joint_to_joint.hpp)
///   inverse_kinematics  without humanlikeness: w_A, w_a, w_B and w_C are zero
///   fingertip_only      the positions of the tips alone: no humanlikeness, and no orientation of
///                       tips or hand either
enum class MapMode { humanlike, joint_to_joint, inverse_kinematics, fingertip_only };
/// Returns the names of the modes in configurations.
constexpr std::array<std::string_view, 4> names_of(MapMode) {
  return {"humanlike", "joint_to_joint", "inverse_kinematics", "fingertip_only"};
}

/// The natural position of a joint, to which it is drawn while no goal determines it: q = value, or
/// q = q_follow + value.
struct NaturalJoint {
  /// Name of the joint and of the joint that it follows, or "".
  std::string joint, follow;
  double value = 0;  ///< [rad]
};

/// The offset of the robot's base (for a hand, of its wrist), which is optimised together with the
/// mapping, once per movement (Section 3.3 of the paper).
struct BaseOffset {
  /// Limit along each axis of the world relative to the configured placement; 0 disables the
  /// offset.
  double limit_m = 0;
  double weight = 1;  ///< weight of its square, added to the mean of the frames' objectives [1/m²]
};
template <class Fields>
void fields(Fields& f, BaseOffset& o) {
  f("limit", o.limit_m);
  f("weight", o.weight);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const BaseOffset& options);

/// Returns the default weights of the objective. Humanlikeness, clearance and smoothness all pull
/// tips off their goals, by an amount that depends on their weights relative to w_x: 1000 leaves up
/// to 1.4 mm on the shipped recordings, 20000 at most 0.25 mm. The clearance term's weight is a
/// tenth of it, so that tips give way to collisions as before. The hand's orientation is a weak
/// goal.
inline humanlike::FrameObjective default_objective() {
  humanlike::FrameObjective o;
  o.get<humanlike::TipPosition>().weight = 20000;
  o.get<humanlike::TipOrientation>().weight = 0.01;
  o.get<humanlike::PadDirection>().weight = 0.05;
  o.get<humanlike::HandOrientation>().weight = 0.01;
  o.get<humanlike::JointDistance>().weight = 1;
  o.get<humanlike::FingerJointDistance>().weight = 0.1;
  o.get<humanlike::NaturalPosture>().weight = 1e-3;
  return o;
}

/// Options of the mapping (config section `map`): weights of Eq. (16), the additional terms, and
/// the search.
struct MapOptions {
  MapMode mode = MapMode::humanlike;                          ///< the mapping method
  humanlike::FrameObjective objective = default_objective();  ///< the objective with its weights
  std::vector<PhaseWeights> phases;  ///< factors of these weights in single phases
  double phase_blend_s = 0.2;  ///< time over which the weights are blended from phase to phase
  double orientation_smoothing = 1e-3;        ///< rounds the kink of the unsquared angle [rad]
  std::vector<NaturalJoint> natural_posture;  ///< joints of fingers without a goal
  BaseOffset base_offset;                     ///< offset of the base, optimised with the mapping
  ClearanceTerm clearance;                    ///< penalty on small clearances
  /// True if unseen fingers and the palm respect the target's contact depth.
  bool avoid_target = true;

  MovementCost movement_cost;  ///< cost of the whole movement, added to the frames' objectives
  int key_frames = 5;          ///< number of frames at which the global search starts
  int starts = 24;             ///< random starts at each of them
  int candidates = 4;          ///< distinct minima kept at each and tracked through the movement
  /// Time step of the grid on which candidate paths are tracked and compared.
  double coarse_step_s = 0.05;
  int reach_search_starts = 256;        ///< random starts before a goal is declared unreachable
  double reach_tolerance_m = 1e-4;      ///< error below which that search regards a goal as reached
  solve::MinimiseOptions frame_solver;  ///< options for single frames
  /// Options for whole movements.
  solve::MovementOptions movement_solver;
};
template <class Fields>
void fields(Fields& f, NaturalJoint& o) {
  f.required("joint", o.joint);
  f("follow", o.follow);
  f("value", o.value);
}
template <class Fields>
void fields(Fields& f, MapOptions& o) {
  f("mode", o.mode);
  fields(f, o.objective);
  f("phases", o.phases);
  f("phase_blend_s", o.phase_blend_s);
  f("orientation_smoothing", o.orientation_smoothing);
  f("natural_posture", o.natural_posture);
  f("base_offset", o.base_offset);
  f("clearance", o.clearance);
  f("avoid_target", o.avoid_target);
  f("movement_cost", o.movement_cost);
  f("key_frames", o.key_frames);
  f("starts", o.starts);
  f("candidates", o.candidates);
  f("coarse_step_s", o.coarse_step_s);
  f("reach_search_starts", o.reach_search_starts);
  f("reach_tolerance_m", o.reach_tolerance_m);
  f("frame_solver", o.frame_solver);
  f("movement_solver", o.movement_solver);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const MapOptions& options);

/// Creates the frame objective from the options for a robot. Throws InputError if `natural_posture`
/// names an unknown joint.
humanlike::FrameObjective make_objective(const MapOptions& options, const RobotModel& robot);

}  // namespace morphe::map
