#include "pipeline/run/config_changes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "core/config/node.hpp"

namespace morphe::run {
namespace {

/// Formats a value on one line, in the flow style of YAML.
std::string flow(const config::ConfigNode& node) {
  std::vector<std::string> parts;
  if (node.is_list()) {
    for (const config::ConfigNode& item : node.items()) parts.push_back(flow(item));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (!node.is_map()) return node.is_scalar() ? node.text() : "";
  for (const std::string& key : node.keys())
    parts.push_back(fmt::format("{}: {}", key, flow(node[key])));
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

void flatten(const config::ConfigNode& node, std::map<std::string, std::string>& values) {
  for (const std::string& key : node.keys()) {
    const config::ConfigNode child = node[key];
    if (child.is_map()) {
      flatten(child, values);
    } else {
      values[child.key()] = flow(child);
    }
  }
}

std::map<std::string, std::string> values_of(const std::string& yaml) {
  std::map<std::string, std::string> values;
  flatten(config::ConfigNode::parse(yaml, "effective config"), values);
  return values;
}

}  // namespace

std::vector<std::string> config_changes(const std::string& before, const std::string& after) {
  std::map<std::string, std::pair<std::string, std::string>> values;
  for (const auto& [key, value] : values_of(before)) values[key] = {value, "none"};
  for (const auto& [key, value] : values_of(after))
    values.try_emplace(key, "none", "").first->second.second = value;
  std::vector<std::string> changes;
  for (const auto& [key, sides] : values)
    if (sides.first != sides.second)
      changes.push_back(fmt::format("{} {} -> {}", key, sides.first, sides.second));
  return changes;
}

}  // namespace morphe::run
