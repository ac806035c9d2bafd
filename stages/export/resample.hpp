#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::exports {

/// The trajectory at the times k / rate_hz and at its last sample, which ends an interval that may
/// be shorter. Position, velocity and acceleration are those of the quintic that the certificate
/// speaks of; the phase is that of the sample before, demonstration time is linear between samples.
Trajectory resampled(const Trajectory& trajectory, double rate_hz);

/// The first posture held for `delay_s`, and then the trajectory, which must begin at rest.
Trajectory delayed(const Trajectory& trajectory, double delay_s);

/// Why a trajectory cannot wait in its first posture, since it moves there; "" if it can.
std::string why_not_delayed(const RobotTable& robot, const Trajectory& trajectory);

/// Why one trajectory does not go on where another ends, in position, velocity and acceleration;
/// "" if it does, up to rounding.
std::string why_not_joined(const RobotTable& robot, const Trajectory& first,
                           const Trajectory& second);

/// A way to where another motion begins, or from where one ends, exactly: moved by the little that
/// planning left between them, spread over the whole way.
Trajectory ending_at(const Trajectory& way, const Trajectory& next);
Trajectory beginning_at(const Trajectory& way, const Trajectory& before);

/// One after the other, in continuous time; the sample that they share is the second's.
Trajectory joined(const Trajectory& first, const Trajectory& second);

}  // namespace morphe::exports
