#include <fmt/format.h>

#include <algorithm>

#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/clock_offset.hpp"
#include "stages/reconstruct/estimated_arm.hpp"
#include "stages/reconstruct/glove_hand.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kWristPitch = 20, kWristYaw = 21;  ///< glove sensors

struct BodyTrack {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
};

std::optional<std::ptrdiff_t> index_of(const std::vector<std::string>& names,
                                       const std::string& name) {
  const std::ptrdiff_t index = std::ranges::find(names, name) - names.begin();
  return index < std::ssize(names) ? std::optional(index) : std::nullopt;
}

/// Returns the joint centre of a sensor and the axes of its segment, as recorded (not filtered):
///   joint = sensor position + sensor orientation * joint_in_sensor
///   axes  = sensor orientation * sensor_from_segment
/// A sensor without offsets is assumed to be at the joint itself, with the axes of the segment,
/// which is reported in `notes` if others have offsets. Returns nullopt if no body has that name.
std::optional<BodyTrack> joint_of_sensor(const Demonstration& demonstration,
                                         const std::string& name, std::vector<std::string>& notes) {
  const BodyStream& sensors = *demonstration.streams.sensors;
  const auto body = index_of(sensors.names, name);
  if (!body) return std::nullopt;
  BodyTrack track;
  for (int i = 0; i < std::ssize(sensors.time); ++i) {
    track.position.push_back(sensors.position(i, *body));
    track.orientation.push_back(sensors.orientation(i, *body));
  }
  if (!demonstration.sensor_offsets) return track;
  const SensorOffsets& offsets = *demonstration.sensor_offsets;
  const auto offset = index_of(offsets.sensors, name);
  if (!offset) {
    notes.push_back("the sensor " + name + " was not calibrated: it is assumed to be at the joint");
    return track;
  }
  for (int i = 0; i < std::ssize(sensors.time); ++i) {
    const Quat world_from_sensor = track.orientation[i];
    track.position[i] += world_from_sensor * offsets.joint_in_sensor[*offset];
    track.orientation[i] = world_from_sensor * offsets.sensor_from_segment[*offset];
  }
  return track;
}

/// Returns flexion f and radial deviation d of the wrist: the forearm's direction in the hand's
/// frame is (-sin f, -sin d cos f, cos d cos f), as in core/human/arm_angles.
std::array<std::vector<double>, 2> wrist_angles(const HumanMotion& motion) {
  std::array<std::vector<double>, 2> angles;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const Vec3 forearm =
        motion.wrist_orientation[i].conjugate() * (motion.wrist[i] - motion.elbow[i]).normalized();
    angles[0].push_back(std::asin(std::clamp(-forearm.x(), -1.0, 1.0)));
    angles[1].push_back(std::atan2(-forearm.y(), forearm.z()));
  }
  return angles;
}

/// Returns the time by which the glove's clock is ahead of the arm's, from the wrist motion that
/// both measure; 0 if it is not reliable or not significant. Signals are low-passed at 3 Hz, above
/// which a wrist moves less than the glove's noise.
double glove_clock_offset(const GloveColumns& glove, const TimeGrid& clock,
                          ReconstructOptions options, HumanMotion& motion) {
  options.cutoff_hz = std::min(options.cutoff_hz, 3.0);
  const auto low_passed = [&](const std::vector<double>& values) {
    return resample(motion.time, values, clock, options);
  };
  const auto [flexion, deviation] = wrist_angles(motion);
  const ClockOffset offset = clock_offset({{low_passed(flexion), low_passed(glove[kWristPitch])},
                                           {low_passed(deviation), low_passed(glove[kWristYaw])}},
                                          clock.rate_hz, options.cutoff_hz);
  if (!is_reliable(offset)) {
    constexpr double kMinWristRate_rad_s = 0.3, kLowCorrelation = 0.5;
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

void add_glove(const Demonstration& demonstration, const TimeGrid& clock,
               const ReconstructOptions& options, const HumanOptions& human, bool arm_tracked,
               HumanMotion& motion) {
  const HandStream& glove = *demonstration.streams.hand;
  const auto& flat_hand = demonstration.calibration.hand;
  std::vector<std::string>& notes = motion.reconstruction_notes;
  const double end_s = clock.at(clock.count);
  if (glove.time.empty() || glove.time.back() < clock.start_s || glove.time.front() > end_s) {
    notes.push_back("the recordings of glove and arm do not overlap in time");
    return;
  }
  GloveColumns columns = resample_glove(glove, flat_hand, 0, clock, options, notes);
  if (options.align_clocks && arm_tracked) {
    const double late_s = glove_clock_offset(columns, clock, options, motion);
    std::vector<std::string> repeated;
    if (late_s != 0) columns = resample_glove(glove, flat_hand, late_s, clock, options, repeated);
  }
  pose_fingers(columns, hand_size_of(demonstration, human, motion.estimated), motion);
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
    std::vector<Vec3> recorded(hand->time.size());
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      for (int i = 0; i < std::ssize(recorded); ++i) recorded[i] = hand->position(i, finger);
      const auto tip = resample(hand->time, recorded, clock, options);
      for (int i = 0; i < std::ssize(tip); ++i) motion.tip(i, finger) = tip[i];
    }
  } else if (hand && hand->kind == HandKind::keypoints) {
    add_hand_from_keypoints(*hand, demonstration.hand_length, clock, options, motion);
  } else {
    motion.reconstruction_notes.push_back("no fingertips were recorded");
  }
  return motion;
}

}  // namespace morphe::reconstruct
