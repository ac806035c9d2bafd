#include "pipeline/synthesize/synthesize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/human/calibration.hpp"
#include "pipeline/synthesize/calibration_pose.hpp"
#include "pipeline/synthesize/carried_object.hpp"
#include "pipeline/synthesize/ground_truth_labels.hpp"

namespace morphe::synthesize {
namespace {
/// The samples of a script that are recorded, from first to last.
struct SampleRange {
  std::ptrdiff_t first = 0, last = 0;
  std::ptrdiff_t count() const { return last - first + 1; }
};

Streams ground_truth_streams(const MotionSamples& samples, const SampleRange& part) {
  constexpr int kArm = kArmAngleCount;
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
  for (int i = 0; i < part.count(); ++i) {
    const std::ptrdiff_t k = part.first + i;
    const human::ArmPose& pose = samples.arm[k].pose;
    joints.time.push_back(samples.time(i));
    joints.position(i, 0) = pose.shoulder;
    joints.position(i, 1) = pose.elbow;
    joints.position(i, 2) = pose.wrist;
    joints.orientation(i, 2) = pose.world_from_hand;
    auto row = angles.angles.row(i);
    for (int j = 0; j < kArm; ++j) row[j] = samples.arm[k].angles[j];
    row.tail<kHandStateSize>() = samples.hand[k].transpose();
    for (std::size_t finger = 0; finger < kFingerCount; ++finger)
      hand.position(i, finger) = samples.tip(k, finger);
  }
  angles.time = hand.time = joints.time;
  return streams;
}

/// Returns the readings of an ideal glove. They are without tremor, which moves the wrist's
/// position and not its angles.
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

/// Returns the task that a manifest would state; of several kinds of movements it says neither.
std::string task_of(const Script& script) {
  const auto grasping = std::ranges::count(script.movements, true, &ScriptedMovement::grasps);
  if (grasping == std::ssize(script.movements)) return "reach to grasp";
  return grasping == 0 ? "reach" : "several movements";
}

std::string kinds_report(const Script& script) {
  std::string kinds;
  for (const ScriptedMovement& movement : script.movements)
    kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", name_of(movement.kind));
  return "movements: " + kinds;
}

}  // namespace

SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed, std::size_t k) {
  const std::string number = fmt::format("{:06}", k);
  const auto stream = [&](const char* purpose) {
    return math::RandomStream(seed, number + purpose);
  };
  math::RandomStream subject_random = stream("/subject"), script_random = stream("/script"),
                     sensors_random = stream("/sensors"), pose_random = stream("/calibration"),
                     object_random = stream("/object"), dropouts_random = stream("/dropouts");

  const Subject subject = draw_subject(options.subject, subject_random);
  Script script = draw_script(options, subject, script_random);
  const MotionSamples samples = sample_motion(subject, script, options.sensors.rate_hz);
  const SampleRange part = {
      std::lround(std::ceil(script.begin_s * samples.rate_hz)),
      std::min(std::lround(std::floor(script.end_s * samples.rate_hz)), samples.size() - 1)};
  script.begin_s = samples.time(part.first);
  script.end_s = samples.time(part.last);

  SyntheticRecording recording;
  Demonstration& truth = recording.truth;
  truth.name = "synthetic_" + number;
  truth.subject = "subject_" + number;
  truth.task = task_of(script);
  truth.source = fmt::format("synthetic, seed {}", seed);
  truth.hand_length = subject.body.hand.length;
  truth.hand_breadth = subject.body.hand.breadth;
  truth.labels = ground_truth_labels(script, samples);
  truth.import_notes.push_back(kinds_report(script));
  const double clock_offset_s = sensors_random.uniform(options.glove.clock_offset_s);
  truth.import_notes.push_back(fmt::format("the glove's clock is {:.4f} s ahead", clock_offset_s));
  recording.recorded = truth;

  truth.upper_arm = subject.body.arm.upper_arm;
  truth.forearm = subject.body.arm.forearm;
  truth.streams = ground_truth_streams(samples, part);

  const SensorMounts mounts = draw_mounts(options.sensors, sensors_random);
  const GloveBias bias = draw_bias(options.glove, sensors_random);
  recording.recorded.streams = recorded_streams(options, script, samples, part, mounts, bias,
                                                clock_offset_s, sensors_random);
  apply_dropouts(options.sensors, dropouts_random, *recording.recorded.streams.sensors);
  apply_dropouts(options.glove, dropouts_random, *recording.recorded.streams.hand);
  recording.recorded.calibration =
      simulate_calibration(options, subject, script.motion.arm.start, mounts, bias, pose_random);
  recording.recorded.sensor_offsets =
      human::sensor_offsets(recording.recorded.calibration, recording.recorded.import_notes);

  if (object_random.bernoulli(options.object.tracked_object_share)) {
    const double height_m = object_random.uniform(options.object.height);
    truth.objects.push_back(carried_object(script, samples, height_m, part.first, part.last));
    recording.recorded.objects = truth.objects;
    add_noise(options.sensors, object_random, recording.recorded.objects.front());
  }
  return recording;
}

}  // namespace morphe::synthesize
