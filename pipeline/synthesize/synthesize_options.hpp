#pragma once

#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"

namespace morphe::synthesize {

/// The interval [from, to] of a uniformly distributed quantity.
using UniformRange = std::vector<double>;

/// The subjects: ANSUR II, seated at a table whose top is z = 0.
struct SyntheticSubject {
  double male_share = 0.5;             ///< probability that a subject is a man
  UniformRange percentiles = {5, 95};  ///< of each measure; 0 and 100 denote ±4 standard deviations
  UniformRange shoulder_height = {0.25, 0.45};  ///< height of the shoulder above the table [m]
};
template <class Fields>
void fields(Fields& f, SyntheticSubject& o) {
  f("male_share", o.male_share, bounds::kShare);
  f("percentiles", o.percentiles, bounds::kPercentile);
  f("shoulder_height", o.shoulder_height, KeyBounds{0.15, 0.5, "m"});
}

/// The relative frequencies of the kinds of movements.
struct KindWeights {
  double minimum_jerk = 1;  ///< straight, 10 τ³ - 15 τ⁴ + 6 τ⁵
  double lognormal = 1;     ///< straight, with a lognormal speed (sigma-lognormal)
  double asymmetric = 1;    ///< straight, with a beta speed that peaks at 30-45 % of the time
  double curved = 1;        ///< minimum jerk in time, halfway 5-12 cm beside the straight path
  double two_peaks = 1;     ///< a first sub-movement misses, a second corrects it
  double pause_before_grasp = 1;  ///< stops with an open hand before the last 5-15 % of the path
  double no_grasp = 1;            ///< touches only: the hand does not close and carries no object
};
template <class Fields>
void fields(Fields& f, KindWeights& o) {
  f("minimum_jerk", o.minimum_jerk, bounds::kWeight);
  f("lognormal", o.lognormal, bounds::kWeight);
  f("asymmetric", o.asymmetric, bounds::kWeight);
  f("curved", o.curved, bounds::kWeight);
  f("two_peaks", o.two_peaks, bounds::kWeight);
  f("pause_before_grasp", o.pause_before_grasp, bounds::kWeight);
  f("no_grasp", o.no_grasp, bounds::kWeight);
}

/// The movements of a subject: reach, grasp, transport, hold, put back, release, return, rest.
struct SyntheticMovements {
  UniformRange movements_per_recording = {2, 4};  ///< integers
  UniformRange rest_s = {0.6, 2};                 ///< before, between and after movements
  UniformRange reach_s = {0.6, 1.2};   ///< without pause; a lognormal: time above 5 % of its peak
  UniformRange grasp_s = {0.15, 0.4};  ///< at the object, before the lift and before the release
  UniformRange transport_s = {0.6, 1.1};  ///< to the lifted position, and back
  UniformRange hold_s = {0.3, 0.9};       ///< between the two transports, or while touching
  UniformRange return_s = {0.6, 1.2};
  UniformRange pause_s = {0.15, 0.4};    ///< of pause_before_grasp
  UniformRange distance = {0.15, 0.4};   ///< of the target, horizontal, from the resting wrist [m]
  UniformRange direction = {-0.8, 0.6};  ///< of the target, 0 forward, positive right [rad]
  UniformRange height = {0.08, 0.22};    ///< of the wrist at the target above the table [m]
  UniformRange elbow_swivel = {0, 0.5};  ///< outward, as in elbow_from_swivel() [rad]
  double reach_share = 0.95;         ///< largest distance shoulder to wrist / (upper arm + forearm)
  double truncated_start_share = 0;  ///< of recordings that begin within a movement
  double truncated_end_share = 0;    ///< of recordings that end within a movement
  KindWeights kinds;
};
template <class Fields>
void fields(Fields& f, SyntheticMovements& o) {
  f("movements_per_recording", o.movements_per_recording, KeyBounds{1, 1000});
  f("rest_s", o.rest_s, KeyBounds{0.3, 60, "s"});
  f("reach_s", o.reach_s, KeyBounds{0.2, 10, "s"});
  f("grasp_s", o.grasp_s, KeyBounds{0.1, 10, "s"});
  f("transport_s", o.transport_s, KeyBounds{0.2, 10, "s"});
  f("hold_s", o.hold_s, KeyBounds{0.1, 60, "s"});
  f("return_s", o.return_s, KeyBounds{0.2, 10, "s"});
  f("pause_s", o.pause_s, KeyBounds{0.05, 5, "s"});
  f("distance", o.distance, KeyBounds{0.08, 0.7, "m"});
  f("direction", o.direction, KeyBounds{-1.571, 1.571, "rad"});
  f("height", o.height, KeyBounds{0.05, 0.6, "m"});
  f("elbow_swivel", o.elbow_swivel, KeyBounds{-0.2, 1, "rad"});
  f("reach_share", o.reach_share, KeyBounds{0.7, 0.98});
  f("truncated_start_share", o.truncated_start_share, bounds::kShare);
  f("truncated_end_share", o.truncated_end_share, bounds::kShare);
  f("kinds", o.kinds);
}

/// The motion of the hand.
struct SyntheticHand {
  UniformRange peak_aperture_time = {0.6, 0.74};      ///< as a share of the duration of the reach
  UniformRange peak_aperture_excess = {0.02, 0.045};  ///< over the aperture of the grasp [m]
  double min_aperture_increase = 0.02;                ///< over the aperture of the resting hand [m]
  double pad_depth = 0.008;  ///< distance from the axis of a finger to its skin [m]
};
template <class Fields>
void fields(Fields& f, SyntheticHand& o) {
  f("peak_aperture_time", o.peak_aperture_time, KeyBounds{0.3, 0.9});
  f("peak_aperture_excess", o.peak_aperture_excess, KeyBounds{0.005, 0.08, "m"});
  f("min_aperture_increase", o.min_aperture_increase, KeyBounds{0.005, 0.06, "m"});
  f("pad_depth", o.pad_depth, KeyBounds{0, 0.015, "m"});
}

/// The object that is grasped: an upright cylinder between thumb and index finger.
struct SyntheticObject {
  UniformRange radius = {0.018, 0.036};  ///< [m]
  UniformRange height = {0.08, 0.14};    ///< [m]
  double tracked_object_share = 0;       ///< of the recordings, in which its pose is tracked
};
template <class Fields>
void fields(Fields& f, SyntheticObject& o) {
  f("radius", o.radius, KeyBounds{0.01, 0.045, "m"});
  f("height", o.height, KeyBounds{0.02, 0.4, "m"});
  f("tracked_object_share", o.tracked_object_share, bounds::kShare);
}

/// The involuntary motion of the body.
struct SyntheticBody {
  double tremor_amplitude = 0;  ///< largest displacement of the wrist [m]
  UniformRange tremor_hz = {8, 12};
  double drift = 0.001;  ///< drift of the wrist, slower than 0.3 Hz, rms of each axis [m]
};
template <class Fields>
void fields(Fields& f, SyntheticBody& o) {
  f("tremor_amplitude", o.tremor_amplitude, KeyBounds{0, 0.01, "m"});
  f("tremor_hz", o.tremor_hz, KeyBounds{3, 30, "Hz"});
  f("drift", o.drift, KeyBounds{0, 0.002, "m"});
}

/// The sensors of a Polhemus Liberty: shoulder, elbow (on the upper arm), wrist (on the hand).
struct SyntheticSensors {
  double rate_hz = 240;
  UniformRange sensor_offset = {0.02, 0.06};  ///< distance from the centre of the joint [m]
  double position_noise = 0.00076;            ///< rms of the position noise of each axis [m]
  double orientation_noise = 0.002618;        ///< rms about each axis: 0.15 degrees [rad]
  /// Share of the slow component (Ornstein-Uhlenbeck) in the variance; the rest is white.
  double correlated_noise_share = 0.5;
  double correlation_time_s = 1;          ///< time constant of the slow component [s]
  double dropout_share = 0;               ///< share of the time lost by each sensor
  UniformRange dropout_s = {0.02, 0.15};  ///< of one dropout
  double calibration_s = 2;               ///< duration of the static recording
  double digitising_noise = 0.0005;       ///< noise of one digitised point, rms of each axis [m]
  int digitisation_count = 5;             ///< number of times that each point is digitised
};
template <class Fields>
void fields(Fields& f, SyntheticSensors& o) {
  f("rate_hz", o.rate_hz, KeyBounds{20, 2000, "Hz"});
  f("sensor_offset", o.sensor_offset, KeyBounds{0, 0.2, "m"});
  f("position_noise", o.position_noise, KeyBounds{0, 0.1, "m"});
  f("orientation_noise", o.orientation_noise, KeyBounds{0, 0.5, "rad"});
  f("correlated_noise_share", o.correlated_noise_share, bounds::kShare);
  f("correlation_time_s", o.correlation_time_s, KeyBounds{0.01, 1000, "s"});
  f("dropout_share", o.dropout_share, KeyBounds{0, 0.9});
  f("dropout_s", o.dropout_s, KeyBounds{0.001, 10, "s"});
  f("calibration_s", o.calibration_s, KeyBounds{0.1, 60, "s"});
  f("digitising_noise", o.digitising_noise, KeyBounds{0, 0.01, "m"});
  f("digitisation_count", o.digitisation_count, KeyBounds{1, 1000});
}

/// The sensors of a CyberGlove II.
struct SyntheticGlove {
  double rate_hz = 90;
  double noise = 0.017453;              ///< rms of the noise of each sensor: 1 degree [rad]
  double correlated_noise_share = 0.5;  ///< share of the slow component in the noise's variance
  double correlation_time_s = 1;        ///< time constant of the slow component [s]
  double bias = 0.05;        ///< constant error, standard deviation over the sensors [rad]
  double quantisation = 0;   ///< step of the readings [rad], 0 for no quantisation
  double dropout_share = 0;  ///< share of the time lost, all sensors at once
  UniformRange dropout_s = {0.02, 0.15};  ///< of one dropout
  UniformRange clock_offset_s = {0, 0};   ///< time on its clock less that on the sensors' clock [s]
};
template <class Fields>
void fields(Fields& f, SyntheticGlove& o) {
  f("rate_hz", o.rate_hz, KeyBounds{5, 2000, "Hz"});
  f("noise", o.noise, KeyBounds{0, 0.5, "rad"});
  f("correlated_noise_share", o.correlated_noise_share, bounds::kShare);
  f("correlation_time_s", o.correlation_time_s, KeyBounds{0.01, 1000, "s"});
  f("bias", o.bias, KeyBounds{0, 1, "rad"});
  f("quantisation", o.quantisation, KeyBounds{0, 0.5, "rad"});
  f("dropout_share", o.dropout_share, KeyBounds{0, 0.9});
  f("dropout_s", o.dropout_s, KeyBounds{0.001, 10, "s"});
  f("clock_offset_s", o.clock_offset_s, KeyBounds{-1, 1, "s"});
}

/// The options of a config of `morphe synthesize`.
struct SynthesizeOptions {
  SyntheticSubject subject;  ///< sections of the config
  SyntheticMovements movements;
  SyntheticHand hand;
  SyntheticObject object;
  SyntheticBody body;
  SyntheticSensors sensors;
  SyntheticGlove glove;
};
template <class Fields>
void fields(Fields& f, SynthesizeOptions& o) {
  f("subject", o.subject);
  f("movements", o.movements);
  f("hand", o.hand);
  f("object", o.object);
  f("body", o.body);
  f("sensors", o.sensors);
  f("glove", o.glove);
}

/// Return a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticSubject& options);
std::string validation_error(const KindWeights& options);
std::string validation_error(const SyntheticMovements& options);
std::string validation_error(const SyntheticHand& options);
std::string validation_error(const SyntheticObject& options);
std::string validation_error(const SyntheticBody& options);
std::string validation_error(const SyntheticSensors& options);
std::string validation_error(const SyntheticGlove& options);

}  // namespace morphe::synthesize
