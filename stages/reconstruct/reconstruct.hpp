#pragma once

#include <optional>
#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Config section `reconstruct`.
struct ReconstructOptions {
  double rate_hz = 100;  ///< of the clock that every stream is brought to
  /// -3 dB of the zero-phase low-pass. Residual analysis of the ue-adl trials: from 10 to 8 Hz the
  /// fingertip's residual grows by 0.01-0.08 mm, from 8 to 6 Hz by up to 0.13 mm: at 8 Hz what is
  /// taken away is still noise, and every Hz less helps jerk.
  double cutoff_hz = 8;
  /// The same for a glove whose hand rests: what is faster there is noise (glove_filter.hpp). A
  /// drift of the posture is slower; cutoff_hz or more: no difference between rest and motion.
  double glove_rest_cutoff_hz = 2;
  double max_gap_s = 0.1;  ///< longer gaps stay unseen; shorter ones are bridged by the spline
  /// Correct a glove's clock by what glove and arm both saw of the wrist, where that is clear.
  bool align_clocks = true;
  /// From a marker's centre to the finger's axis under it, towards the other of the two tips. The
  /// markers sit on the nails: half a 14 mm marker and about 5 mm of nail and finger. Along the
  /// line of the two tips, because pads oppose each other in a grasp, while the pad's normal
  /// cannot be told from one marker a finger.
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
std::string why_invalid(const ReconstructOptions& options);

inline constexpr double kUsualStature_m = 1.70;

/// Config section `human`: the arm of a recording that saw only the hand.
struct HumanOptions {
  /// Gives the lengths that nothing else gives; none: by the hand's length, else 1.70.
  std::optional<double> stature_m;
  std::optional<double> upper_arm, forearm;  ///< [m]; a recording's own lengths come first
  /// Shoulder relative to the first wrist position (X right, Y forward, Z up) [m]: as three seated
  /// ue-adl subjects held their resting hand, within 50 mm. Then moved as little as reach asks for.
  Vec3 shoulder_from_first_wrist = Vec3(0.0, -0.21, 0.24);
  double reach_share = 0.95;  ///< largest shoulder-wrist distance over upper arm + forearm
  /// RMS over a recording; beyond it is no person's arm (human_limits.hpp). Recordings that are
  /// right lie up to 56 mm beyond, two of a person taken to face the other way 215 and 243 mm.
  double beyond_limits_m = 0.1;
  /// Swivel of the elbow to the right [rad]. Medians of the ue-adl trials: 6 to 17 degrees, 30 in
  /// the reach across the body.
  double elbow_outward = 0.2;
};
template <class Fields>
void fields(Fields& f, HumanOptions& o) {
  f("stature_m", o.stature_m);
  f("upper_arm", o.upper_arm);
  f("forearm", o.forearm);
  f("shoulder_from_first_wrist", o.shoulder_from_first_wrist);
  f("reach_share", o.reach_share);
  f("elbow_outward", o.elbow_outward);
  f("beyond_limits_m", o.beyond_limits_m);
}
std::string why_invalid(const HumanOptions& options);

/// Rebuilds a demonstration on one clock: positions of shoulder, elbow, wrist and fingertips and
/// the orientation of the hand, low-passed, as a right hand (a left one is mirrored, see
/// mirror.hpp). Never throws: what cannot be rebuilt is NaN and a sentence in `problems`.
///
/// Markers (right arm: clusters RUAR1-4, RLAR1-4, RHAN1-4; tips RTHUM, RFTP; in the static trial
/// also RGTH shoulder, RLEP and RMEP epicondyles, RSPR and RSPU styloids, RFB finger base): every
/// cluster is registered to the static trial and carries the landmarks. The elbow is blended from
/// the upper-arm and the forearm cluster and kept at the static trial's distance from the shoulder,
/// the wrist from forearm and hand; what they disagree by is in `residuals`.
///
/// Sensors (`wrist`, and `shoulder`, `elbow` where tracked): each pose is carried to the joint
/// centre by its calibrated offset before filtering; upper arm and forearm keep their median
/// lengths; the arm's angles follow in closed form. A shoulder and elbow that were not tracked are
/// estimated and listed in `estimated`. Fingertips that were recorded are taken as they are; a
/// glove's angles become fingers by core/human/hand, its clock corrected first (align_clocks).
HumanMotion reconstruct(const Demonstration& demonstration, const ReconstructOptions& options,
                        const HumanOptions& human);

}  // namespace morphe::reconstruct
