#include "stages/import/guess/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/constants.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

void check_points(const std::string& file, const Array2D<Vec3>& position) {
  for (const Vec3& point : position.values) {
    const double coordinate_m = point.cwiseAbs().maxCoeff();
    if (!(coordinate_m > kMaxCoordinate_m)) continue;
    throw UnresolvedConvention(
        "unit", fmt::format("{}: unit: implausible: a point is {:.3g} m from the origin", file,
                            coordinate_m));
  }
}

void check_angles(const std::string& file, const JointRows& angles) {
  for (const double angle : angles.reshaped()) {
    if (!(std::abs(angle) > kMaxAngle_rad)) continue;
    throw InputError(fmt::format("{}: unit: implausible: an angle is {:.3g} rad", file, angle));
  }
}

void check_time(const std::string& file, const std::vector<double>& time) {
  for (int i = 1; i < std::ssize(time); ++i) {
    const double step_s = time[i] - time[i - 1];
    if (!(step_s > kMaxTimeStep_s)) continue;
    throw InputError(
        fmt::format("{}: time: implausible: {:.6g} s between two rows, {:.6g} and {:.6g} s", file,
                    step_s, time[i - 1], time[i]));
  }
}

void check_streams(const std::string& file, const Streams& streams) {
  double begin_s = kInfinity, end_s = -kInfinity;
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
