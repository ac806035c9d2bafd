#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

const Chain* find_chain(const Assembly& assembly, const std::string& name) {
  const auto found =
      std::ranges::find_if(assembly.chains, [&](const Chain& c) { return c.name == name; });
  return found == assembly.chains.end() ? nullptr : &*found;
}

/// Returns the possible full names of a name in a file, the prefixed one first.
std::array<std::string, 2> readings(const FileScope& scope, const std::string& name) {
  return {scope.prefix + name, name};
}

}  // namespace

int frame_index(const RobotModel& table, const std::string& name) {
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    if (table.frames[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

bool has_frame_or_chain(const Assembly& assembly, const std::string& name) {
  return frame_index(assembly.table, name) >= 0 || find_chain(assembly, name);
}

int find_frame(const Assembly& assembly, const FileScope& scope, const std::string& name) {
  for (const std::string& reading : readings(scope, name)) {
    if (const auto link = scope.links.find(reading); link != scope.links.end()) return link->second;
    if (const int frame = frame_index(assembly.table, reading); frame >= 0) return frame;
  }
  return -1;
}

bool has_mount_point(const Assembly& assembly, const FileScope& scope, const std::string& name) {
  if (name == "base" || find_frame(assembly, scope, name) >= 0) return true;
  const auto known = readings(scope, name);
  return find_chain(assembly, known[0]) || find_chain(assembly, known[1]);
}

MountPoint find_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& name) {
  const std::string wanted = name.text();
  for (const std::string& reading : readings(scope, wanted)) {
    if (const Chain* chain = find_chain(assembly, reading)) return chain->end;
  }
  if (const int frame = find_frame(assembly, scope, wanted); frame >= 0) return {frame};
  if (wanted == "base") return scope.base;
  name.fail(fmt::format("there is no frame, link or chain '{}'", wanted));
}

MountPoint read_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& node) {
  MountPoint place =
      node.has("parent") ? find_mount_point(assembly, scope, node["parent"]) : scope.base;
  place.frame_from_mount = place.frame_from_mount * read_optional_mount(node);
  return place;
}

int add_frame(Assembly& assembly, const FileScope& scope, const config::ConfigNode& name,
              RobotModel::Frame frame) {
  frame.name = scope.prefix + name.text();
  if (has_frame_or_chain(assembly, frame.name)) {
    name.fail(fmt::format("a frame or chain '{}' already exists", frame.name));
  }
  assembly.table.frames.push_back(std::move(frame));
  return static_cast<int>(assembly.table.frames.size()) - 1;
}

}  // namespace morphe::robot
