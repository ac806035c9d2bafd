#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace morphe::run {

/// A dataset or an attribute (@name) in which two plans.h5 differ.
struct Difference {
  std::string plan;     ///< "<demonstration>/<movement>", "" for what belongs to the whole file
  std::string dataset;  ///< below the plan, or below the root; "" for the plan as a whole
  std::optional<double> max_abs;  ///< largest difference of two numbers that both are there
  std::string unit;               ///< of max_abs, as the file says: "m", "rad or m/s"
  std::string at;                 ///< where that is: "sample 31 (0.62 s), E1"
  double first = 0, second = 0;   ///< the two numbers there
  std::string change;             ///< a few words, where that does not say it all
};

struct DiffReport {
  std::vector<Difference> differences;  ///< in the order of the first file
  std::size_t plans = 0;                ///< of both files together, each counted once
};

/// Every attribute and every dataset of two plans.h5, bit for bit (any NaN equals any other). A
/// plan of each is in memory at a time. InputError: not such files, or damaged.
DiffReport diff_files(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace morphe::run
