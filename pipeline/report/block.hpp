#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::report {

/// A unit of data that a browser unpacks as a whole: JSON, and tables of numbers as bytes. Both
/// formats are in page/README.md. Numbers are rounded to multiples of a step, and clamped to 2^40
/// steps.
class Block {
 public:
  nlohmann::ordered_json json;

  /// Adds a table. Returns its entry for the JSON: {array: [rows, cols], step, offset}.
  nlohmann::ordered_json table(const JointRows& values, double step);
  /// Adds a table of one column and returns its entry.
  nlohmann::ordered_json column(const std::vector<double>& values, double step);
  /// Adds a column of integers or values of an enumeration and returns its entry.
  template <class T>
  nlohmann::ordered_json integer_column(const std::vector<T>& values) {
    std::vector<double> numbers;
    for (const T value : values) numbers.push_back(static_cast<double>(value));
    return column(numbers, 1);
  }

  /// Returns the packed data in base64.
  std::string to_base64() const;

 private:
  void add_column(const JointRows& values, Eigen::Index column, double step);

  std::string bytes_;
};

}  // namespace morphe::report
