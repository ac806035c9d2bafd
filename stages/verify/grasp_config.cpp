#include "stages/verify/grasp_config.hpp"

#include <charconv>
#include <sstream>

namespace morphe::verify {

std::optional<double> grasp_config_value(const std::string& config, const std::string& key) {
  std::istringstream lines(config);
  bool inside = false;
  const std::string begin = "  " + key + ": ";
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ') inside = line.starts_with("grasp:");
    if (!inside || !line.starts_with(begin)) continue;
    double value = 0;
    const char* end = line.data() + line.size();
    const auto read = std::from_chars(line.data() + begin.size(), end, value);
    if (read.ec == std::errc() && read.ptr == end) return value;
  }
  return std::nullopt;
}

}  // namespace morphe::verify
