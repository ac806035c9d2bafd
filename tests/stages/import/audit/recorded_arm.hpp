#pragma once

#include <string>
#include <vector>

#include "tests/stages/import/audit/recorded_reach.hpp"

namespace morphe::imports {

/// Returns a right arm of five joints that rests for a second, reaches 0.3 m forward and returns,
/// at 100 Hz: the elbow is below the shoulder and a little outside, the thumb is on the inner side.
inline Demonstration recorded_arm(double noise_m = 0.0002) {
  Demonstration recording;
  recording.hand = Side::right;
  BodyStream& arm = recording.streams.skeleton.emplace();
  arm.names = {"right_shoulder", "right_elbow", "right_wrist", "right_thumb_tip",
               "right_index_tip"};
  arm.parents.assign(arm.names.size(), "");
  const std::vector<Vec3> places = {{0.20, 0.00, 0.42},
                                    {0.25, 0.06, 0.15},
                                    {0.18, 0.28, 0.08},
                                    {0.13, 0.36, 0.10},
                                    {0.19, 0.44, 0.07}};
  const double shares[] = {0.05, 0.5, 1, 1, 1.02};
  math::RandomStream noise(7, "recorded arm");
  constexpr std::size_t kRows = 480;
  arm.position = {kRows, places.size(), unknown_point()};
  arm.orientation = {kRows, places.size(), unknown_rotation()};
  for (std::size_t i = 0; i < kRows; ++i) {
    const double t = static_cast<double>(i) / 100;
    const double out = minimum_jerk((t - 1) / 0.9) - minimum_jerk((t - 2.9) / 0.9);
    arm.time.push_back(t);
    for (std::size_t k = 0; k < places.size(); ++k)
      arm.position(i, k) =
          places[k] + out * shares[k] * Vec3(-0.03, 0.3, 0.05) + noise_m * noise.normal_vector3();
  }
  return recording;
}

}  // namespace morphe::imports
