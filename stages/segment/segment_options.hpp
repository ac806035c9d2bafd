#pragma once

#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/movement.hpp"

namespace morphe::segment {

/// The last phase that is planned of recordings whose stated task contains a word.
struct TaskEnd {
  std::string task;  ///< the word, such as drink
  PhaseKind until = PhaseKind::grasp;
};
template <class Fields>
void fields(Fields& f, TaskEnd& o) {
  f.required("task", o.task);
  f.required("until", o.until);
}

/// Options of the segmentation. Speeds are those of the index tip (of the wrist if the tip is not
/// seen) after smoothing by a Gaussian of `velocity_smoothing_s`, which is widened for noisy
/// signals.
struct SegmentOptions {
  /// Least standard deviation of the Gaussian on velocities [s].
  double velocity_smoothing_s = 0.02;
  double onset_share = 0.05;     ///< share of its peak speed at which a unit begins and ends
  double min_peak_speed = 0.05;  ///< least peak speed of a unit that is not weak [m/s]
  /// Share for two decisions. A unit includes a part with a peak above this share of its own. A
  /// unit that travels less than this share of the farthest of its neighbours is weak.
  double weak_unit_share = 0.08;
  /// Speed in a dip, as a share of the smaller peak beside it, below which the dip separates two
  /// units if the direction changes there by a right angle or more.
  double dip_share = 0.35;
  double min_reach_distance = 0.05;  ///< least displacement of a reach [m]
  /// A movement comes home if it ends closer to its start than this and than half its reach [m].
  double return_radius = 0.10;
  /// Least widening of the aperture in a reach to grasp, as a share of that at the reach's start.
  double opening_share = 0.15;
  double closing_share = 0.15;   ///< least closing after that, as a share of the widening
  double preshape_share = 0.10;  ///< share of the widening at which the preshape begins
  double min_grasp_s = 0.06;  ///< least duration of a grasp and of the hold that indicates it [s]
  double min_object_displacement = 0.005;  ///< least one of a recorded object that moves [m]
  double hold_after_touch_s = 0.1;  ///< planned part of the hold after a reach without a grasp [s]
  /// True if a hand that pauses on its way to an object, which it moves later, grasps on arrival;
  /// false if it grasps in that pause.
  bool until_grasped = false;
  /// True if the recording is one movement without phases (a gesture, which contains no reach).
  bool whole_recording = false;
  PhaseKind plan_until = PhaseKind::grasp;  ///< last phase planned, of those that may end a plan
  std::vector<TaskEnd> plan_until_by_task;  ///< exceptions; the first that applies counts
  /// Parts that are delivered as partial plans if a later part cannot be planned.
  PartialPlans partial = PartialPlans::at_rest;
};
template <class Fields>
void fields(Fields& f, SegmentOptions& o) {
  f("velocity_smoothing_s", o.velocity_smoothing_s, bounds::kSmoothing);
  f("onset_share", o.onset_share, bounds::kShareBelow1.above_lower());
  f("min_peak_speed", o.min_peak_speed, bounds::kSpeed);
  f("weak_unit_share", o.weak_unit_share, bounds::kShareBelow1);
  f("dip_share", o.dip_share, bounds::kShareBelow1.above_lower());
  f("min_reach_distance", o.min_reach_distance, bounds::kLength);
  f("return_radius", o.return_radius, bounds::kLength);
  f("opening_share", o.opening_share, bounds::kShareBelow1);
  f("closing_share", o.closing_share, bounds::kShareBelow1);
  f("preshape_share", o.preshape_share, bounds::kShareBelow1);
  f("min_grasp_s", o.min_grasp_s, bounds::kDuration);
  f("min_object_displacement", o.min_object_displacement, bounds::kLength);
  f("hold_after_touch_s", o.hold_after_touch_s, bounds::kDuration);
  f("until_grasped", o.until_grasped);
  f("whole_recording", o.whole_recording);
  f("plan_until", o.plan_until);
  f("plan_until_by_task", o.plan_until_by_task);
  f("partial", o.partial);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const SegmentOptions& options);

}  // namespace morphe::segment
