#pragma once

#include <string>

#include "core/motion/movement.hpp"

namespace morphe::segment {

/// Options of the segmentation. Speeds are those of the index tip (of the wrist if the tip is not
/// seen) after smoothing by a Gaussian of `smoothing`, which is widened for noisy signals. Shares
/// refer to a unit's own peak or displacement, never to another unit's.
struct SegmentOptions {
  double smoothing = 0.02;    ///< least standard deviation of the Gaussian on velocities [s]
  double onset_share = 0.05;  ///< share of its peak speed at which a unit begins and ends
  double least_peak = 0.05;   ///< least peak speed of a unit that is not weak [m/s]
  /// A unit ends after its last part above this share of its peak; a unit that travels less than
  /// this share of its neighbours' displacement is weak.
  double weak_share = 0.08;
  /// Largest dip between two units, as a share of the smaller peak, for a change of direction by a
  /// right angle.
  double dip_share = 0.35;
  double least_reach = 0.05;  ///< least displacement of a reach [m]
  /// Distance from the start (at most half the reach) at which a movement has come home [m].
  double home_radius = 0.10;
  /// Widening of the aperture in a reach to grasp, as a share of its start.
  double widening_share = 0.15;
  double closing_share = 0.15;   ///< closing after that, as a share of the widening
  double preshape_share = 0.10;  ///< share of the widening at which the preshape begins
  double least_grasp = 0.06;  ///< duration of a grasp without a pause, around the slowest point [s]
  double object_motion = 0.005;  ///< least displacement of a recorded object that moves [m]
  double touch_hold = 0.1;       ///< planned part of the hold after a reach without a grasp [s]
  /// True if a hand that pauses before it has the moving object grasps only when it has it.
  bool until_taken = false;
  /// True if the recording is one movement without phases, regardless of the motion in it.
  bool whole = false;
  PhaseKind plan_until = PhaseKind::grasp;  ///< last phase planned: grasp, transport or return
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
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const SegmentOptions& options);

}  // namespace morphe::segment
