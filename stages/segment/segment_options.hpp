#pragma once

#include <string>

#include "core/motion/movement.hpp"

namespace morphe::segment {

/// Speeds are those of the index tip (of the wrist where the tip is not seen), after a Gaussian of
/// `smoothing`, wider in noise. Shares are of a bout's own peak or way, never of another's.
struct SegmentOptions {
  double smoothing = 0.02;    ///< least standard deviation of the Gaussian on velocities [s]
  double onset_share = 0.05;  ///< a bout begins and ends where it passes this share of its peak
  double least_peak = 0.05;   ///< what is never faster is no bout [m/s]
  double weak_share =
      0.08;  ///< after its last part above this share of its peak a bout is over;
             ///< a bout that goes less than this share of its neighbours' way is weak
  double dip_share = 0.35;    ///< two peaks are two bouts if the dip is below this share of the
                              ///< smaller one, where the way turns by a right angle
  double least_reach = 0.05;  ///< a bout that goes less far is no reach [m]
  double home_radius = 0.10;  ///< back this near to its start (and half its reach) it is over [m]
  double widening_share = 0.15;  ///< a reach to grasp opens the hand by this share of the start's
  double closing_share = 0.15;   ///< … and closes again by this share of the widening
  double preshape_share = 0.10;  ///< preshape begins at this share of the widening
  double least_grasp = 0.06;  ///< length of a grasp without a pause, around the slowest point [s]
  double object_motion = 0.005;  ///< a recorded object that went this far is being moved [m]
  double touch_hold = 0.1;  ///< how much of the hold after a reach without a grasp is planned [s]
  bool until_taken =
      false;           ///< a hand that pauses before it has what it moves grasps where it has it
  bool whole = false;  ///< the recording is one movement without phases, whatever moves in it
  PhaseKind plan_until = PhaseKind::grasp;  ///< grasp, transport or return: the last phase planned
};
template <class Fields>
void fields(Fields& f, SegmentOptions& o) {
  f("smoothing", o.smoothing);
  f("onset_share", o.onset_share);
  f("least_peak", o.least_peak);
  f("weak_share", o.weak_share);
  f("dip_share", o.dip_share);
  f("least_reach", o.least_reach);
  f("home_radius", o.home_radius);
  f("widening_share", o.widening_share);
  f("closing_share", o.closing_share);
  f("preshape_share", o.preshape_share);
  f("least_grasp", o.least_grasp);
  f("object_motion", o.object_motion);
  f("touch_hold", o.touch_hold);
  f("until_taken", o.until_taken);
  f("whole", o.whole);
  f("plan_until", o.plan_until);
}
std::string why_invalid(const SegmentOptions& options);

}  // namespace morphe::segment
