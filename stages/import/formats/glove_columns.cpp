#include "stages/import/formats/glove_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "core/human/glove.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;

}  // namespace

HandStream read_glove_columns(const files::CsvText& csv, const Columns& columns,
                              const CaptureTable& rows,
                              const std::map<std::string, SensorCalibration>& calibration,
                              std::vector<std::string>& reports) {
  using Unit = Columns::GloveSensor::Unit;
  HandStream hand;
  hand.kind = HandKind::glove;
  hand.names.assign(std::begin(human::kGloveSensors), std::end(human::kGloveSensors));
  hand.time = rows.time;
  const auto n = static_cast<Eigen::Index>(rows.time.size());
  hand.angles = JointRows::Constant(n, human::kGloveSensorCount, kUnknown);
  std::vector<std::string> missing(hand.names), never;
  for (const auto& [sensor, column, unit] : columns.glove) {
    const std::string name = human::kGloveSensors[sensor];
    std::erase(missing, name);
    const auto raw = calibration.find(name);
    if (unit == Unit::raw && raw == calibration.end()) {
      csv.fail(
          1, columns.names[column],
          "raw counts need two calibration points; give them in the file of glove_calibration");
    }
    bool once = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double value = rows[i][column];
      if (!std::isfinite(value)) continue;
      once = true;
      const double angle = unit == Unit::raw       ? raw->second.angle(value)
                           : unit == Unit::degrees ? value * std::numbers::pi / 180
                                                   : value;
      if (std::abs(angle) > std::numbers::pi) {
        csv.fail(i + 2, columns.names[column], "is more than 180 degrees; is the unit correct?");
      }
      hand.angles(i, sensor) = angle;
    }
    if (!once) never.push_back(name);
  }
  if (!missing.empty()) {
    reports.push_back(fmt::format("glove sensors without a column: {}", fmt::join(missing, ", ")));
  }
  if (!never.empty()) {
    reports.push_back(fmt::format("glove sensors without any value: {}", fmt::join(never, ", ")));
  }
  return hand;
}

}  // namespace morphe::imports
