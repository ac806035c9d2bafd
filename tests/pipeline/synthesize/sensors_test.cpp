#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/config/fields.hpp"
#include "core/human/glove.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::synthesize {
namespace {

constexpr std::uint64_t kSensorSeed = 11;

SynthesizeOptions without_noise() {
  SynthesizeOptions options;
  options.sensors.position_noise = options.sensors.orientation_noise = 0;
  options.sensors.digitising_noise = 0;
  options.glove.noise = options.glove.bias = 0;
  return options;
}

Demonstration recorded(const SynthesizeOptions& options, std::size_t index) {
  return synthesize(options, kSensorSeed, index).recorded;
}

/// Signals of one sensor each, by their variance and that of their steps.
struct NoiseMeter {
  double squares = 0, steps = 0, last = kUnknown;
  std::size_t n = 0;
  void add(double value) {
    squares += value * value;
    if (!std::isnan(last)) steps += (value - last) * (value - last);
    last = value;
    ++n;
  }
  double rms() const { return std::sqrt(squares / static_cast<double>(n)); }
  /// Half the variance of steps: a white noise's own, and next to nothing of a slow one's.
  double white_rms() const { return std::sqrt(0.5 * steps / static_cast<double>(n)); }
};

TEST(SyntheticSensors, NoiseIsAsConfigured) {
  SynthesizeOptions clean = without_noise(), noisy = clean;
  noisy.sensors.position_noise = 0.00076;
  noisy.sensors.orientation_noise = 0.002618;
  noisy.glove.noise = 0.017453;
  for (SynthesizeOptions* o : {&clean, &noisy}) {
    // Many time constants in a recording.
    o->sensors.correlation_time_s = o->glove.correlation_time_s = 0.1;
    o->sensors.correlated_noise_share = 0.5;
    o->glove.correlated_noise_share = 0.25;
  }
  NoiseMeter position, rotation, glove;
  for (std::size_t i = 0; i < 12; ++i) {
    const Demonstration a = recorded(clean, i);
    const Demonstration b = recorded(noisy, i);
    const BodyStream &still = a.streams.sensors.value(), &moved = b.streams.sensors.value();
    for (std::size_t s = 0; s < 3; ++s) {
      position.last = rotation.last = kUnknown;
      for (std::size_t k = 0; k < still.time.size(); ++k) {
        position.add((moved.position(k, s) - still.position(k, s)).y());
        const Quat turn = still.orientation(k, s).conjugate() * moved.orientation(k, s);
        rotation.add(2 * turn.x() * (turn.w() < 0 ? -1 : 1));
      }
    }
    const JointRows extra = b.streams.hand.value().angles - a.streams.hand.value().angles;
    for (Eigen::Index s = 0; s < extra.cols(); ++s) {
      glove.last = kUnknown;
      for (Eigen::Index k = 0; k < extra.rows(); ++k) {
        glove.add(extra(k, s));
      }
    }
  }
  const auto expect = [](const NoiseMeter& meter, double rms, double white_rms) {
    EXPECT_NEAR(meter.rms(), rms, 0.05 * rms);
    EXPECT_NEAR(meter.white_rms(), white_rms, 0.05 * rms);
  };
  // A slow part of time constant 0.1 s takes steps of its own: 1 - exp(-1 / (0.1 rate)) of it.
  const auto white = [](double rms, double correlated_noise_share, double rate_hz) {
    return rms * std::sqrt(1 - correlated_noise_share +
                           correlated_noise_share * (1 - std::exp(-1 / (0.1 * rate_hz))));
  };
  expect(position, 0.00076, white(0.00076, 0.5, 240));
  expect(rotation, 0.002618, white(0.002618, 0.5, 240));
  expect(glove, 0.017453, white(0.017453, 0.25, 90));
}

TEST(SyntheticSensors, OffsetsOfTheCalibrationLeadToTheJoints) {
  for (std::size_t i = 0; i < 5; ++i) {
    const SyntheticRecording made = synthesize(without_noise(), kSensorSeed, i);
    const BodyStream& sensors = *made.recorded.streams.sensors;
    const BodyStream& joints = *made.truth.streams.sensors;
    const SensorOffsets& offsets = *made.recorded.sensor_offsets;
    ASSERT_THAT(offsets.sensors, testing::ElementsAre("shoulder", "elbow", "wrist"));
    double worst_m = 0, worst_rad = 0;
    for (std::size_t k = 0; k < sensors.time.size(); ++k) {
      for (std::size_t s = 0; s < 3; ++s) {
        const Vec3 joint =
            sensors.position(k, s) + sensors.orientation(k, s) * offsets.joint_in_sensor[s];
        worst_m = std::max(worst_m, (joint - joints.position(k, s)).norm());
      }
      worst_rad = std::max(worst_rad,
                           angle_between(sensors.orientation(k, 2) * offsets.sensor_from_segment[2],
                                         joints.orientation(k, 2)));
    }
    EXPECT_LT(worst_m, 1e-9);
    EXPECT_LT(worst_rad, 1e-7);
    for (const Vec3& offset : offsets.joint_in_sensor) {
      EXPECT_GE(offset.norm(), 0.02 - 1e-9);
      EXPECT_LE(offset.norm(), 0.06 + 1e-9);
    }
  }
}

/// Truth interpolated: the column of arm_angles at a time.
double true_angle(const Demonstration& truth, Eigen::Index column, double t) {
  const AngleStream& stream = *truth.streams.arm_angles;
  const double at = std::clamp(t * 240, 0.0, static_cast<double>(stream.time.size() - 1) - 1e-6);
  const auto i = static_cast<Eigen::Index>(at);
  const double share = at - static_cast<double>(i);
  return (1 - share) * stream.angles(i, column) + share * stream.angles(i + 1, column);
}

TEST(SyntheticGlove, ReadsTheHandOnItsOwnClock) {
  SynthesizeOptions options = without_noise();
  options.glove.clock_offset_s = {0.05, 0.05};
  for (std::size_t i = 0; i < 3; ++i) {
    const SyntheticRecording made = synthesize(options, kSensorSeed, i);
    const HandStream& glove = *made.recorded.streams.hand;
    EXPECT_NEAR(glove.time.front(), 0.05, 1e-12);
    EXPECT_NEAR(glove.time[90] - glove.time[0], 1, 1e-9);
    double worst = 0, worst_wrist = 0;
    for (std::size_t k = 0; k < glove.time.size(); ++k) {
      const double t = glove.time[k] - 0.05;
      const auto row = static_cast<Eigen::Index>(k);
      // IndexMPJ is index_mcp, WristPitch wrist_flexion.
      worst = std::max(worst, std::abs(glove.angles(row, 4) - true_angle(made.truth, 7 + 5, t)));
      worst_wrist =
          std::max(worst_wrist, std::abs(glove.angles(row, 20) - true_angle(made.truth, 5, t)));
    }
    EXPECT_LT(worst, 1e-4);
    EXPECT_LT(worst_wrist, 1e-4);
    EXPECT_THAT(made.truth.import_notes, testing::Contains("the glove's clock is 0.0500 s ahead"));
  }
}

TEST(SyntheticGlove, TheFlatHandShowsItsBias) {
  SynthesizeOptions options = without_noise(), biased = options;
  biased.glove.bias = 0.05;
  const SyntheticRecording a = synthesize(options, kSensorSeed, 2),
                           b = synthesize(biased, kSensorSeed, 2);
  const JointRows shift = b.recorded.streams.hand->angles - a.recorded.streams.hand->angles;
  const JointRows& flat = b.recorded.calibration.hand->angles;
  EXPECT_GT(flat.row(0).norm(), 0.1);
  EXPECT_LT((shift.rowwise() - flat.row(0)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(a.recorded.calibration.hand->angles.cwiseAbs().maxCoeff(), 0);
}

TEST(SyntheticGlove, IsQuantised) {
  SynthesizeOptions options;
  options.glove.quantisation = 0.01;
  const JointRows read = synthesize(options, kSensorSeed, 0).recorded.streams.hand->angles / 0.01;
  EXPECT_LT((read.array() - read.array().round()).abs().maxCoeff(), 1e-9);
}

TEST(SyntheticSensors, DropoutsTakeTheirShareInBursts) {
  SynthesizeOptions options;
  options.sensors.dropout_share = options.glove.dropout_share = 0.05;
  options.sensors.dropout_s = options.glove.dropout_s = {0.05, 0.1};
  double lost = 0, all = 0, glove_lost = 0, glove_all = 0;
  std::size_t bursts = 0;
  for (std::size_t i = 0; i < 25; ++i) {
    const Demonstration made = recorded(options, i);
    const BodyStream& sensors = made.streams.sensors.value();
    const JointRows& glove = made.streams.hand.value().angles;
    for (std::size_t s = 0; s < 3; ++s) {
      for (std::size_t k = 0; k < sensors.time.size(); ++k) {
        const bool gone = !is_known(sensors.position(k, s));
        EXPECT_EQ(gone, !is_known(sensors.orientation(k, s)));
        lost += gone;
        ++all;
        if (k > 0 && gone && is_known(sensors.position(k - 1, s))) ++bursts;
      }
    }
    for (Eigen::Index k = 0; k < glove.rows(); ++k) {
      glove_lost += glove.row(k).array().isNaN().all();
      ++glove_all;
    }
  }
  EXPECT_NEAR(lost / all, 0.05, 0.006);
  EXPECT_NEAR(glove_lost / glove_all, 0.05, 0.01);
  EXPECT_NEAR(lost / 240 / static_cast<double>(bursts), 0.075, 0.01);
}

TEST(SyntheticConfig, WhatIsWrongIsSaidWithItsPlace) {
  const auto message = [](const std::string& text) -> std::string {
    const config::ConfigNode node = config::ConfigNode::parse(text, "c.yaml");
    SynthesizeOptions options;
    try {
      config::read_document(node, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("glove:\n  noise: 1 deg\n"), "");
  EXPECT_THAT(message("glove:\n  noise: -1\n"), testing::StartsWith("c.yaml:2: glove.noise: "));
  EXPECT_THAT(message("movements:\n  reach_s: [1, 0.5]\n"),
              testing::StartsWith("c.yaml:2: movements.reach_s: must be [from, to]"));
  EXPECT_THAT(message("movements: {rest_s: [1]}\n"), testing::HasSubstr("rest_s: must be"));
  EXPECT_THAT(message("movements: {movements_per_recording: [1, 2.5]}\n"),
              testing::HasSubstr("must be whole numbers"));
  EXPECT_THAT(
      message("movements:\n  kinds: {minimum_jerk: 0, lognormal: 0, asymmetric: 0, curved: 0, "
              "two_peaks: 0, pause_before_grasp: 0, no_grasp: 0}\n"),
      testing::StartsWith("c.yaml:2: movements.kinds: at least one kind must have a weight"));
  EXPECT_THAT(message("sensors:\n  rate: 240\n"), testing::StartsWith("c.yaml:2: sensors.rate"));
}

TEST(SyntheticConfig, OptionsAreWrittenAsTheyAreRead) {
  SynthesizeOptions options;
  options.movements.reach_s = {0.7, 0.8};
  options.glove.clock_offset_s = {-0.04, 0.04};
  const std::string text = config::write_options(options);
  SynthesizeOptions again;
  config::read_options(config::ConfigNode::parse(text, "written"), again);
  EXPECT_EQ(config::write_options(again), text);
}

}  // namespace
}  // namespace morphe::synthesize
