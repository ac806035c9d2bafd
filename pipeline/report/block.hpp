#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::report {

/// A unit of data that a browser unpacks as a whole: JSON, and tables of numbers as bytes
/// (page/README.md describes both formats). Numbers are rounded to a multiple of a step, so the
/// error is at most half a step if a value is below 2^40 steps; larger values are clamped to that
/// bound.
class Block {
 public:
  /// The JSON part.
  nlohmann::ordered_json json;

  /// Adds a table and returns its entry {array: [rows, cols], step, at}.
  nlohmann::ordered_json table(const JointRows& values, double step);
  /// Adds a table of one column and returns its entry.
  nlohmann::ordered_json column(const std::vector<double>& values, double step);
  /// Adds a column of integers and returns its entry.
  template <class T>
  nlohmann::ordered_json integer_column(const std::vector<T>& values) {
    return column({values.begin(), values.end()}, 1);
  }

  /// Returns the packed data in base64.
  std::string to_base64() const;

 private:
  void add_column(const JointRows& values, Eigen::Index column, double step);

  std::string bytes_;
};

}  // namespace morphe::report
