#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace morphe::run {

/// A dataset or an attribute (@name) in which two plans.h5 files differ.
struct Difference {
  std::string plan;     ///< "<demonstration>/<movement>", "" for the whole file
  std::string dataset;  ///< path below the plan or the root; "" if the plan is in one file
  std::optional<double> max_abs;  ///< largest difference of numbers that both files contain
  std::string unit;               ///< of max_abs, as given in the file: "m", "rad or m/s"
  std::string location;           ///< of the largest difference: "sample 31 (0.62 s), E1"
  double first = 0, second = 0;   ///< the two numbers at that location
  std::string change;             ///< another difference, such as "only in the first"
};

/// The differences of two plans.h5 files.
struct DiffReport {
  std::vector<Difference> differences;  ///< in the order of the first file
  std::size_t plans = 0;                ///< number of plans that are in one of the files or both
};

/// Compares every attribute and dataset of two plans.h5 files, bit for bit, except that any NaN
/// equals any other. Throws InputError for a file that is not a plans.h5.
DiffReport diff_files(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace morphe::run
