#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/math/random_stream.hpp"
#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Options of a recorded_reach().
struct ReachOptions {
  double rate_hz = 100, noise_m = 0.0001;
  double duration_s = 0.9;  ///< of the reach, and of the return
};

/// Returns the share of a minimum-jerk movement at a share of its duration.
inline double minimum_jerk(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

/// Returns the markers of an arm at a table that rests for a second, reaches 0.4 m, waits for a
/// second and returns: plates of four on girdle, upper arm, forearm and hand, and two fingertips.
/// The girdle hardly moves, the plates turn, and every coordinate has white noise.
inline Demonstration recorded_reach(const ReachOptions& options = {}) {
  Demonstration recording;
  recording.streams.markers.emplace();
  MarkerStream& markers = *recording.streams.markers;
  struct Part {
    std::string name;
    Vec3 place;
    double share;  ///< of the hand's path
  };
  std::vector<Part> parts = {{"RFTP", {0.28, 0.20, 0.03}, 1.05}, {"RTHUM", {0.22, 0.16, 0.02}, 1}};
  const std::vector<Part> plates = {{"RSHO", {0.15, -0.20, 0.38}, 0.03},
                                    {"RUAR", {0.25, -0.15, 0.20}, 0.4},
                                    {"RLAR", {0.30, -0.05, 0.06}, 0.8},
                                    {"RHAN", {0.28, 0.08, 0.04}, 1}};
  const Vec3 corners[] = {{0, 0, 0}, {0.05, 0.01, 0}, {0.04, 0.05, 0.01}, {-0.01, 0.04, 0.02}};
  for (const Part& plate : plates) {
    for (int k = 0; k < 4; ++k)
      parts.push_back({plate.name + std::to_string(k + 1), plate.place + corners[k], plate.share});
  }
  for (const Part& part : parts) markers.names.push_back(part.name);
  const double end_s = 3 + 2 * options.duration_s;
  const auto rows = static_cast<std::size_t>(end_s * options.rate_hz);
  markers.position = Array2D<Vec3>(rows, parts.size(), unknown_point());
  math::RandomStream noise(5, "recorded reach");
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / options.rate_hz;
    const double out = minimum_jerk((t - 1) / options.duration_s) -
                       minimum_jerk((t - 2 - options.duration_s) / options.duration_s);
    markers.time.push_back(t);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Eigen::AngleAxisd turn(0.5 * out * parts[k].share, Vec3::UnitZ());
      const Vec3 way = out * parts[k].share * Vec3(-0.1, 0.37, 0.1);
      markers.position(i, k) =
          turn * parts[k].place + way + options.noise_m * noise.normal_vector3();
    }
  }
  return recording;
}

/// Returns the column of a marker.
inline std::size_t column(const Demonstration& recording, const std::string& name) {
  const auto& names = recording.streams.markers->names;
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

/// Removes rows [begin, end) from the markers; later rows keep their numbers and so their times
/// move earlier.
inline void lose_rows(std::size_t begin, std::size_t end, MarkerStream& markers) {
  const std::size_t points = markers.names.size();
  auto& values = markers.position.values;
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(begin * points),
               values.begin() + static_cast<std::ptrdiff_t>(end * points));
  markers.position.rows -= end - begin;
  markers.time.resize(markers.position.rows);
}

}  // namespace morphe::imports
