#include "stages/import/recording/conventions.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/unit_words.hpp"

namespace morphe::imports {

Eigen::Matrix3d world_from_points(const std::string& axes, const std::string& source) {
  Eigen::Matrix3d world_from_recorded = Eigen::Matrix3d::Zero();
  std::istringstream words(axes);
  int row = 0;
  for (std::string word; words >> word; ++row) {
    const bool negative = word[0] == '-';
    const std::string letter = word.substr(negative || word[0] == '+' ? 1 : 0);
    if (row > 2 || letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') {
      throw InputError(
          fmt::format("{}: axes: must be the recorded axes that point right, forward and up, such "
                      "as 'x y z' or '-z -x y', not '{}'",
                      source, axes));
    }
    world_from_recorded(row, letter[0] - 'x') = negative ? -1 : 1;
  }
  if (row != 3 || world_from_recorded.determinant() == 0) {
    throw InputError(
        fmt::format("{}: axes: must contain each of x, y and z once, not '{}'", source, axes));
  }
  return world_from_recorded;
}

Eigen::Matrix3d world_from_recorded(const std::string& axes, const std::string& source) {
  const Eigen::Matrix3d rotation = world_from_points(axes, source);
  if (rotation.determinant() < 0) {
    throw InputError(fmt::format(
        "{}: axes: '{}' is left-handed; must be right-handed, as the recording has orientations",
        source, axes));
  }
  return rotation;
}

void throw_unknown_axes(const std::string& source, const std::string& why,
                        const std::string& usual) {
  UnresolvedConvention unknown(
      "axes", fmt::format("{}: axes: the file does not state which axes point right, forward and "
                          "up{}; give --axes or `axes:` such as 'x y z'",
                          source, why));
  unknown.likely_value = usual;
  throw unknown;
}

std::string axis_word(const Vec3& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return fmt::format("{}{}", direction[axis] < 0 ? "-" : "", "xyz"[axis]);
}

namespace {

/// Returns the metres in one unit, 0 if the unit is unknown.
double known_metres(const std::string& unit) {
  static const std::map<std::string, double> known = {{"m", 1.0},    {"dm", 0.1},  {"cm", 0.01},
                                                      {"mm", 0.001}, {"um", 1e-6}, {"in", 0.0254},
                                                      {"ft", 0.3048}};
  if (const auto entry = known.find(length_unit(unit)); entry != known.end()) return entry->second;
  double metres = 0;
  const auto [end, error] = std::from_chars(unit.data(), unit.data() + unit.size(), metres);
  const bool usable = error == std::errc() && end == unit.data() + unit.size() && metres > 0 &&
                      std::isfinite(metres);
  return usable ? metres : 0;
}

}  // namespace

double metres_per_unit(const std::string& unit, const std::string& source) {
  const double metres = known_metres(unit);
  if (metres > 0) return metres;
  throw InputError(fmt::format(
      "{}: unit: must be m, cm, mm, in, ft or metres per unit as a positive number, not '{}'",
      source, unit));
}

double resolve_unit_m(const std::string& in_file, const Conventions& conventions,
                      const std::string& source, std::vector<std::string>& reports) {
  const double file_m = known_metres(in_file);
  if (conventions.unit.empty() && file_m == 0) {
    throw UnresolvedConvention(
        "unit", fmt::format("{}: unit: {}; give --unit or `unit:`, such as mm", source,
                            in_file.empty() ? "not in the file"
                                            : fmt::format("'{}' in the file is unknown", in_file)));
  }
  if (conventions.unit.empty()) return file_m;
  const double given_m = metres_per_unit(conventions.unit, source);
  if (!in_file.empty() && given_m != file_m) {
    reports.push_back(
        fmt::format("unit {} in the file; the given {} is used", in_file, conventions.unit));
  }
  return given_m;
}

double resolve_rate_hz(double in_file, const Conventions& conventions, const std::string& source,
                       std::vector<std::string>& reports) {
  const double rate_hz = conventions.rate_hz.value_or(in_file);
  if (!(rate_hz > 0) || !std::isfinite(rate_hz)) {
    throw UnresolvedConvention(
        "rate",
        fmt::format("{}: rate: not in the file; give --rate or `rate_hz:` in frames per second",
                    source));
  }
  if (in_file > 0 && rate_hz != in_file) {
    reports.push_back(
        fmt::format("{} frames per second in the file; the given {} is used", in_file, rate_hz));
  }
  return rate_hz;
}

}  // namespace morphe::imports
