#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

/// Returns the capsules of the file and its parts with that name; if it ends in `*`, those whose
/// names begin with the rest.
std::vector<int> capsules_named(const RobotModel& table, const FileScope& scope,
                                const config::ConfigNode& node) {
  const std::string pattern = node.text();
  const auto matches = [](const std::string& name, const std::string& full_pattern) {
    if (!full_pattern.ends_with('*')) return name == full_pattern;
    return name.starts_with(full_pattern.substr(0, full_pattern.size() - 1));
  };
  std::vector<int> capsules;
  for (int i = 0; i < std::ssize(table.capsules); ++i) {
    const std::string& name = table.capsules[i].name;
    if (i >= scope.first_capsule &&
        (matches(name, scope.prefix + pattern) || matches(name, pattern))) {
      capsules.push_back(i);
    }
  }
  if (capsules.empty()) node.fail(fmt::format("there is no capsule '{}'", pattern));
  return capsules;
}

void read_capsule(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const MountPoint mount = find_mount_point(assembly, scope, node["frame"]);
  RobotModel::Capsule capsule;
  capsule.name = scope.prefix + node["name"].text();
  if (std::ranges::count(assembly.table.capsules, capsule.name, &RobotModel::Capsule::name) > 0)
    node["name"].fail(fmt::format("a capsule '{}' already exists", capsule.name));
  capsule.frame = mount.frame;
  capsule.from = mount.frame_from_mount * node["from"].vec3(bounds::kCoordinate);
  capsule.to = mount.frame_from_mount * node["to"].vec3(bounds::kCoordinate);
  capsule.radius = node["radius"].number(bounds::kPositiveLength);
  assembly.table.capsules.push_back(std::move(capsule));
}

/// Returns the moving frame to which the joint of the moving frame `body` connects it; -1 = base.
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
  bool all_read = true;
  for (const config::ConfigNode& item : optional_items(node, "capsules"))
    all_read &= assembly.problems.attempt([&] { read_capsule(assembly, scope, item); });
  if (!all_read) return;  // errors in references would only be consequences
  for (const config::ConfigNode& pair : optional_items(node, "allowed_links")) {
    assembly.problems.attempt([&] {
      const std::vector<config::ConfigNode> names = pair.items();
      if (names.size() != 2) pair.fail("must be a list of two links");
      std::array<int, 2> frames{};
      for (const int k : {0, 1}) {
        frames[k] = find_frame(assembly, scope, names[k].text());
        if (frames[k] < 0)
          names[k].fail(fmt::format("there is no link or frame '{}'", names[k].text()));
      }
      assembly.allowed_frames.push_back(frames);
    });
  }
  for (const config::ConfigNode& pair : optional_items(node, "allowed_collision_pairs")) {
    assembly.problems.attempt([&] {
      const std::vector<config::ConfigNode> names = pair.items();
      if (names.size() != 2) pair.fail("must be a list of two capsule names");
      for (const int first : capsules_named(table, scope, names[0])) {
        for (const int second : capsules_named(table, scope, names[1])) allow(table, first, second);
      }
    });
  }
  for (const config::ConfigNode& name : optional_items(node, "may_touch_target")) {
    assembly.problems.attempt([&] {
      for (const int i : capsules_named(table, scope, name))
        table.capsules[i].may_touch_target = true;
    });
  }
}

void allow_frames(RobotModel& table, int one, int other) {
  for (int i = 0; i < std::ssize(table.capsules); ++i) {
    if (table.capsules[i].frame != one) continue;
    for (int j = 0; j < std::ssize(table.capsules); ++j) {
      if (table.capsules[j].frame == other) allow(table, i, j);
    }
  }
}

void allow_neighbours(RobotModel& table) {
  for (int i = 0; i < std::ssize(table.capsules); ++i) {
    const int first = moving_frame_of(table, table.capsules[i].frame);
    for (int j = i + 1; j < std::ssize(table.capsules); ++j) {
      const int second = moving_frame_of(table, table.capsules[j].frame);
      if (first == second || (second >= 0 && parent_moving_frame(table, second) == first) ||
          (first >= 0 && parent_moving_frame(table, first) == second)) {
        allow(table, i, j);
      }
    }
  }
  auto& pairs = table.allowed_collision_pairs;
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace morphe::robot
