#pragma once

#include <string>
#include <vector>

namespace morphe::synthesize {

/// The interval [from, to] of a uniformly distributed quantity.
using UniformRange = std::vector<double>;

/// The subjects: ANSUR II, seated at a table whose top is z = 0.
struct SyntheticSubject {
  /// The share of male subjects.
  double male_share = 0.5;
  /// The range of percentiles of each measure; 0 and 100 denote ±4 standard deviations.
  UniformRange percentiles = {5, 95};
  /// The height of the shoulder above the table [m].
  UniformRange shoulder_height = {0.25, 0.45};
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticSubject& o) {
  f("male_share", o.male_share);
  f("percentiles", o.percentiles);
  f("shoulder_height", o.shoulder_height);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticSubject& options);

/// The relative frequencies of the kinds of movements.
struct KindWeights {
  double minimum_jerk = 1;        ///< straight, 10 τ³ - 15 τ⁴ + 6 τ⁵
  double lognormal = 1;           ///< straight, with a lognormal speed (sigma-lognormal)
  double asymmetric = 1;          ///< straight, with a beta speed that peaks at 30-45 % of the time
  double curved = 1;              ///< minimum jerk in time, 5-12 cm beside the straight path
  double two_peaks = 1;           ///< a first sub-movement misses, a second corrects it
  double pause_before_grasp = 1;  ///< stops with an open hand before the last 5-15 % of the path
  double no_grasp = 1;            ///< touches only: the hand does not close and carries no object
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, KindWeights& o) {
  f("minimum_jerk", o.minimum_jerk);
  f("lognormal", o.lognormal);
  f("asymmetric", o.asymmetric);
  f("curved", o.curved);
  f("two_peaks", o.two_peaks);
  f("pause_before_grasp", o.pause_before_grasp);
  f("no_grasp", o.no_grasp);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const KindWeights& options);

/// The movements of a subject: reach, grasp, transport, hold, put back, release, return, rest.
struct SyntheticMovements {
  /// The number of movements, an integer.
  UniformRange movements_per_recording = {2, 4};
  /// The duration of rest before, between and after movements [s].
  UniformRange rest_s = {0.6, 2};
  /// The duration of the whole reach [s]; for a lognormal: time above 5 % of its peak.
  UniformRange reach_s = {0.6, 1.2};
  /// The duration of rest at the object, before the lift and before the release [s].
  UniformRange grasp_s = {0.15, 0.4};
  /// The duration of the transport to the lifted position, and back [s].
  UniformRange transport_s = {0.6, 1.1};
  /// The duration of the hold between the two transports, or while touching [s].
  UniformRange hold_s = {0.3, 0.9};
  /// The duration of the return [s].
  UniformRange return_s = {0.6, 1.2};
  /// Duration of the pause of pause_before_grasp [s].
  UniformRange pause_s = {0.15, 0.4};
  /// Horizontal distance of the target from the resting wrist [m], reduced to the reach of the arm.
  UniformRange distance = {0.15, 0.4};
  /// Direction of the target, 0 forward, positive to the right [rad].
  UniformRange direction = {-0.8, 0.6};
  /// Height of the wrist at the target above the table [m].
  UniformRange height = {0.08, 0.22};
  /// Outward swivel angle, as in elbow_from_swivel() [rad].
  UniformRange elbow_swivel = {0, 0.5};
  /// Largest distance of the wrist divided by upper arm + forearm.
  double reach_share = 0.95;
  /// Share of recordings that begin within their first movement.
  double truncated_start_share = 0;
  /// Share of recordings that end within their last movement.
  double truncated_end_share = 0;
  /// The relative frequencies of the kinds.
  KindWeights kinds;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticMovements& o) {
  f("movements_per_recording", o.movements_per_recording);
  f("rest_s", o.rest_s);
  f("reach_s", o.reach_s);
  f("grasp_s", o.grasp_s);
  f("transport_s", o.transport_s);
  f("hold_s", o.hold_s);
  f("return_s", o.return_s);
  f("pause_s", o.pause_s);
  f("distance", o.distance);
  f("direction", o.direction);
  f("height", o.height);
  f("elbow_swivel", o.elbow_swivel);
  f("reach_share", o.reach_share);
  f("truncated_start_share", o.truncated_start_share);
  f("truncated_end_share", o.truncated_end_share);
  f("kinds", o.kinds);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticMovements& options);

/// The motion of the hand.
struct SyntheticHand {
  /// Instant of the largest aperture as a share of the reach's duration.
  UniformRange peak_aperture_time = {0.6, 0.74};
  /// Aperture of thumb and index tip in excess of that at the grasp [m].
  UniformRange peak_aperture_excess = {0.02, 0.045};
  /// Minimum excess of the aperture over that of the resting hand [m].
  double min_aperture_increase = 0.02;
  /// Distance from the axis of a finger to its skin [m].
  double pad_depth = 0.008;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticHand& o) {
  f("peak_aperture_time", o.peak_aperture_time);
  f("peak_aperture_excess", o.peak_aperture_excess);
  f("min_aperture_increase", o.min_aperture_increase);
  f("pad_depth", o.pad_depth);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticHand& options);

/// An upright cylinder between thumb and index finger.
struct SyntheticObject {
  UniformRange radius = {0.018, 0.036};  ///< [m]
  UniformRange height = {0.08, 0.14};    ///< [m]
  double tracked_object_share =
      0;  ///< share of recordings that contain it, tracked like the sensors
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticObject& o) {
  f("radius", o.radius);
  f("height", o.height);
  f("tracked_object_share", o.tracked_object_share);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticObject& options);

/// The involuntary motion of the body.
struct SyntheticBody {
  /// Amplitude of the tremor at the wrist [m].
  double tremor_amplitude = 0;
  /// The frequency of the tremor [Hz].
  UniformRange tremor_hz = {8, 12};
  /// Drift of the wrist, slower than 0.3 Hz, rms of each axis [m].
  double drift = 0.001;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticBody& o) {
  f("tremor_amplitude", o.tremor_amplitude);
  f("tremor_hz", o.tremor_hz);
  f("drift", o.drift);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticBody& options);

/// The sensors of a Polhemus Liberty: shoulder, elbow (on the upper arm), wrist (on the hand).
struct SyntheticSensors {
  /// The sample rate [Hz].
  double rate_hz = 240;
  /// Distance of a sensor from the centre of the joint [m].
  UniformRange sensor_offset = {0.02, 0.06};
  /// Rms of the position noise of each axis [m].
  double position_noise = 0.00076;
  /// Rms of the orientation noise about each axis: 0.15 degrees [rad].
  double orientation_noise = 0.002618;
  /// Share of the slow component in the variance of the noise, the rest is white.
  double correlated_noise_share = 0.5;
  /// Time constant of the slow component (Ornstein-Uhlenbeck) [s].
  double correlation_time_s = 1;
  /// Share of the time lost by each sensor.
  double dropout_share = 0;
  /// Duration of one dropout [s].
  UniformRange dropout_s = {0.02, 0.15};
  /// Duration of the calibration pose [s].
  double calibration_s = 2;
  /// Noise of one digitised point, rms of each axis [m].
  double digitising_noise = 0.0005;
  /// Number of times that each point is digitised.
  int digitisation_count = 5;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticSensors& o) {
  f("rate_hz", o.rate_hz);
  f("sensor_offset", o.sensor_offset);
  f("position_noise", o.position_noise);
  f("orientation_noise", o.orientation_noise);
  f("correlated_noise_share", o.correlated_noise_share);
  f("correlation_time_s", o.correlation_time_s);
  f("dropout_share", o.dropout_share);
  f("dropout_s", o.dropout_s);
  f("calibration_s", o.calibration_s);
  f("digitising_noise", o.digitising_noise);
  f("digitisation_count", o.digitisation_count);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticSensors& options);

/// The sensors of a CyberGlove II.
struct SyntheticGlove {
  /// The sample rate [Hz].
  double rate_hz = 90;
  /// Rms of the noise of each sensor: 1 degree [rad].
  double noise = 0.017453;
  /// Share of the slow component in the variance of the noise, as for the tracker's sensors.
  double correlated_noise_share = 0.5;
  /// Time constant of the slow component [s].
  double correlation_time_s = 1;
  /// Constant error, standard deviation over the sensors [rad].
  double bias = 0.05;
  /// Step of the readings [rad], 0 for no quantisation.
  double quantisation = 0;
  /// Share of the time lost, all sensors at once.
  double dropout_share = 0;
  /// Duration of one dropout [s].
  UniformRange dropout_s = {0.02, 0.15};
  /// Offset of its clock from that of the sensors [s].
  UniformRange clock_offset_s = {0, 0};
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticGlove& o) {
  f("rate_hz", o.rate_hz);
  f("noise", o.noise);
  f("correlated_noise_share", o.correlated_noise_share);
  f("correlation_time_s", o.correlation_time_s);
  f("bias", o.bias);
  f("quantisation", o.quantisation);
  f("dropout_share", o.dropout_share);
  f("dropout_s", o.dropout_s);
  f("clock_offset_s", o.clock_offset_s);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const SyntheticGlove& options);

/// The options of a config of `morphe synthesize`.
struct SynthesizeOptions {
  /// The sections of the config.
  SyntheticSubject subject;
  SyntheticMovements movements;
  SyntheticHand hand;
  SyntheticObject object;
  SyntheticBody body;
  SyntheticSensors sensors;
  SyntheticGlove glove;
};
/// Maps the keys of the config to the fields.
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

}  // namespace morphe::synthesize
