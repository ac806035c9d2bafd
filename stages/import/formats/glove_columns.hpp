#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/formats/capture_table.hpp"
#include "stages/import/formats/glove_calibration.hpp"

namespace morphe::imports {

/// Reads the glove of a capture table: the angles of all kGloveSensors [rad], NaN if missing.
/// Reports sensors without a column or any value. `calibration` is by sensor. Throws InputError for
/// raw counts of a sensor that is not in it, and for an angle of more than half a turn.
HandStream read_glove_columns(const files::CsvText& csv, const CaptureColumns& columns,
                              const CaptureTable& rows,
                              const std::map<std::string, SensorCalibration>& calibration,
                              std::vector<std::string>& reports);

}  // namespace morphe::imports
