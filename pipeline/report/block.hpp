#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::report {

/// What a browser unpacks as a whole: JSON, and tables of numbers as bytes (page/README.md has both
/// formats). Numbers are rounded to a multiple of a step: half of it is the greatest error, as long
/// as a value is below 2^40 steps; beyond it is that bound.
class Block {
 public:
  nlohmann::ordered_json json;

  /// The entry of a table: {array: [rows, cols], step, at}.
  nlohmann::ordered_json table(const JointRows& values, double step);
  nlohmann::ordered_json column(const std::vector<double>& values, double step);
  template <class T>
  nlohmann::ordered_json whole_numbers(const std::vector<T>& values) {
    return column({values.begin(), values.end()}, 1);
  }

  /// Base64 of the packed whole.
  std::string packed() const;

 private:
  void add_column(const JointRows& values, Eigen::Index column, double step);

  std::string bytes_;
};

}  // namespace morphe::report
