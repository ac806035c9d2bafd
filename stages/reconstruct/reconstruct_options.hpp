#pragma once

#include <optional>
#include <string>

#include "core/motion/geometry.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::reconstruct {

/// Options of the reconstruction (config section `reconstruct`).
struct ReconstructOptions {
  double rate_hz = 100;  ///< rate of the clock to which every stream is resampled
  /// -3 dB frequency of the zero-phase low-pass. In the ue-adl trials the fingertip's residual
  /// grows by 0.01-0.08 mm from 10 to 8 Hz, and by up to 0.13 mm from 8 to 6 Hz: at 8 Hz the
  /// removed part is still noise, and every Hz less reduces the jerk.
  double cutoff_hz = 8;
  /// -3 dB frequency for a glove while the hand rests (glove_filter.hpp). If it is cutoff_hz or
  /// more, rest and motion are filtered alike.
  double glove_rest_cutoff_hz = 2;
  double max_gap_s = 0.1;  ///< shorter gaps are bridged by the spline, longer ones stay unseen
  /// True if a glove's clock is corrected by the wrist motion that both glove and arm measure.
  bool align_clocks = true;
  /// Distance from a marker's centre to the finger's axis under it, towards the other tip: the
  /// markers are on the nails, half a 14 mm marker and about 5 mm of nail and finger away. Pads
  /// oppose each other in a grasp, and a single marker per finger does not show the pad's normal.
  double thumb_marker_to_axis_m = 0.012, index_marker_to_axis_m = 0.012;
};
template <class Fields>
void fields(Fields& f, ReconstructOptions& o) {
  f("rate_hz", o.rate_hz, bounds::kRate.from(1).up_to(1000));
  f("cutoff_hz", o.cutoff_hz, bounds::kRate);
  f("glove_rest_cutoff_hz", o.glove_rest_cutoff_hz, bounds::kRate);
  f("max_gap_s", o.max_gap_s, bounds::kPositiveDuration);
  f("align_clocks", o.align_clocks);
  f("thumb_marker_to_axis_m", o.thumb_marker_to_axis_m, bounds::kLength.up_to(0.05));
  f("index_marker_to_axis_m", o.index_marker_to_axis_m, bounds::kLength.up_to(0.05));
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const ReconstructOptions& options);

inline constexpr double kDefaultStature_m = 1.70;  ///< of a person of unknown size

/// Options of the human body (config section `human`), for recordings of the hand alone.
struct HumanOptions {
  /// Gives unknown lengths; if absent, it follows from the hand's length or is kDefaultStature_m.
  std::optional<double> stature_m;
  std::optional<double> upper_arm, forearm;  ///< [m]; a recording's own lengths take precedence
  /// Shoulder relative to the first wrist position (X right, Y forward, Z up) [m]: that of three
  /// seated ue-adl subjects with a resting hand, within 50 mm. The estimate then moves as little as
  /// max_reach_share requires.
  Vec3 shoulder_from_first_wrist = Vec3(0.0, -0.21, 0.24);
  double max_reach_share = 0.95;  ///< largest shoulder-wrist distance over upper arm + forearm
  /// RMS over a recording above which the arm is not human (human_limits.hpp). Correct recordings
  /// have up to 56 mm, two of a person assumed to face the other way 215 and 243 mm.
  double max_limit_violation_m = 0.1;
  /// Swivel angle of the elbow to the right [rad]. Medians of the ue-adl trials: 6 to 17 degrees,
  /// 30 in the reach across the body.
  double elbow_swivel = 0.2;
};
template <class Fields>
void fields(Fields& f, HumanOptions& o) {
  f("stature_m", o.stature_m, KeyBounds{0.5, 2.5, "m"});
  f("upper_arm", o.upper_arm, bounds::kBone);
  f("forearm", o.forearm, bounds::kBone);
  f("shoulder_from_first_wrist", o.shoulder_from_first_wrist, bounds::kCoordinate);
  f("max_reach_share", o.max_reach_share, bounds::kShareBelow1.above_lower());
  f("elbow_swivel", o.elbow_swivel, bounds::kAngle);
  f("max_limit_violation_m", o.max_limit_violation_m, bounds::kPositiveLength);
}

}  // namespace morphe::reconstruct
