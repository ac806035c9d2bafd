#include "stages/import/recording/unseen_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/motion/count_with_noun.hpp"

namespace morphe::imports {
namespace {

// Chosen by hand, from the fillers of the trackers and spreadsheets that were looked at: -999,
// -9999, 9999.99, -99999, FLT_MAX, and -1 of hand trackers.
constexpr double kMinNines = 99, kMinIsolatedNines = 999;  ///< [file's unit]
constexpr std::size_t kMinNineDigits = 3;
constexpr double kMaxOtherShare = 0.5;  ///< of all other coordinates, to a filler in one alone
constexpr double kMaxCoordinate = 1e9;  ///< [file's unit] of a place: 1000 km in millimetres
constexpr double kSmallFiller = -1;

/// Returns true if a number is more than 1 % below the next power of ten: its digits are not nines.
bool is_below_nines(double value) {
  double power = 100;
  while (power < value) power *= 10;
  return value < 0.99 * power;
}

/// Returns true if the digits of a number are nines, at least three: 999, -9999, 999.9.
bool is_nines(double value) {
  if (!(std::abs(value) > kMinNines) || std::abs(value) > kMaxCoordinate) return false;
  if (is_below_nines(std::abs(value))) return false;  // nearly all are: text takes long
  std::string digits = fmt::format("{:.6f}", std::abs(value));
  std::erase(digits, '.');
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits.size() >= kMinNineDigits && digits.find_first_not_of('9') == std::string::npos;
}

bool all_equal(const Vec3& point) { return point.x() == point.y() && point.y() == point.z(); }

/// The fillers in a file: how many cells have each, and whether it stands alone among far smaller
/// coordinates.
struct Fillers {
  double unit_m = 1;
  double largest_other = 0;  ///< [file's unit]

  double in_file_unit(double metres) const {
    const double value = metres / unit_m;
    const double rounded = std::round(value * 1e3) / 1e3;  // of a float, times unit_m
    return std::abs(value - rounded) < 1e-7 * std::abs(value) ? rounded : value;
  }
  bool is_filler(double value) const {
    if (std::abs(value) > kMaxCoordinate) return true;
    return is_nines(value) && std::abs(value) >= kMinIsolatedNines &&
           largest_other < kMaxOtherShare * std::abs(value);
  }
};

/// Returns true if a column has a point that is known and not (-1, -1, -1).
std::vector<bool> seen_elsewhere(const Fillers& fillers, const Array2D<Vec3>& position) {
  std::vector<bool> seen(position.cols);
  for (std::size_t i = 0; i < position.values.size(); ++i) {
    const Vec3& point = position.values[i];
    if (is_known(point) && !(all_equal(point) && fillers.in_file_unit(point.x()) == kSmallFiller)) {
      seen[i % position.cols] = true;
    }
  }
  return seen;
}

/// Returns true if the whole point is a filler: three equal coordinates of nines or, if `moves`,
/// -1.
bool is_filler_point(const Fillers& fillers, const Vec3& point, bool moves) {
  if (!all_equal(point)) return false;
  const double value = fillers.in_file_unit(point.x());
  return is_nines(value) || (moves && value == kSmallFiller);
}

double largest_coordinate(const Fillers& fillers, const Array2D<Vec3>& position) {
  double largest = 0;
  for (const Vec3& point : position.values) {
    for (const double metres : point) {
      const double value = fillers.in_file_unit(metres);
      if (is_nines(value) || !(std::abs(value) <= kMaxCoordinate)) continue;
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

void hide_partial_points(Array2D<Vec3>& position, std::vector<std::string>& notes) {
  int hidden = 0;
  for (Vec3& point : position.values) {
    if (!point.hasNaN() || point.array().isNaN().all()) continue;
    point = unknown_point();
    ++hidden;
  }
  if (hidden > 0) {
    notes.push_back(fmt::format("{} {} only some of x, y, z; treated as not visible",
                                count_with_noun(hidden, "point"), hidden == 1 ? "has" : "have"));
  }
}

}  // namespace

void hide_points_at_origin(Array2D<Vec3>& position, std::vector<std::string>& notes) {
  int hidden = 0;
  for (Vec3& point : position.values) {
    if (!point.isZero(0)) continue;
    point = unknown_point();
    ++hidden;
  }
  if (hidden > 0) {
    notes.push_back(
        fmt::format("{} points are exactly at the origin; treated as not visible", hidden));
  }
}

void hide_fillers(double unit_m, Array2D<Vec3>& position, std::vector<std::string>& notes) {
  Fillers fillers{unit_m, 0};
  fillers.largest_other = largest_coordinate(fillers, position);
  const std::vector<bool> seen = seen_elsewhere(fillers, position);
  std::map<double, int> cells;  // by filler
  for (std::size_t i = 0; i < position.values.size(); ++i) {
    Vec3& point = position.values[i];
    const bool whole = is_filler_point(fillers, point, seen[i % position.cols]);
    for (double& metres : point) {
      const double value = fillers.in_file_unit(metres);
      if (!whole && !fillers.is_filler(value)) continue;
      ++cells[value];
      metres = kUnknown;
    }
  }
  for (const auto& [value, count] : cells) {
    notes.push_back(fmt::format("{:.7g} stands in {}; treated as not visible", value,
                                count_with_noun(count, "cell")));
  }
  hide_partial_points(position, notes);
}

}  // namespace morphe::imports
