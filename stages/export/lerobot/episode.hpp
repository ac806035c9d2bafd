#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::exports {

/// A feature of a LeRobotDataset: a number, or a list of numbers, per frame.
struct Feature {
  std::string name;                ///< without '/'
  std::vector<std::string> names;  ///< of the numbers; their count is the feature's width
  bool is_integer = false;         ///< int64, else float32
};

/// An episode: frames at the times k / fps.
struct Episode {
  std::string task;               ///< in words
  std::vector<JointRows> values;  ///< [frames, width], one per feature; all known
};

}  // namespace morphe::exports
