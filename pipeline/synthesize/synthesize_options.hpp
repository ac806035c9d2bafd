#pragma once

#include <string>
#include <vector>

namespace morphe::synthesize {

/// A quantity drawn evenly: [from, to].
using FromTo = std::vector<double>;

/// Who: ANSUR II, seated at a table whose top is z = 0.
struct SyntheticSubject {
  double male_share = 0.5;
  FromTo percentiles = {5, 95};           ///< of each measure; 0 and 100 stand for ±4 deviations
  FromTo shoulder_height = {0.25, 0.45};  ///< above the table [m]
};
template <class Fields>
void fields(Fields& f, SyntheticSubject& o) {
  f("male_share", o.male_share);
  f("percentiles", o.percentiles);
  f("shoulder_height", o.shoulder_height);
}
std::string why_invalid(const SyntheticSubject& options);

/// How often a movement is of each kind, in proportion.
struct KindWeights {
  double minimum_jerk = 1;        ///< straight, 10 τ³ - 15 τ⁴ + 6 τ⁵
  double lognormal = 1;           ///< straight, the speed a lognormal in time (sigma-lognormal)
  double asymmetric = 1;          ///< straight, a beta speed with its peak at 30-45 % of the time
  double curved = 1;              ///< minimum jerk in time, 5-12 cm aside of the straight way
  double two_peaks = 1;           ///< the first sub-movement misses, a second corrects it
  double pause_before_grasp = 1;  ///< stops open-handed before the last 5-15 % of the way
  double no_grasp = 1;            ///< touches: the hand does not close, nothing is carried
};
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
std::string why_invalid(const KindWeights& options);

/// What the subject does: reach, grasp, transport, hold, put back, release, return, rest.
struct SyntheticMovements {
  FromTo per_recording = {2, 4};    ///< whole numbers
  FromTo rest_s = {0.6, 2};         ///< before, between and after
  FromTo reach_s = {0.6, 1.2};      ///< whole; of a lognormal: while above 5 % of its peak
  FromTo grasp_s = {0.15, 0.4};     ///< still at the object: before the lift, and before release
  FromTo transport_s = {0.6, 1.1};  ///< there, and back
  FromTo hold_s = {0.3, 0.9};       ///< between the two, or touching
  FromTo return_s = {0.6, 1.2};
  FromTo pause_s = {0.15, 0.4};    ///< of pause_before_grasp
  FromTo distance = {0.15, 0.4};   ///< of the target from the resting wrist, level [m]; less
                                   ///< where the arm does not reach that far
  FromTo direction = {-0.8, 0.6};  ///< 0 forward, positive to the right [rad]
  FromTo height = {0.08, 0.22};    ///< of the wrist at the target, above the table [m]
  FromTo elbow_swivel = {0, 0.5};  ///< outward, as natural_elbow() [rad]
  double reach_share = 0.95;       ///< farthest wrist over upper arm + forearm
  double starts_inside_share = 0;  ///< recordings that begin within their first movement
  double ends_inside_share = 0;    ///< recordings that end within their last
  KindWeights kinds;
};
template <class Fields>
void fields(Fields& f, SyntheticMovements& o) {
  f("per_recording", o.per_recording);
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
  f("starts_inside_share", o.starts_inside_share);
  f("ends_inside_share", o.ends_inside_share);
  f("kinds", o.kinds);
}
std::string why_invalid(const SyntheticMovements& options);

struct SyntheticHand {
  FromTo peak_share = {0.6, 0.74};        ///< of the reach's time: the hand is widest open
  FromTo opening_excess = {0.02, 0.045};  ///< of thumb and index tip beyond the grasp's [m]
  double least_widening = 0.02;           ///< and at least this much beyond the resting hand's [m]
  double pad = 0.008;                     ///< from a finger's axis to its skin [m]
};
template <class Fields>
void fields(Fields& f, SyntheticHand& o) {
  f("peak_share", o.peak_share);
  f("opening_excess", o.opening_excess);
  f("least_widening", o.least_widening);
  f("pad", o.pad);
}
std::string why_invalid(const SyntheticHand& options);

/// An upright cylinder between thumb and index finger.
struct SyntheticObject {
  FromTo radius = {0.018, 0.036};  ///< [m]
  FromTo height = {0.08, 0.14};    ///< [m]
  double recorded_share = 0;       ///< recordings that hold it, tracked as the sensors are
};
template <class Fields>
void fields(Fields& f, SyntheticObject& o) {
  f("radius", o.radius);
  f("height", o.height);
  f("recorded_share", o.recorded_share);
}
std::string why_invalid(const SyntheticObject& options);

/// What the body does unasked.
struct SyntheticBody {
  double tremor = 0;  ///< amplitude at the wrist [m]
  FromTo tremor_hz = {8, 12};
  double drift = 0.001;  ///< of the wrist, slower than 0.3 Hz, rms of each axis [m]
};
template <class Fields>
void fields(Fields& f, SyntheticBody& o) {
  f("tremor", o.tremor);
  f("tremor_hz", o.tremor_hz);
  f("drift", o.drift);
}
std::string why_invalid(const SyntheticBody& options);

/// Polhemus Liberty: shoulder, elbow (on the upper arm), wrist (on the hand).
struct SyntheticSensors {
  double rate_hz = 240;
  FromTo mount = {0.02, 0.06};          ///< from the joint's centre [m]
  double position_noise = 0.00076;      ///< rms of each axis [m]
  double orientation_noise = 0.002618;  ///< rms about each axis: 0.15 degrees [rad]
  double slow_share = 0.5;              ///< of the noise's variance that is slow, the rest white
  double slow_s = 1;                    ///< its time constant (Ornstein-Uhlenbeck) [s]
  double dropout_share = 0;             ///< of each sensor's time
  FromTo dropout_s = {0.02, 0.15};      ///< length of one
  double calibration_s = 2;             ///< of the calibration pose
  double digitising_noise = 0.0005;     ///< of one digitised point, rms of each axis [m]
  int digitised = 5;                    ///< times that each point is
};
template <class Fields>
void fields(Fields& f, SyntheticSensors& o) {
  f("rate_hz", o.rate_hz);
  f("mount", o.mount);
  f("position_noise", o.position_noise);
  f("orientation_noise", o.orientation_noise);
  f("slow_share", o.slow_share);
  f("slow_s", o.slow_s);
  f("dropout_share", o.dropout_share);
  f("dropout_s", o.dropout_s);
  f("calibration_s", o.calibration_s);
  f("digitising_noise", o.digitising_noise);
  f("digitised", o.digitised);
}
std::string why_invalid(const SyntheticSensors& options);

/// CyberGlove II.
struct SyntheticGlove {
  double rate_hz = 90;
  double noise = 0.017453;          ///< rms of each sensor: 1 degree [rad]
  double slow_share = 0.5;          ///< as the sensors'
  double slow_s = 1;                ///< [s]
  double bias = 0.05;               ///< constant, standard deviation over the sensors [rad]
  double quantisation = 0;          ///< step of its readings [rad]; 0: none
  double dropout_share = 0;         ///< of the time, all sensors at once
  FromTo dropout_s = {0.02, 0.15};  ///< length of one
  FromTo clock_offset_s = {0, 0};   ///< its clock reads this much more than the sensors'
};
template <class Fields>
void fields(Fields& f, SyntheticGlove& o) {
  f("rate_hz", o.rate_hz);
  f("noise", o.noise);
  f("slow_share", o.slow_share);
  f("slow_s", o.slow_s);
  f("bias", o.bias);
  f("quantisation", o.quantisation);
  f("dropout_share", o.dropout_share);
  f("dropout_s", o.dropout_s);
  f("clock_offset_s", o.clock_offset_s);
}
std::string why_invalid(const SyntheticGlove& options);

/// A config of `morphe synthesize`.
struct SynthesizeOptions {
  SyntheticSubject subject;
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

}  // namespace morphe::synthesize
