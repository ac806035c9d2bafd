#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace morphe::run {

/// A dataset or an attribute (@name) in which two plans.h5 files differ.
struct Difference {
  /// "<demonstration>/<movement>", "" for the whole file.
  std::string plan;
  /// Path below the plan or below the root, "" for the plan as a whole.
  std::string dataset;
  /// Largest difference of two numbers that are present in both files.
  std::optional<double> max_abs;
  /// Unit of max_abs, as given in the file: "m", "rad or m/s".
  std::string unit;
  /// Location of the largest difference: "sample 31 (0.62 s), E1".
  std::string location;
  /// The two numbers at that location.
  double first = 0, second = 0;
  /// Short description, if the numbers do not describe the change completely.
  std::string change;
};

/// The differences of two plans.h5 files.
struct DiffReport {
  std::vector<Difference> differences;  ///< in the order of the first file
  std::size_t plans = 0;  ///< number of plans of both files together, each counted once
};

/// Compares every attribute and every dataset of two plans.h5 files, bit for bit (any NaN equals
/// any other). Only one plan of each file is in memory at a time. Throws InputError if a file is
/// not a plans.h5 or is damaged.
DiffReport diff_files(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace morphe::run
