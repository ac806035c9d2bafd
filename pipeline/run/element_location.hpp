#pragma once

#include <string>
#include <vector>

#include "core/store/hdf5_file.hpp"

namespace morphe::run {

/// The names of the columns of a plan's arrays.
struct ColumnNames {
  /// The names of the joints and of the fingertips.
  std::vector<std::string> joints, tips;
};
/// Returns the names for the robot in a plans.h5, empty if the file does not contain them.
ColumnNames column_names(const store::Hdf5Group& root);

/// Returns the location of an element of a plan's dataset: "sample 31 (0.62 s), E1", "frame 3 (1.20
/// s), thumb, x". `path` is the path of the dataset below the plan, `index` is row-major. Returns
/// "" for a single number.
std::string element_location(const store::Hdf5Group& group, const std::string& name,
                             const std::string& path, const std::vector<std::size_t>& dims,
                             std::size_t index, const ColumnNames& names);

/// Returns the unit of a number stored as an attribute, "" if it has no unit.
std::string unit_of_attribute(const std::string& name);

}  // namespace morphe::run
