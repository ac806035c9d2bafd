#include "stages/import/guess/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

constexpr double kMaxDistance_m = 1000, kMaxAngle_rad = 6 * M_PI, kMaxDuration_s = 6 * 3600,
                 kMaxTimeStep_s = 600;

void check_points(const std::string& file, const Array2D<Vec3>& position) {
  for (const Vec3& point : position.values) {
    if (!(point.cwiseAbs().maxCoeff() > kMaxDistance_m)) continue;
    throw UnresolvedConvention(
        "unit", fmt::format("{}: unit: implausible: a point is {:.3g} m from the origin", file,
                            point.cwiseAbs().maxCoeff()));
  }
}

void check_angles(const std::string& file, const JointRows& angles) {
  for (const double angle : angles.reshaped()) {
    if (!(std::abs(angle) > kMaxAngle_rad)) continue;
    throw InputError(fmt::format("{}: unit: implausible: an angle is {:.3g} rad", file, angle));
  }
}

void check_time(const std::string& file, const std::vector<double>& time) {
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] - time[i - 1] > kMaxTimeStep_s) {
      throw InputError(
          fmt::format("{}: time: implausible: {:.6g} s between two rows, {:.6g} and {:.6g} s", file,
                      time[i] - time[i - 1], time[i - 1], time[i]));
    }
  }
}

void check_streams(const std::string& file, const Streams& streams) {
  double begin_s = HUGE_VAL, end_s = -HUGE_VAL;
  const auto check = [&](const auto& stream) {
    if (!stream) return;
    check_time(file, stream->time);
    if (!stream->time.empty()) {
      begin_s = std::min(begin_s, stream->time.front());
      end_s = std::max(end_s, stream->time.back());
    }
    if constexpr (requires { stream->position; }) check_points(file, stream->position);
    if constexpr (requires { stream->angles; }) check_angles(file, stream->angles);
  };
  check(streams.markers);
  check(streams.sensors);
  check(streams.skeleton);
  check(streams.arm_angles);
  check(streams.hand);
  if (end_s - begin_s > kMaxDuration_s) {
    throw InputError(
        fmt::format("{}: time: implausible: the recording lasts {:.6g} s, from {:.6g} to {:.6g}",
                    file, end_s - begin_s, begin_s, end_s));
  }
}

}  // namespace

void check_plausibility(const std::string& file, const Demonstration& demonstration) {
  check_streams(file, demonstration.streams);
  check_streams(file, demonstration.calibration);
}

}  // namespace morphe::imports
