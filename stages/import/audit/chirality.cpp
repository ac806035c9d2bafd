#include <fmt/format.h>

#include <cmath>

#include "stages/import/audit/arm_side.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/hand_side.hpp"
#include "stages/import/audit/sampled_points.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {
namespace {

Doubt mirrored(double value, double limit, const char* unit, std::string text) {
  return {.flag = {.code = FlagCode::mirrored,
                   .value = value,
                   .limit = limit,
                   .unit = unit,
                   .text = std::move(text)}};
}

/// Returns true if --hand can name the other hand: the points of the hand have no names of a side.
bool side_is_stated(const Streams& streams) { return !streams.markers && !streams.skeleton; }

/// Asks about a mirrored hand, whose body was not recorded or is not mirrored.
Doubt other_hand(const Demonstration& recording, const AuditInput& input, double palmward_m,
                 bool body_known) {
  const Side other = recording.hand == Side::right ? Side::left : Side::right;
  Doubt doubt = mirrored(
      palmward_m, -kMirroredHand_m, "m",
      fmt::format("the {} hand closes as a {} one: its fingertips are {:.0f} mm on the side of its "
                  "back{}",
                  name_of(recording.hand), name_of(other), -1000 * palmward_m,
                  body_known ? ", while the body is not mirrored" : ""));
  if (side_is_stated(recording.streams) && !input.hand_given) {
    doubt.question = {"hand", std::string(name_of(other)), "by its bent fingers"};
  } else if (!body_known && !input.axes_given) {
    doubt.question = {"axes", "-x y z", "the points are mirrored back", Confidence::likely};
  }
  return doubt;
}

/// Flags an arm without a trunk that is held as one of the other side. Z has to point up for that.
std::vector<Doubt> other_arm(const RecordedPoints& points, Side side) {
  const ArmBearing arm = arm_bearing(points, side);
  const bool mirrored_arm = arm.upper_arm_rad < kMaxUpperArm_rad &&
                            arm.thumb_inside_m < -kMirroredThumb_m &&
                            arm.elbow_outside_m < kMaxMirroredElbow_m;
  if (!mirrored_arm) return {};
  const Side other = side == Side::right ? Side::left : Side::right;
  return {mirrored(
      arm.thumb_inside_m, -kMirroredThumb_m, "m",
      fmt::format("the {} arm is held as a {} one: its thumb is {:.0f} mm on the outer side of the "
                  "index finger; are the axes left-handed?",
                  name_of(side), name_of(other), -1000 * arm.thumb_inside_m))};
}

}  // namespace

std::vector<Doubt> check_chirality(const Demonstration& recording, const AuditInput& input) {
  const RecordedPoints points = sampled_points(recording.streams, recording.hand);
  const AxesAgreement axes = axes_agreement(points);
  const double agreement = axes.left_handed;
  const double margin = agreement - axes.right_handed;  // may be NaN
  const double palmward_m = palmward_tips_m(recording);
  const bool trunk_known = body_vertical(points).trunk_known;  // one arm tells no side
  if (trunk_known && margin > kMirroredMargin && agreement > kMirroredAgreement) {
    if (palmward_m > kMirroredHand_m) {
      return {mirrored(margin, kMirroredMargin, "1",
                       "the body is a mirror image but its hand is not: left and right of the "
                       "shoulders are exchanged")};
    }
    Doubt doubt = mirrored(margin, kMirroredMargin, "1",
                           "the body is the mirror image of a person's: the axes are left-handed, "
                           "or left and right are exchanged in all names");
    const Guess guess = guess_axes(points, Handedness::left);
    if (!input.axes_given) doubt.question = {"axes", guess.value, guess.reason, guess.confidence};
    return {doubt};
  }
  if (!trunk_known && std::isnan(palmward_m)) return other_arm(points, recording.hand);
  if (!(palmward_m < -kMirroredHand_m)) return {};
  return {other_hand(recording, input, palmward_m, trunk_known && margin < -kMirroredMargin)};
}

}  // namespace morphe::imports
