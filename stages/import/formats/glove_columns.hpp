#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/formats/capture_table.hpp"
#include "stages/import/formats/glove_calibration.hpp"

namespace morphe::imports {

/// Reads the glove of a capture table, all kGloveSensors in rad: NaN for those missing in the file,
/// which are reported, as are those without a number. Throws InputError for raw counts without
/// calibration and an angle of more than half a turn.
HandStream read_glove_columns(const files::CsvText& csv, const CaptureColumns& columns,
                              const CaptureTable& rows,
                              const std::map<std::string, SensorCalibration>& calibration,
                              std::vector<std::string>& reports);

}  // namespace morphe::imports
