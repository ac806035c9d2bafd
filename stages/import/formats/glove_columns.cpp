#include "stages/import/formats/glove_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "core/human/glove.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {

HandStream read_glove_columns(const files::CsvText& csv, const CaptureColumns& columns,
                              const CaptureTable& rows,
                              const std::map<std::string, SensorCalibration>& calibration,
                              std::vector<std::string>& reports) {
  using Unit = CaptureColumns::GloveSensor::Unit;
  HandStream hand;
  hand.kind = HandKind::glove;
  hand.names.assign(std::begin(human::kGloveSensors), std::end(human::kGloveSensors));
  hand.time = rows.time;
  hand.angles = JointRows::Constant(std::ssize(rows.time), human::kGloveSensorCount, kUnknown);
  std::vector<std::string> without_column(hand.names), without_value;
  for (const auto& [sensor, column, unit] : columns.glove) {
    const std::string name = human::kGloveSensors[sensor];
    std::erase(without_column, name);
    const auto points = calibration.find(name);
    if (unit == Unit::raw && points == calibration.end()) {
      csv.fail(
          1, columns.names[column],
          "raw counts need two calibration points; give them in the file of glove_calibration");
    }
    bool has_value = false;
    for (Eigen::Index i = 0; i < hand.angles.rows(); ++i) {
      const double value = rows[i][column];
      if (!std::isfinite(value)) continue;
      has_value = true;
      const double angle = unit == Unit::raw       ? points->second.angle(value)
                           : unit == Unit::degrees ? value * std::numbers::pi / 180
                                                   : value;
      if (std::abs(angle) > std::numbers::pi)
        csv.fail(i + 2, columns.names[column], "is more than 180 degrees; is the unit correct?");
      hand.angles(i, sensor) = angle;
    }
    if (!has_value) without_value.push_back(name);
  }
  if (!without_column.empty())
    add_note(reports, "glove sensors without a column: {}", fmt::join(without_column, ", "));
  if (!without_value.empty())
    add_note(reports, "glove sensors without any value: {}", fmt::join(without_value, ", "));
  return hand;
}

}  // namespace morphe::imports
