#include "pipeline/synthesize/synthesize.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/human/calibration.hpp"
#include "pipeline/synthesize/calibration_pose.hpp"
#include "pipeline/synthesize/carried_object.hpp"
#include "pipeline/synthesize/ground_truth_labels.hpp"

namespace morphe::synthesize {
namespace {

/// The samples [first, last] of the script that are recorded.
struct SampleRange {
  std::size_t first = 0, last = 0;
  std::size_t count() const { return last - first + 1; }
};

Streams ground_truth_streams(const MotionSamples& samples, const SampleRange& part) {
  constexpr auto kArm = static_cast<Eigen::Index>(kArmAngleCount);
  Streams streams;
  BodyStream& joints = streams.sensors.emplace();
  joints.names = {"shoulder", "elbow", "wrist"};
  joints.position = Array2D<Vec3>(part.count(), 3, Vec3::Zero());
  joints.orientation = Array2D<Quat>(part.count(), 3, Quat::Identity());
  AngleStream& angles = streams.arm_angles.emplace();
  angles.joints.assign(std::begin(kArmAngleNames), std::end(kArmAngleNames));
  angles.joints.insert(angles.joints.end(), std::begin(kHandAngleNames), std::end(kHandAngleNames));
  angles.joints.emplace_back("palm_arch");
  angles.angles.resize(part.count(), kArm + kHandStateSize);
  HandStream& hand = streams.hand.emplace();
  hand.kind = HandKind::fingertips;
  hand.position = Array2D<Vec3>(part.count(), kFingerCount, Vec3::Zero());
  for (std::size_t i = 0; i < part.count(); ++i) {
    const std::size_t k = part.first + i;
    const human::ArmPose& pose = samples.arm[k].pose;
    joints.time.push_back(samples.time(i));
    joints.position(i, 0) = pose.shoulder;
    joints.position(i, 1) = pose.elbow;
    joints.position(i, 2) = pose.wrist;
    joints.orientation(i, 2) = pose.world_from_hand;
    auto row = angles.angles.row(i);
    for (Eigen::Index j = 0; j < kArm; ++j) {
      row[j] = samples.arm[k].angles[j];
    }
    row.tail<kHandStateSize>() = samples.hand[k].transpose();
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      hand.position(i, finger) = samples.tip(k, finger);
    }
  }
  angles.time = hand.time = joints.time;
  return streams;
}

/// Returns the readings of an ideal glove; tremor moves the position of the wrist, not its angles.
human::GloveAngles ideal_glove(const BodyMotion& motion, double time_s) {
  const ArmState arm = motion.arm.at(time_s);
  return human::encode_glove({hand_angles(motion.hand.at(time_s)), arm[kFlexion], arm[kDeviation]});
}

Streams recorded_streams(const SynthesizeOptions& options, const Script& script,
                         const MotionSamples& samples, const SampleRange& part,
                         const SensorMounts& mounts, const GloveBias& bias, double clock_offset_s,
                         math::RandomStream& random) {
  Streams streams;
  const auto first = samples.arm.begin() + part.first;
  const std::vector<ArmSample> arm(first, first + part.count());
  streams.sensors = simulate_sensors(options.sensors, mounts, arm, random);
  const double begin_s = samples.time(part.first);
  streams.hand = simulate_glove(
      options.glove, bias,
      [&](double time_s) { return ideal_glove(script.motion, begin_s + time_s); },
      samples.time(part.count() - 1), clock_offset_s, random);
  return streams;
}

std::string kinds_report(const Script& script) {
  std::string kinds;
  for (const ScriptedMovement& movement : script.movements) {
    kinds += (kinds.empty() ? "" : ", ");
    kinds += kMovementKindNames[static_cast<std::size_t>(movement.kind)];
  }
  return "movements: " + kinds;
}

}  // namespace

SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed,
                              std::size_t index) {
  const std::string number = fmt::format("{:06}", index);
  const auto stream = [&](const char* purpose) {
    return math::RandomStream(seed, number + purpose);
  };
  math::RandomStream of_subject = stream("/subject"), of_script = stream("/script"),
                     of_sensors = stream("/sensors"), of_calibration = stream("/calibration"),
                     of_object = stream("/object"), of_dropouts = stream("/dropouts");

  const Subject subject = draw_subject(options.subject, of_subject);
  Script script = draw_script(options, subject, of_script);
  const MotionSamples samples = sample_motion(subject, script, options.sensors.rate_hz);
  const SampleRange part = {
      static_cast<std::size_t>(std::ceil(script.begin_s * samples.rate_hz)),
      std::min(static_cast<std::size_t>(script.end_s * samples.rate_hz), samples.size() - 1)};
  script.begin_s = samples.time(part.first);
  script.end_s = samples.time(part.last);

  SyntheticRecording made;
  Demonstration& truth = made.truth;
  truth.name = "synthetic_" + number;
  truth.subject = "subject_" + number;
  truth.task = "reach to grasp";
  truth.source = fmt::format("synthetic, seed {}", seed);
  truth.hand_length = subject.body.hand.length;
  truth.hand_breadth = subject.body.hand.breadth;
  truth.labels = ground_truth_labels(script, samples);
  truth.import_notes.push_back(kinds_report(script));
  const double clock_offset_s = of_sensors.uniform(options.glove.clock_offset_s);
  truth.import_notes.push_back(fmt::format("the glove's clock is {:.4f} s ahead", clock_offset_s));
  made.recorded = truth;

  truth.upper_arm = subject.body.arm.upper_arm;
  truth.forearm = subject.body.arm.forearm;
  truth.streams = ground_truth_streams(samples, part);

  const SensorMounts mounts = draw_mounts(options.sensors, of_sensors);
  const GloveBias bias = draw_bias(options.glove, of_sensors);
  made.recorded.streams =
      recorded_streams(options, script, samples, part, mounts, bias, clock_offset_s, of_sensors);
  drop(options.sensors, of_dropouts, *made.recorded.streams.sensors);
  apply_dropouts(options.glove, of_dropouts, *made.recorded.streams.hand);
  made.recorded.calibration =
      simulate_calibration(options, subject, script.motion.arm.start, mounts, bias, of_calibration);
  made.recorded.sensor_offsets =
      human::sensor_offsets(made.recorded.calibration, made.recorded.import_notes);

  if (of_object.bernoulli(options.object.tracked_object_share)) {
    const double height_m = of_object.uniform(options.object.height);
    truth.objects.push_back(carried_object(script, samples, height_m, part.first, part.last));
    made.recorded.objects = truth.objects;
    add_noise(options.sensors, of_object, made.recorded.objects.front());
  }
  return made;
}

}  // namespace morphe::synthesize
