#include <fmt/format.h>

#include <algorithm>

#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/clock_offset.hpp"
#include "stages/reconstruct/estimated_arm.hpp"
#include "stages/reconstruct/glove_hand.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/sensor_joints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kWristPitch = 20, kWristYaw = 21;  ///< glove sensors

/// Returns flexion and radial deviation of the wrist from the forearm's direction in the hand's
/// frame, (-sin f, -sin d cos f, cos d cos f) as in core/human/arm_angles.
std::array<std::vector<double>, 2> wrist_angles(const HumanMotion& motion) {
  std::array<std::vector<double>, 2> angles;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const Vec3 forearm =
        motion.wrist_orientation[i].conjugate() * (motion.wrist[i] - motion.elbow[i]).normalized();
    angles[0].push_back(std::asin(std::clamp(-forearm.x(), -1.0, 1.0)));
    angles[1].push_back(std::atan2(-forearm.y(), forearm.z()));
  }
  return angles;
}

/// Returns the time by which the glove's clock is ahead of the arm's, from the wrist motion
/// measured by both; 0 if that is not reliable. Signals are filtered below 3 Hz: at higher
/// frequencies a wrist moves less than the glove's noise.
double glove_clock_offset(const GloveColumns& glove, const TimeGrid& clock,
                          ReconstructOptions options, HumanMotion& motion) {
  options.cutoff_hz = std::min(options.cutoff_hz, 3.0);
  const auto slowed = [&](const std::vector<double>& values) {
    return resample(motion.time, values, clock, options);
  };
  const auto [flexion, deviation] = wrist_angles(motion);
  const ClockOffset offset = clock_offset({{slowed(flexion), slowed(glove[kWristPitch])},
                                           {slowed(deviation), slowed(glove[kWristYaw])}},
                                          clock.rate_hz, options.cutoff_hz);
  if (!is_reliable(offset)) {
    constexpr double kMinWristRate_rad_s = 0.3, kLowCorrelation = 0.5;  // [rad/s]; a correlation
    if (offset.rate_rms > kMinWristRate_rad_s && offset.correlation < kLowCorrelation) {
      motion.reconstruction_notes.push_back(
          fmt::format("the wrist movements of glove and arm do not match (correlation {:.2f}): "
                      "their clocks could not be compared",
                      offset.correlation));
    }
    return 0;
  }
  if (std::abs(offset.offset_s) < 4 * offset.offset_sd_s) return 0;
  motion.reconstruction_notes.push_back(fmt::format(
      "the glove's clock was {:.3f} s {} the arm's (within {:.3f} s): corrected",
      std::abs(offset.offset_s), offset.offset_s > 0 ? "ahead of" : "behind", offset.offset_sd_s));
  return offset.offset_s;
}

/// Adds hand angles, and fingers if the wrist is tracked.
void add_glove(const Demonstration& demonstration, const TimeGrid& clock,
               const ReconstructOptions& options, const HumanOptions& human, bool arm_tracked,
               HumanMotion& motion) {
  const HandStream& glove = *demonstration.streams.hand;
  const auto& flat_hand = demonstration.calibration.hand;
  if (glove.time.empty() || glove.time.back() < clock.start_s ||
      glove.time.front() > clock.at(clock.count)) {
    motion.reconstruction_notes.push_back("the recordings of glove and arm do not overlap in time");
    return;
  }
  GloveColumns columns =
      resample_glove(glove, flat_hand, 0, clock, options, motion.reconstruction_notes);
  if (options.align_clocks && arm_tracked) {
    const double late_s = glove_clock_offset(columns, clock, options, motion);
    std::vector<std::string> said;
    if (late_s != 0) columns = resample_glove(glove, flat_hand, late_s, clock, options, said);
  }
  pose_fingers(columns, hand_size_of(demonstration, human, motion.estimated), motion);
}

void add_fingertips(const HandStream& hand, const TimeGrid& clock,
                    const ReconstructOptions& options, HumanMotion& motion) {
  std::vector<Vec3> recorded(hand.time.size());
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = hand.position(i, finger);
    const auto tip = resample(hand.time, recorded, clock, options);
    for (std::size_t i = 0; i < tip.size(); ++i) motion.tip(i, finger) = tip[i];
  }
}

}  // namespace

HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human) {
  const std::optional<BodyStream>& sensors = demonstration.streams.sensors;
  const std::optional<HandStream>& hand = demonstration.streams.hand;
  const bool gloved = hand && hand->kind == HandKind::glove;
  // A glove's fingers are attached to the wrist and have no position without it.
  std::vector<const std::vector<double>*> times;
  if (sensors) times.push_back(&sensors->time);
  if (hand && !(gloved && sensors)) times.push_back(&hand->time);
  const TimeGrid clock = make_time_grid(times, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);

  const auto track = [&](const std::string& name) -> std::optional<BodyTrack> {
    if (!sensors) return std::nullopt;
    return joint_of_sensor(demonstration, name, motion.reconstruction_notes);
  };
  const auto shoulder = track("shoulder"), elbow = track("elbow"), wrist = track("wrist");
  if (wrist) {
    motion.wrist = resample(sensors->time, wrist->position, clock, options);
    motion.wrist_orientation = resample(sensors->time, wrist->orientation, clock, options);
  } else {
    motion.reconstruction_notes.push_back("no body named wrist is tracked");
  }
  if (shoulder) motion.shoulder = resample(sensors->time, shoulder->position, clock, options);
  if (elbow) motion.elbow = resample(sensors->time, elbow->position, clock, options);
  estimate_arm(arm_lengths_of(demonstration, human), human, {}, motion);
  if (shoulder && elbow && wrist) {
    enforce_bone_lengths(motion);
    add_arm_angles(motion);
  }
  if (gloved) {
    add_glove(demonstration, clock, options, human, elbow && wrist, motion);
  } else if (hand && hand->kind == HandKind::fingertips) {
    add_fingertips(*hand, clock, options, motion);
  } else if (hand && hand->kind == HandKind::keypoints) {
    add_hand_from_keypoints(*hand, demonstration.hand_length, clock, options, motion);
  } else {
    motion.reconstruction_notes.push_back("no fingertips were recorded");
  }
  return motion;
}

}  // namespace morphe::reconstruct
