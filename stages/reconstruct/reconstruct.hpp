#pragma once

#include <optional>
#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Options of the reconstruction (config section `reconstruct`).
struct ReconstructOptions {
  double rate_hz = 100;  ///< rate of the clock to which every stream is resampled
  /// -3 dB frequency of the zero-phase low-pass. By residual analysis of the ue-adl trials, the
  /// fingertip's residual grows by 0.01-0.08 mm from 10 to 8 Hz, and by up to 0.13 mm from 8 to 6
  /// Hz: at 8 Hz the removed part is still noise, and every Hz less reduces the jerk.
  double cutoff_hz = 8;
  /// The same for a glove with a resting hand: higher frequencies are noise (glove_filter.hpp). A
  /// drift of the posture is slower. With cutoff_hz or more, rest and motion are filtered alike.
  double glove_rest_cutoff_hz = 2;
  double max_gap_s = 0.1;  ///< shorter gaps are bridged by the spline, longer ones stay unseen
  /// True if a glove's clock is corrected by the motion of the wrist measured by both glove and
  /// arm, if that is reliable.
  bool align_clocks = true;
  /// Distance from a marker's centre to the finger's axis under it, towards the other of the two
  /// tips. The markers are on the nails: half a 14 mm marker and about 5 mm of nail and finger. The
  /// direction is that of the line between the two tips, because pads oppose each other in a grasp,
  /// while the pad's normal cannot be determined from a single marker per finger.
  double thumb_marker_to_axis_m = 0.012, index_marker_to_axis_m = 0.012;
};
template <class Fields>
void fields(Fields& f, ReconstructOptions& o) {
  f("rate_hz", o.rate_hz);
  f("cutoff_hz", o.cutoff_hz);
  f("glove_rest_cutoff_hz", o.glove_rest_cutoff_hz);
  f("max_gap_s", o.max_gap_s);
  f("align_clocks", o.align_clocks);
  f("thumb_marker_to_axis_m", o.thumb_marker_to_axis_m);
  f("index_marker_to_axis_m", o.index_marker_to_axis_m);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const ReconstructOptions& options);

/// Stature of a person of unknown size [m].
inline constexpr double kDefaultStature_m = 1.70;

/// Options of the human body (config section `human`), for recordings of the hand alone.
struct HumanOptions {
  /// Stature [m], from which lengths that are not given otherwise are derived; without a value, it
  /// follows from the length of the hand, otherwise it is 1.70.
  std::optional<double> stature_m;
  std::optional<double> upper_arm, forearm;  ///< [m]; a recording's own lengths take precedence
  /// Shoulder relative to the first wrist position (X right, Y forward, Z up) [m]: that of three
  /// seated ue-adl subjects with a resting hand, within 50 mm. It is then moved as little as reach
  /// requires.
  Vec3 shoulder_from_first_wrist = Vec3(0.0, -0.21, 0.24);
  /// Largest shoulder-wrist distance as a share of upper arm + forearm.
  double max_reach_share = 0.95;
  /// RMS over a recording above which the arm is not human (human_limits.hpp). Correct recordings
  /// have up to 56 mm, two of a person assumed to face the other way 215 and 243 mm.
  double max_limit_violation_m = 0.1;
  /// Swivel angle of the elbow to the right [rad]. Medians of the ue-adl trials: 6 to 17 degrees,
  /// 30 in the reach across the body.
  double elbow_swivel = 0.2;
};
template <class Fields>
void fields(Fields& f, HumanOptions& o) {
  f("stature_m", o.stature_m);
  f("upper_arm", o.upper_arm);
  f("forearm", o.forearm);
  f("shoulder_from_first_wrist", o.shoulder_from_first_wrist);
  f("max_reach_share", o.max_reach_share);
  f("elbow_swivel", o.elbow_swivel);
  f("max_limit_violation_m", o.max_limit_violation_m);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const HumanOptions& options);

/// Reconstructs a demonstration on one clock: positions of shoulder, elbow, wrist and fingertips
/// and the orientation of the hand, low-passed, as a right hand (a left one is mirrored, see
/// mirror.hpp). Never throws: quantities that cannot be reconstructed are NaN and reported in
/// `reconstruction_notes`.
///
/// Markers (right arm: clusters RUAR1-4, RLAR1-4, RHAN1-4; tips RTHUM, RFTP; in the static trial
/// also RGTH shoulder, RLEP and RMEP epicondyles, RSPR and RSPU styloids, RFB finger base): every
/// cluster is registered to the static trial and carries the landmarks. The elbow is blended from
/// the upper-arm and the forearm cluster and kept at the static trial's distance from the shoulder,
/// the wrist from forearm and hand; their disagreement is in `residuals`.
///
/// Sensors (`wrist`, and `shoulder`, `elbow` if tracked): each pose is transformed to the joint
/// centre by its calibrated offset before filtering; upper arm and forearm keep their median
/// lengths; the arm's angles follow in closed form. A shoulder and elbow that were not tracked are
/// estimated and listed in `estimated`. Recorded fingertips are used unchanged; a glove's angles
/// are converted to fingers by core/human/hand after correction of its clock (align_clocks).
HumanMotion reconstruct(const Demonstration& demonstration, const ReconstructOptions& options,
                        const HumanOptions& human);

}  // namespace morphe::reconstruct
