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

/// How goals become joint angles; the last three are what the paper compares itself with.
/// Clearance, movement cost and the natural posture of fingers without a goal count in all of them,
/// and all are judged alike.
///   humanlike           the objective with all its terms
///   joint_to_joint      the human's joint angles instead of its fingertips (joint_to_joint.hpp)
///   inverse_kinematics  without humanlikeness: w_A, w_a, w_B and w_C are zero
///   fingertip_only      the tips' positions alone: no humanlikeness, and no orientation of tips
///                       or hand either
enum class MapMode { humanlike, joint_to_joint, inverse_kinematics, fingertip_only };
constexpr std::array<std::string_view, 4> names_of(MapMode) {
  return {"humanlike", "joint_to_joint", "inverse_kinematics", "fingertip_only"};
}

/// What a joint does while no goal asks anything of it: q = value, or q = q_follow + value.
struct NaturalJoint {
  std::string joint, follow;
  double value = 0;  ///< [rad]
};

/// Section 3.3 of the paper: where the robot's base (a hand's: its wrist) stands is chosen with the
/// mapping, one place for a movement.
struct BaseOffset {
  double limit_m = 0;  ///< along each axis of the world, from where the placement puts it; 0: off
  double weight = 1;   ///< on its square, beside the mean of the frames' objectives [1/m²]
};
template <class Fields>
void fields(Fields& f, BaseOffset& o) {
  f("limit", o.limit_m);
  f("weight", o.weight);
}
std::string why_invalid(const BaseOffset& options);

/// Humanlikeness, clearance and smoothness all pull tips off their goals, by as much as they
/// outweigh w_x: 1000 leaves up to 1.4 mm on the shipped recordings, 20000 at most 0.25 mm. The
/// clearance term's weight is a tenth of it: tips give way to collisions as before. The hand's
/// orientation is a weak goal.
inline humanlike::FrameObjective usual_objective() {
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

/// Config section `map`: weights of Eq. (16), our terms beside it, and the search.
struct MapOptions {
  MapMode mode = MapMode::humanlike;
  humanlike::FrameObjective objective = usual_objective();  ///< its weights
  std::vector<PhaseWeights> phases;     ///< what phases multiply these weights by
  double phase_blend_s = 0.2;           ///< from one phase's weights to the next's
  double orientation_smoothing = 1e-3;  ///< rounds the kink of the unsquared angle [rad]
  std::vector<NaturalJoint> natural;    ///< the natural posture
  BaseOffset free_offset;
  ClearanceTerm clearance;
  bool clear_of_target = true;  ///< unseen fingers and palm respect the target's contact depth

  MovementCost movement_cost;   ///< of the whole movement, beside the frames' objectives
  int key_frames = 5;           ///< where the global search starts
  int starts = 24;              ///< random starts at each of them
  int candidates = 4;           ///< distinct minima kept at each and followed through the movement
  double coarse_step_s = 0.05;  ///< grid on which candidates are followed and compared
  int reachable_starts = 256;   ///< before a goal is declared out of reach
  double reachable_m = 1e-4;    ///< error below which a goal counts as met by that search
  solve::MinimiseOptions solver;  ///< of single frames
  solve::MovementOptions movement;
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
  f("natural", o.natural);
  f("free_offset", o.free_offset);
  f("clearance", o.clearance);
  f("clear_of_target", o.clear_of_target);
  f("movement_cost", o.movement_cost);
  f("key_frames", o.key_frames);
  f("starts", o.starts);
  f("candidates", o.candidates);
  f("coarse_step_s", o.coarse_step_s);
  f("reachable_starts", o.reachable_starts);
  f("reachable_m", o.reachable_m);
  f("solver", o.solver);
  f("movement", o.movement);
}
std::string why_invalid(const MapOptions& options);

/// The frame objective that the options and the robot make; InputError if `natural` names an
/// unknown joint.
humanlike::FrameObjective make_objective(const MapOptions& options, const RobotTable& robot);

}  // namespace morphe::map
