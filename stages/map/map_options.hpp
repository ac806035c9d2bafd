#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/humanlike/frame_objective.hpp"
#include "core/motion/key_bounds.hpp"
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
///   fingertip_only      the positions of the tips alone: no humanlikeness, no orientation either
enum class MapMode { humanlike, joint_to_joint, inverse_kinematics, fingertip_only };
/// Returns the names of the modes in configurations.
constexpr std::array<std::string_view, 4> names_of(MapMode) {
  return {"humanlike", "joint_to_joint", "inverse_kinematics", "fingertip_only"};
}

/// The rule that chooses one of the paths whose values differ by less than a share.
///   nearest_home     nearest to the reference posture of the robot (reference_posture.hpp)
///   best             the least value
///   nearest_posture  nearest to a posture that the config states
enum class BranchRule { nearest_home, best, nearest_posture };
/// Returns the names of the rules in configurations.
constexpr std::array<std::string_view, 3> names_of(BranchRule) {
  return {"nearest_home", "best", "nearest_posture"};
}

/// The natural position of a joint while no goal determines it: q = value, or q_follow + value.
struct NaturalJoint {
  std::string joint, follow;  ///< names of the joint and of the one that it follows, or ""
  double value = 0;           ///< [rad]
};

/// The offset of the robot's base (for a hand, of its wrist), which is optimised together with the
/// mapping, once per movement (Section 3.3 of the paper).
struct BaseOffset {
  double limit_m = 0;  ///< largest offset along each axis of the world; 0 disables it
  double weight = 1;   ///< on its square, added to the mean of the frames' objectives [1/m²]
};
template <class Fields>
void fields(Fields& f, BaseOffset& o) {
  f("limit", o.limit_m, bounds::kLength);
  f("weight", o.weight, bounds::kWeight);
}

/// Returns the default weights. Humanlikeness, clearance and smoothness pull tips off their goals,
/// on the shipped recordings by at most 2 mm (tests/cli/test_run.py). Tips give way to
/// collisions, because beyond their clearance these cost more than tips a little farther away. The
/// weights of tips, palm, arm, wrist, clearance and motion were chosen together, by hand, on ten
/// drinking movements of five people and all shipped pipelines: a palm nearer to the person's costs
/// duration, upper arm and the wrist's speed profile (docs/steps/map.md).
inline humanlike::FrameObjective default_objective() {
  humanlike::FrameObjective o;
  o.get<humanlike::TipPosition>().weight = 100000;
  o.get<humanlike::TipOrientation>().weight = 0.01;
  o.get<humanlike::PadDirection>().weight = 0.05;
  o.get<humanlike::PalmDirection>().weight = 0.4;
  o.get<humanlike::JointDistance>().weight = 3;
  o.get<humanlike::FingerJointDistance>().weight = 0.1;
  o.get<humanlike::NaturalPosture>().weight = 0.02;
  return o;
}

/// Options of the mapping (config section `map`): weights of Eq. (16), other terms, and search.
struct MapOptions {
  MapMode mode = MapMode::humanlike;
  humanlike::FrameObjective objective = default_objective();
  std::vector<PhaseWeights> phases;     ///< factors on the weights, by phase
  double phase_blend_s = 0.2;           ///< time over which the factors of two phases are blended
  double orientation_smoothing = 1e-3;  ///< rounds the kink of the unsquared angle [rad]
  std::vector<NaturalJoint> natural_posture;  ///< joints of fingers without a goal
  BaseOffset base_offset;
  ClearanceTerm clearance;
  bool avoid_target = true;    ///< unseen fingers and the palm respect the target's contact depth
  MovementCost movement_cost;  ///< added to the frames' objectives
  double wrist_motion = 4;     ///< weight in PathProblem [s²/m²]
  BranchRule branch = BranchRule::nearest_home;
  double branch_share = 0.05;                ///< by which a path may exceed the least value [-]
  std::vector<NaturalJoint> branch_posture;  ///< of nearest_posture; joints not listed are at 0
  int key_frames = 5;                        ///< number of frames at which the global search starts
  int starts = 24;                           ///< spread starts per key frame
  int candidates = 4;               ///< distinct minima per key frame that are kept and tracked
  double coarse_step_s = 0.05;      ///< step of the grid on which paths are tracked and compared
  int reach_search_starts = 256;    ///< random starts before a goal is declared unreachable
  double reach_tolerance_m = 1e-4;  ///< error below which that search regards a goal as reached
  solve::MinimiseOptions frame_solver;
  solve::MovementOptions movement_solver;
};
template <class Fields>
void fields(Fields& f, NaturalJoint& o) {
  f.required("joint", o.joint);
  f("follow", o.follow);
  f("value", o.value, bounds::kJointPosition);
}
template <class Fields>
void fields(Fields& f, MapOptions& o) {
  f("mode", o.mode);
  fields(f, o.objective);
  f("phases", o.phases);
  f("phase_blend_s", o.phase_blend_s, bounds::kDuration);
  f("orientation_smoothing", o.orientation_smoothing, bounds::kPositiveAngle);
  f("natural_posture", o.natural_posture);
  f("base_offset", o.base_offset);
  f("clearance", o.clearance);
  f("avoid_target", o.avoid_target);
  f("movement_cost", o.movement_cost);
  f("wrist_motion", o.wrist_motion, bounds::kWeight);
  f("branch", o.branch);
  f("branch_share", o.branch_share, bounds::kFactorOrNone);
  f("branch_posture", o.branch_posture);
  f("key_frames", o.key_frames, bounds::kSearchCount);
  f("starts", o.starts, bounds::kSearchCount);
  f("candidates", o.candidates, bounds::kSearchCount);
  f("coarse_step_s", o.coarse_step_s, bounds::kTimeStep);
  f("reach_search_starts", o.reach_search_starts, bounds::kCount);
  f("reach_tolerance_m", o.reach_tolerance_m, bounds::kPositiveLength);
  f("frame_solver", o.frame_solver);
  f("movement_solver", o.movement_solver);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const MapOptions& options);

/// Creates a robot's objective. Throws InputError if `natural_posture` names an unknown joint.
humanlike::FrameObjective make_objective(const MapOptions& options, const RobotModel& robot);

/// Returns the options' branch_posture [n], moved into the limits. Throws InputError if it names an
/// unknown joint.
JointVector branch_posture(const MapOptions& options, const RobotModel& robot);

}  // namespace morphe::map
