#include "stages/import/formats/glove_calibration.hpp"

#include <algorithm>

#include "core/config/node.hpp"
#include "core/human/glove.hpp"

namespace morphe::imports {

std::map<std::string, SensorCalibration> read_glove_calibration(const std::filesystem::path& file) {
  const config::ConfigNode root = config::ConfigNode::load(file);
  if (!root.is_map()) root.fail("must map glove sensors to their calibration points");
  std::map<std::string, SensorCalibration> calibration;
  for (const std::string& sensor : root.keys()) {
    const config::ConfigNode node = root[sensor];
    if (std::ranges::find(human::kGloveSensors, sensor) == std::end(human::kGloveSensors))
      node.fail("is not a sensor of a CyberGlove II");
    const SensorCalibration points = {node["raw_low"].number(), node["angle_low"].number(),
                                      node["raw_high"].number(), node["angle_high"].number()};
    if (points.raw_low == points.raw_high) node.fail("raw_low and raw_high must differ");
    calibration[sensor] = points;
  }
  root.require_all_keys_read();
  return calibration;
}

}  // namespace morphe::imports
