#include "stages/import/plausible.hpp"

#include <fmt/format.h>

#include <cmath>

#include "pipeline/motion/input_error.hpp"

namespace morphe {
namespace {

constexpr double kFarthest_m = 1000, kMostTurned = 6 * M_PI;

void check_points(const std::string& file, const Table<Vec3>& position) {
  for (const Vec3& point : position.values) {
    if (!(point.cwiseAbs().maxCoeff() > kFarthest_m)) continue;
    throw InputError(fmt::format("{}: unit: a point is {:.3g} m from the origin", file,
                                 point.cwiseAbs().maxCoeff()));
  }
}

void check_angles(const std::string& file, const JointRows& angles) {
  for (const double angle : angles.reshaped()) {
    if (!(std::abs(angle) > kMostTurned)) continue;
    throw InputError(fmt::format("{}: unit: an angle is {:.3g} rad", file, angle));
  }
}

void check_streams(const std::string& file, const Streams& streams) {
  if (streams.markers) check_points(file, streams.markers->position);
  if (streams.sensors) check_points(file, streams.sensors->position);
  if (streams.skeleton) check_points(file, streams.skeleton->position);
  if (streams.arm_angles) check_angles(file, streams.arm_angles->angles);
  if (!streams.hand) return;
  check_points(file, streams.hand->position);
  check_angles(file, streams.hand->angles);
}

}  // namespace

void check_plausible(const std::string& file, const Demonstration& demonstration) {
  check_streams(file, demonstration.streams);
  check_streams(file, demonstration.calibration);
}

}  // namespace morphe
