#include "stages/verify/grasp_config.hpp"

#include <charconv>
#include <sstream>

namespace morphe::verify {

std::optional<double> grasp_config_value(const std::string& config, const std::string& key) {
  std::istringstream lines(config);
  bool in_section = false;
  const std::string prefix = "  " + key + ": ";
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ') in_section = line.starts_with("grasp:");
    if (!in_section || !line.starts_with(prefix)) continue;
    double value = 0;
    const char* end = line.data() + line.size();
    const auto parsed = std::from_chars(line.data() + prefix.size(), end, value);
    if (parsed.ec == std::errc() && parsed.ptr == end) return value;
  }
  return std::nullopt;
}

}  // namespace morphe::verify
