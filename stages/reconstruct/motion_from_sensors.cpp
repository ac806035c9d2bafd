#include <fmt/format.h>

#include <algorithm>

#include "stages/reconstruct/arm_chain.hpp"
#include "stages/reconstruct/clock_offset.hpp"
#include "stages/reconstruct/estimated_arm.hpp"
#include "stages/reconstruct/glove_hand.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/sensor_joints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kWristPitch = 20, kWristYaw = 21;  ///< glove sensors

/// Flexion and radial deviation of the wrist from the forearm's direction in the hand's frame,
/// (-sin f, -sin d cos f, cos d cos f) as in core/human/arm_angles.
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

/// By how much the glove's clock is ahead of the arm's, from what both saw of the wrist; 0 if that
/// does not tell. Below 3 Hz: faster, a wrist moves less than the glove's noise.
double late_by(const GloveColumns& glove, const Clock& clock, ReconstructOptions options,
               HumanMotion& motion) {
  options.cutoff_hz = std::min(options.cutoff_hz, 3.0);
  const auto slowed = [&](const std::vector<double>& values) {
    return on_clock(motion.time, values, clock, options);
  };
  const auto [flexion, deviation] = wrist_angles(motion);
  const ClockOffset offset = clock_offset({{slowed(flexion), slowed(glove[kWristPitch])},
                                           {slowed(deviation), slowed(glove[kWristYaw])}},
                                          clock.rate_hz, options.cutoff_hz);
  if (!clear(offset)) {
    constexpr double kMuch = 0.3, kLittle = 0.5;  // [rad/s]; a correlation
    if (offset.moved > kMuch && offset.correlation < kLittle) {
      motion.problems.push_back(
          fmt::format("the glove's wrist does not move as the arm's does (correlation {:.2f}): "
                      "their clocks could not be compared",
                      offset.correlation));
    }
    return 0;
  }
  if (std::abs(offset.late_s) < 4 * offset.sure_s) return 0;
  motion.problems.push_back(fmt::format(
      "the glove's clock was {:.3f} s {} the arm's (within {:.3f} s): corrected",
      std::abs(offset.late_s), offset.late_s > 0 ? "ahead of" : "behind", offset.sure_s));
  return offset.late_s;
}

/// Hand angles, and fingers at the wrist, if there is one.
void add_glove(const Demonstration& demonstration, const Clock& clock,
               const ReconstructOptions& options, const HumanOptions& human, bool arm_tracked,
               HumanMotion& motion) {
  const HandStream& glove = *demonstration.streams.hand;
  const auto& flat_hand = demonstration.calibration.hand;
  if (glove.time.empty() || glove.time.back() < clock.start_s ||
      glove.time.front() > clock.at(clock.count)) {
    motion.problems.push_back("the glove's clock has no instant in common with the arm's");
    return;
  }
  GloveColumns columns = glove_on_clock(glove, flat_hand, 0, clock, options, motion.problems);
  if (options.align_clocks && arm_tracked) {
    const double late_s = late_by(columns, clock, options, motion);
    std::vector<std::string> said;
    if (late_s != 0) columns = glove_on_clock(glove, flat_hand, late_s, clock, options, said);
  }
  pose_fingers(columns, hand_size_of(demonstration, human, motion.estimated), motion);
}

void add_fingertips(const HandStream& hand, const Clock& clock, const ReconstructOptions& options,
                    HumanMotion& motion) {
  std::vector<Vec3> recorded(hand.time.size());
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = hand.position(i, finger);
    const auto tip = on_clock(hand.time, recorded, clock, options);
    for (std::size_t i = 0; i < tip.size(); ++i) motion.tip(i, finger) = tip[i];
  }
}

}  // namespace

HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human) {
  const std::optional<BodyStream>& sensors = demonstration.streams.sensors;
  const std::optional<HandStream>& hand = demonstration.streams.hand;
  const bool gloved = hand && hand->kind == HandKind::glove;
  // A glove's fingers hang on the wrist: without one they are nowhere.
  std::vector<const std::vector<double>*> times;
  if (sensors) times.push_back(&sensors->time);
  if (hand && !(gloved && sensors)) times.push_back(&hand->time);
  const Clock clock = clock_over(times, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);

  const auto track = [&](const std::string& name) -> std::optional<BodyTrack> {
    if (!sensors) return std::nullopt;
    return joint_of_sensor(demonstration, name, motion.problems);
  };
  const auto shoulder = track("shoulder"), elbow = track("elbow"), wrist = track("wrist");
  if (wrist) {
    motion.wrist = on_clock(sensors->time, wrist->position, clock, options);
    motion.wrist_orientation = on_clock(sensors->time, wrist->orientation, clock, options);
  } else {
    motion.problems.push_back("no body called wrist is tracked");
  }
  if (shoulder) motion.shoulder = on_clock(sensors->time, shoulder->position, clock, options);
  if (elbow) motion.elbow = on_clock(sensors->time, elbow->position, clock, options);
  estimate_arm(arm_lengths_of(demonstration, human), human, {}, motion);
  if (shoulder && elbow && wrist) {
    keep_bone_lengths(motion);
    add_arm_angles(motion);
  }
  if (gloved) {
    add_glove(demonstration, clock, options, human, elbow && wrist, motion);
  } else if (hand && hand->kind == HandKind::fingertips) {
    add_fingertips(*hand, clock, options, motion);
  } else if (hand && hand->kind == HandKind::keypoints) {
    add_hand_from_keypoints(*hand, demonstration.hand_length, clock, options, motion);
  } else {
    motion.problems.push_back("no fingertips were recorded");
  }
  return motion;
}

}  // namespace morphe::reconstruct
