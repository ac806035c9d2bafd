#include "stages/import/formats/rigid_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

constexpr const char* kSensors[] = {"shoulder", "elbow", "wrist"};
constexpr double kMinBodyBoxSize_m = 0.005;  ///< thickness of a box around markers in a plane [m]

bool is_sensor(const std::string& name) {
  return std::ranges::find(kSensors, name) != std::end(kSensors);
}

/// Appends some of `from`'s columns to those of `to`, which has the same rows or is empty.
void add_columns(const BodyStream& from, const std::vector<std::size_t>& columns, bool parents,
                 std::optional<BodyStream>& to) {
  if (columns.empty()) return;
  BodyStream joined;
  joined.time = from.time;
  if (to) joined.names = to->names, joined.parents = to->parents;
  const std::size_t before = joined.names.size();
  for (const std::size_t k : columns) {
    joined.names.push_back(from.names[k]);
    if (parents) joined.parents.emplace_back();
  }
  joined.position = Array2D<Vec3>(from.time.size(), joined.names.size(), unknown_point());
  joined.orientation = Array2D<Quat>(from.time.size(), joined.names.size(), unknown_rotation());
  for (std::size_t i = 0; i < from.time.size(); ++i) {
    for (std::size_t k = 0; k < before; ++k) {
      joined.position(i, k) = to->position(i, k);
      joined.orientation(i, k) = to->orientation(i, k);
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      joined.position(i, before + k) = from.position(i, columns[k]);
      joined.orientation(i, before + k) = from.orientation(i, columns[k]);
    }
  }
  to = std::move(joined);
}

void add_object(const RigidBodies& bodies, std::size_t k, Demonstration& demonstration) {
  const std::string& name = bodies.poses.names[k];
  SceneObject object;
  Vec3 centre = Vec3::Zero();
  if (bodies.extent[k].isEmpty()) {
    object = placeholder_sphere(name, demonstration.import_notes);
  } else {
    const Vec3 sizes = bodies.extent[k].sizes().cwiseMax(kMinBodyBoxSize_m);
    centre = bodies.extent[k].center();
    object.name = name;
    object.shape = Shape::box;
    object.size = {sizes.x(), sizes.y(), sizes.z()};
    demonstration.import_notes.push_back(
        fmt::format("object {}: assumed a box of {:.0f} x {:.0f} x {:.0f} mm around the markers of "
                    "the rigid body; set `target.body` in a config for another shape",
                    name, 1000 * sizes.x(), 1000 * sizes.y(), 1000 * sizes.z()));
  }
  for (std::size_t i = 0; i < bodies.poses.time.size(); ++i) {
    const Vec3& position = bodies.poses.position(i, k);
    const Quat& orientation = bodies.poses.orientation(i, k);
    if (!is_known(position) || !is_known(orientation)) continue;
    object.time.push_back(bodies.poses.time[i]);
    object.position.push_back(position + orientation * centre);
    object.orientation.push_back(orientation);
  }
  if (object.time.empty()) {
    demonstration.import_notes.back() = fmt::format("rigid body {}: never tracked, skipped", name);
    return;
  }
  demonstration.objects.push_back(std::move(object));
}

}  // namespace

void add_rigid_bodies(const RigidBodies& bodies, Demonstration& demonstration) {
  std::vector<std::size_t> joints, sensors;
  std::vector<std::string> tracked;
  for (std::size_t k = 0; k < bodies.poses.names.size(); ++k) {
    const std::string& name = bodies.poses.names[k];
    if (bodies.bone[k]) {
      joints.push_back(k);
      continue;
    }
    if (is_joint_name(name)) {
      joints.push_back(k);
    } else if (is_sensor(name)) {
      sensors.push_back(k);
    } else {
      add_object(bodies, k, demonstration);
      continue;
    }
    tracked.push_back(name);
  }
  add_columns(bodies.poses, joints, true, demonstration.streams.skeleton);
  add_columns(bodies.poses, sensors, false, demonstration.streams.sensors);
  if (!tracked.empty()) {
    demonstration.import_notes.push_back(
        fmt::format("the pivots of these rigid bodies are used as joints, by their names: {}",
                    fmt::join(tracked, ", ")));
  }
}

}  // namespace morphe::imports
