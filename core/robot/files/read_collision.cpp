#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

/// Returns the file's capsules with that name, or with that prefix if the name ends in `*`.
std::vector<int> capsules_named(const RobotModel& table, const FileScope& scope,
                                const config::ConfigNode& node) {
  const std::string wanted = node.text();
  const auto matches = [&](const std::string& name, const std::string& pattern) {
    if (!pattern.ends_with('*')) return name == pattern;
    return name.starts_with(std::string_view(pattern).substr(0, pattern.size() - 1));
  };
  std::vector<int> found;
  for (std::size_t i = scope.first_capsule; i < table.capsules.size(); ++i) {
    const std::string& name = table.capsules[i].name;
    if (matches(name, scope.prefix + wanted) || matches(name, wanted))
      found.push_back(static_cast<int>(i));
  }
  if (found.empty()) node.fail(fmt::format("there is no capsule '{}'", node.text()));
  return found;
}

void read_capsule(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const MountPoint place = find_mount_point(assembly, scope, node["frame"]);
  RobotModel::Capsule capsule;
  capsule.name = scope.prefix + node["name"].text();
  const auto same = [&](const RobotModel::Capsule& c) { return c.name == capsule.name; };
  if (std::ranges::any_of(assembly.table.capsules, same)) {
    node["name"].fail(fmt::format("a capsule '{}' already exists", capsule.name));
  }
  capsule.frame = place.frame;
  capsule.from = place.frame_from_mount * node["from"].vec3();
  capsule.to = place.frame_from_mount * node["to"].vec3();
  capsule.radius = node["radius"].number();
  if (capsule.radius <= 0) node["radius"].fail("must be above 0");
  assembly.table.capsules.push_back(std::move(capsule));
}

int parent_moving_frame(const RobotModel& table, int body) {
  return body < 0 ? -1 : moving_frame_of(table, table.frames[body].parent);
}

void allow(RobotModel& table, int first, int second) {
  if (first != second)
    table.allowed_collision_pairs.push_back({std::min(first, second), std::max(first, second)});
}

}  // namespace

void read_collision(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  RobotModel& table = assembly.table;
  bool whole = true;
  if (node.has("capsules")) {
    for (const config::ConfigNode& item : node["capsules"].items())
      whole = assembly.problems.attempt([&] { read_capsule(assembly, scope, item); }) && whole;
  }
  if (!whole) return;  // errors in references would only be consequences
  if (node.has("allowed_links")) {
    for (const config::ConfigNode& pair : node["allowed_links"].items()) {
      assembly.problems.attempt([&] {
        const std::vector<config::ConfigNode> names = pair.items();
        if (names.size() != 2) pair.fail("must be a list of two links");
        std::array<int, 2> frames{};
        for (const std::size_t k : {0, 1}) {
          frames[k] = find_frame(assembly, scope, names[k].text());
          if (frames[k] < 0)
            names[k].fail(fmt::format("there is no link or frame '{}'", names[k].text()));
        }
        assembly.allowed_frames.push_back(frames);
      });
    }
  }
  if (node.has("allowed_collision_pairs")) {
    for (const config::ConfigNode& pair : node["allowed_collision_pairs"].items()) {
      assembly.problems.attempt([&] {
        const std::vector<config::ConfigNode> names = pair.items();
        if (names.size() != 2) pair.fail("must be a list of two capsule names");
        for (const int first : capsules_named(table, scope, names[0])) {
          for (const int second : capsules_named(table, scope, names[1]))
            allow(table, first, second);
        }
      });
    }
  }
  if (node.has("may_touch_target")) {
    for (const config::ConfigNode& name : node["may_touch_target"].items()) {
      assembly.problems.attempt([&] {
        for (const int i : capsules_named(table, scope, name)) {
          table.capsules[i].may_touch_target = true;
        }
      });
    }
  }
}

void allow_frames(RobotModel& table, std::size_t first_capsule, int one, int other) {
  for (std::size_t i = first_capsule; i < table.capsules.size(); ++i) {
    if (table.capsules[i].frame != one) continue;
    for (std::size_t j = first_capsule; j < table.capsules.size(); ++j) {
      if (table.capsules[j].frame == other) allow(table, static_cast<int>(i), static_cast<int>(j));
    }
  }
}

void allow_neighbours(RobotModel& table) {
  const int count = static_cast<int>(table.capsules.size());
  for (int i = 0; i < count; ++i) {
    const int first = moving_frame_of(table, table.capsules[i].frame);
    for (int j = i + 1; j < count; ++j) {
      const int second = moving_frame_of(table, table.capsules[j].frame);
      if (first == second || (second >= 0 && parent_moving_frame(table, second) == first) ||
          (first >= 0 && parent_moving_frame(table, first) == second)) {
        allow(table, i, j);
      }
    }
  }
  std::ranges::sort(table.allowed_collision_pairs);
  table.allowed_collision_pairs.erase(
      std::unique(table.allowed_collision_pairs.begin(), table.allowed_collision_pairs.end()),
      table.allowed_collision_pairs.end());
}

}  // namespace morphe::robot
