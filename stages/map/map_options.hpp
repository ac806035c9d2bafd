#pragma once

#include <string>
#include <vector>

#include "pipeline/humanlike/frame_objective.hpp"
#include "pipeline/solve/minimise.hpp"
#include "pipeline/solve/minimise_movement.hpp"
#include "stages/map/clearance_term.hpp"
#include "stages/map/movement_cost.hpp"
#include "stages/map/phase_weights.hpp"

namespace morphe {

/// What a joint does while no goal asks anything of it: q = value, or q = q_follow + value.
struct NaturalJoint {
  std::string joint, follow;
  double value = 0;  ///< [rad]
};

/// Config section `map`: weights of Eq. (16), our terms beside it, and the search.
struct MapOptions {
  /// w_x [1/m²]. Humanlikeness, clearance and smoothness all pull tips off their goals, by as much
  /// as they outweigh this: 1000 leaves up to 1.4 mm on the shipped recordings, 10000 at most 0.3
  /// mm.
  double tip_position = 10000;
  double tip_orientation = 0.01;        ///< w_o [1/rad]
  double hand_orientation = 0.01;       ///< weak goal where fewer than three tips are seen [1/rad]
  double humanlike_arm = 1;             ///< w_A, on the mean over the joint centres [1/m²]
  double humanlike_fingers = 0.1;       ///< w_a [1/m²]
  double posture = 1e-3;                ///< natural posture of unseen fingers [1/rad²]
  std::vector<PhaseWeights> phases;     ///< what phases multiply these weights by
  double phase_blend_s = 0.2;           ///< from one phase's weights to the next's
  double orientation_smoothing = 1e-3;  ///< rounds the kink of the unsquared angle [rad]
  std::vector<NaturalJoint> natural;    ///< the natural posture
  ClearanceTerm clearance;
  bool clear_of_target = true;  ///< unseen fingers and palm respect the target's contact depth

  MovementCost movement_cost;   ///< of the whole movement, beside the frames' objectives
  int key_frames = 3;           ///< where the global search starts
  int starts = 48;              ///< random starts at each of them
  int candidates = 6;           ///< distinct minima kept at each and followed through the movement
  double coarse_step_s = 0.05;  ///< grid on which candidates are followed and compared
  int reachable_starts = 256;   ///< before a goal is declared out of reach
  double reachable_m = 1e-4;    ///< error below which a goal counts as met by that search
  MinimiseOptions solver;       ///< of single frames
  MovementOptions movement;
};
template <class Fields>
void fields(Fields& f, NaturalJoint& o) {
  f.required("joint", o.joint);
  f("follow", o.follow);
  f("value", o.value);
}
template <class Fields>
void fields(Fields& f, MapOptions& o) {
  f("tip_position", o.tip_position);
  f("tip_orientation", o.tip_orientation);
  f("hand_orientation", o.hand_orientation);
  f("humanlike_arm", o.humanlike_arm);
  f("humanlike_fingers", o.humanlike_fingers);
  f("posture", o.posture);
  f("phases", o.phases);
  f("phase_blend_s", o.phase_blend_s);
  f("orientation_smoothing", o.orientation_smoothing);
  f("natural", o.natural);
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
std::string check(const MapOptions& options);

/// The frame objective that the options and the robot make; InputError if `natural` names an
/// unknown joint.
FrameObjective make_objective(const MapOptions& options, const RobotTable& robot);

}  // namespace morphe
