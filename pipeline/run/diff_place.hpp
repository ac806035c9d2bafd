#pragma once

#include <string>
#include <vector>

#include "core/store/hdf5_file.hpp"

namespace morphe::run {

/// What the columns of a plan's arrays are called.
struct ColumnNames {
  std::vector<std::string> joints, tips;
};
/// Of the robot in a plans.h5; empty where the file does not say.
ColumnNames column_names(const store::Hdf5Group& root);

/// Where an element of a plan's dataset is: "sample 31 (0.62 s), E1", "frame 3 (1.20 s), thumb, x".
/// `path` is the dataset's below the plan, `index` row-major. "" of a single number.
std::string place_in(const store::Hdf5Group& group, const std::string& name,
                     const std::string& path, const std::vector<std::size_t>& dims,
                     std::size_t index, const ColumnNames& names);

/// The unit of a number that stands as an attribute, "" for one without.
std::string unit_of_attribute(const std::string& name);

}  // namespace morphe::run
