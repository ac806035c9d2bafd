#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/import/audit/arm_side.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/sampled_points.hpp"
#include "stages/import/guess/body_cues.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {
namespace {

Doubt tilted(double angle_rad, double limit_rad, std::string text) {
  return {.flag = {.code = FlagCode::vertical,
                   .value = angle_rad / kRadPerDegree,
                   .limit = limit_rad / kRadPerDegree,
                   .unit = "deg",
                   .text = std::move(text)}};
}

/// Returns the angle between the body's vertical and Z; NaN if the pose does not give it.
double tilt_rad(const BodyVertical& body) {
  if (!(body.agreement > kMinVerticalAgreement)) return kUnknown;
  return std::acos(std::clamp(body.up.z(), -1.0, 1.0));
}

/// Returns the median slope of the line between the shoulders, up to the right; NaN without it.
double shoulder_slope_rad(const RecordedPoints& points) {
  const auto left = mean_track(points, "left shoulder"),
             right = mean_track(points, "right shoulder");
  std::vector<double> slopes;
  for (int i = 0; i < std::ssize(left); ++i) {
    const Vec3 across = right[i] - left[i];
    if (across.norm() > 0) slopes.push_back(std::asin(across.z() / across.norm()));
  }
  return math::median(slopes);
}

/// Returns the least angle of the upper arm from the vertical, at rest or in all frames; NaN
/// without shoulder and elbow.
double upper_arm_rad(const RecordedPoints& points, const RecordedPoints& rest, Side side) {
  return std::fmin(arm_bearing(points, side).upper_arm_rad, arm_bearing(rest, side).upper_arm_rad);
}

/// Flags an arm without a trunk whose elbow is not below its shoulder.
std::vector<Doubt> raised_arm(double angle_rad) {
  if (!(angle_rad > kMaxUpperArm_rad)) return {};
  return {tilted(angle_rad, kMaxUpperArm_rad,
                 fmt::format("the upper arm is {:.0f} degrees from hanging down, also at rest: do "
                             "the axes point right, forward and up?",
                             angle_rad / kRadPerDegree))};
}

/// Returns the doubt that the vertical of the body is not Z but another axis.
Doubt lying(const Guess& axes, double tilt, bool axes_given) {
  Doubt doubt = tilted(tilt, kMaxTilt_rad,
                       fmt::format("the body does not stand upright: its up is {} instead of z, by "
                                   "its posture",
                                   axes.value.substr(axes.value.rfind(' ') + 1)));
  if (!axes_given) doubt.question = {"axes", axes.value, axes.reason};
  return doubt;
}

}  // namespace

std::vector<Doubt> check_vertical(const Demonstration& recording, const AuditInput& input) {
  const RecordedPoints points = sampled_points(recording.streams, recording.hand);
  const Guess axes = guess_axes(points);
  const RecordedPoints rest = frames_at_rest(points, recording.hand);
  const BodyVertical body = body_vertical(points);
  const double arm = body.trunk_known ? 0 : upper_arm_rad(points, rest, recording.hand);
  if (axes.value.empty()) return raised_arm(arm);
  const double tilt = std::fmin(tilt_rad(body), tilt_rad(body_vertical(rest)));
  if (axes.confidence == Confidence::sure && !axes.value.ends_with(" z"))
    return {lying(axes, tilt, input.axes_given)};
  const double max_tilt = body.trunk_known ? kMaxTilt_rad : kMaxArmTilt_rad;
  const double slope = std::abs(shoulder_slope_rad(rest));
  if (!(tilt > max_tilt) && !(slope > kMaxShoulderSlope_rad)) return raised_arm(arm);
  const AxesAgreement agreement = axes_agreement(points);
  if (agreement.left_handed > agreement.right_handed)
    return raised_arm(
        arm);  // check_chirality() reports a mirrored body, which has no such rotation
  if (tilt > max_tilt) {
    return {tilted(tilt, max_tilt,
                   fmt::format("the body's vertical is {:.0f} degrees from z: are the axes of the "
                               "laboratory tilted?",
                               tilt / kRadPerDegree))};
  }
  return {tilted(slope, kMaxShoulderSlope_rad,
                 fmt::format("the line between the shoulders slopes by {:.0f} degrees at rest: are "
                             "the axes of the laboratory tilted?",
                             slope / kRadPerDegree))};
}

}  // namespace morphe::imports
