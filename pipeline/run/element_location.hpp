#pragma once

#include <string>
#include <vector>

#include "core/store/hdf5_file.hpp"

namespace morphe::run {

/// The names of the columns that belong to joints and tips in a plan's datasets.
struct ColumnNames {
  std::vector<std::string> joints, tips;
};
/// Returns the names of the robot in a plans.h5; empty if the file does not contain them.
ColumnNames column_names(const store::Hdf5Group& root);

/// Returns the location of an element in a plan's dataset: "sample 31 (0.62 s), E1" or "frame 3
/// (1.20 s), thumb, x"; "" for a single number. `group` contains the dataset `name`, `path` is its
/// path below the plan, `dims` its shape, and `index` that of the element in row-major order.
std::string element_location(const store::Hdf5Group& group, const std::string& name,
                             const std::string& path, const std::vector<std::size_t>& dims,
                             std::size_t index, const ColumnNames& names);

/// Returns the unit of the attribute `name` of a plan, "" if it has no unit.
std::string unit_of_attribute(const std::string& name);

}  // namespace morphe::run
