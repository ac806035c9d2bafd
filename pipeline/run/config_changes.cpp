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
  const std::map<std::string, std::string> old = values_of(before), now = values_of(after);
  std::map<std::string, std::string> all = old;
  all.insert(now.begin(), now.end());
  std::vector<std::string> changes;
  for (const auto& entry : all) {
    const auto a = old.find(entry.first), b = now.find(entry.first);
    const std::string was = a == old.end() ? "none" : a->second;
    const std::string is = b == now.end() ? "none" : b->second;
    if (was != is) changes.push_back(fmt::format("{} {} -> {}", entry.first, was, is));
  }
  return changes;
}

}  // namespace morphe::run
