#include <fmt/format.h>

#include <algorithm>

#include "pipeline/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

const Chain* find_chain(const Assembly& assembly, const std::string& name) {
  const auto found =
      std::ranges::find_if(assembly.chains, [&](const Chain& c) { return c.name == name; });
  return found == assembly.chains.end() ? nullptr : &*found;
}

}  // namespace

int frame_index(const RobotTable& table, const std::string& name) {
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    if (table.frames[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

bool hangs_on(const RobotTable& table, int frame, int ancestor) {
  while (frame >= 0 && frame != ancestor)
    frame = table.frames[static_cast<std::size_t>(frame)].parent;
  return frame == ancestor;
}

bool has_anchor(const Assembly& assembly, const std::string& name) {
  return name == "base" || frame_index(assembly.table, name) >= 0 || find_chain(assembly, name);
}

int frame_called(const Assembly& assembly, const FileScope& scope, const std::string& name) {
  if (const int frame = frame_index(assembly.table, name); frame >= 0) return frame;
  const auto link = scope.links.find(name);
  return link == scope.links.end() ? -1 : link->second.frame;
}

Anchor anchor_named(const Assembly& assembly, const FileScope& scope,
                    const config::ConfigNode& name) {
  const std::string wanted = name.text();
  if (wanted == "base") return scope.base;
  if (const int frame = frame_index(assembly.table, wanted); frame >= 0) return {frame};
  if (const Chain* chain = find_chain(assembly, wanted)) return chain->end;
  if (const auto link = scope.links.find(wanted); link != scope.links.end()) return link->second;
  name.fail(fmt::format("there is no frame or chain '{}'", wanted));
}

Anchor read_hanging(const Assembly& assembly, const FileScope& scope,
                    const config::ConfigNode& node) {
  Anchor place = node.has("parent") ? anchor_named(assembly, scope, node["parent"]) : scope.base;
  place.frame_from_anchor = place.frame_from_anchor * read_mount_of(node);
  return place;
}

int add_frame(Assembly& assembly, const config::ConfigNode& name, RobotTable::Frame frame) {
  frame.name = name.text();
  if (has_anchor(assembly, frame.name)) {
    name.fail(fmt::format("a frame or chain '{}' exists already", frame.name));
  }
  assembly.table.frames.push_back(std::move(frame));
  return static_cast<int>(assembly.table.frames.size()) - 1;
}

}  // namespace morphe::robot
