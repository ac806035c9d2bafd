#include "stages/retime/ramped_parameter.hpp"

#include <algorithm>

namespace morphe::retime {

RampedParameter ramp_ends(double clock_length, double ramp_s) {
  // A ramp covers 0.6 of its length in the path parameter.
  const double ramp = std::min(ramp_s, clock_length / 1.2);
  return {ramp, clock_length + 0.8 * ramp};
}

ParameterDerivatives clock_at(const RampedParameter& clock, double w) {
  const bool ending = w > 0.5 * clock.length;
  const double from_end = ending ? clock.length - w : w;
  const double z = from_end / clock.ramp;
  ParameterDerivatives at{from_end - 0.4 * clock.ramp, 1, 0, 0};
  if (z < 1) {
    at.u = clock.ramp * z * z * z * (2 - 2 * z + 0.6 * z * z);
    at.d1 = z * z * (6 - 8 * z + 3 * z * z);
    at.d2 = 12 * z * (1 - z) * (1 - z) / clock.ramp;
    at.d3 = 12 * (1 - z) * (1 - 3 * z) / (clock.ramp * clock.ramp);
  }
  if (ending) {
    at.u = clock.length - 0.8 * clock.ramp - at.u;
    at.d2 = -at.d2;
  }
  return at;
}

void apply_chain_rule(const ParameterDerivatives& at, JointRows& q) {
  q.row(3) = q.row(3) * (at.d1 * at.d1 * at.d1) + q.row(2) * (3 * at.d1 * at.d2) + q.row(1) * at.d3;
  q.row(2) = q.row(2) * (at.d1 * at.d1) + q.row(1) * at.d2;
  q.row(1) *= at.d1;
}

}  // namespace morphe::retime
