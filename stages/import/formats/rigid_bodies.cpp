#include "stages/import/formats/rigid_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "stages/import/recording/arm_names.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

constexpr const char* kSensors[] = {"shoulder", "elbow", "wrist"};
constexpr double kMinBodyBoxSize_m = 0.005;  ///< least thickness of a box around markers

/// Appends the bodies in `columns` to those of a stream, which is absent or has the same times.
void add_bodies(const BodyStream& bodies, const std::vector<int>& columns, bool have_parents,
                std::optional<BodyStream>& stream) {
  if (columns.empty()) return;
  std::vector<std::string> names = stream ? stream->names : std::vector<std::string>();
  const std::size_t before = names.size();
  for (const int k : columns) names.push_back(bodies.names[k]);
  BodyStream joined = unseen_body(names, bodies.time.size());
  joined.time = bodies.time;
  if (stream) joined.parents = stream->parents;
  if (have_parents) joined.parents.resize(joined.parents.size() + columns.size());
  for (std::size_t i = 0; i < bodies.time.size(); ++i) {
    for (std::size_t k = 0; k < before; ++k) {
      joined.position(i, k) = stream->position(i, k);
      joined.orientation(i, k) = stream->orientation(i, k);
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      joined.position(i, before + k) = bodies.position(i, columns[k]);
      joined.orientation(i, before + k) = bodies.orientation(i, columns[k]);
    }
  }
  stream = std::move(joined);
}

void add_object(const RigidBodies& bodies, int k, Demonstration& demonstration) {
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
    object.shape_origin = ObjectOrigin::inferred;
    add_note(demonstration.import_notes,
             "object {}: assumed a box of {:.0f} x {:.0f} x {:.0f} mm around the markers of the "
             "rigid body; set `target.body` in a config for another shape",
             name, 1000 * sizes.x(), 1000 * sizes.y(), 1000 * sizes.z());
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
  std::vector<int> joints, sensors;
  std::vector<std::string> used_as_joints;
  for (int k = 0; k < std::ssize(bodies.poses.names); ++k) {
    const std::string& name = bodies.poses.names[k];
    const bool is_joint = bodies.bone[k] || is_joint_name(name);
    if (is_joint || std::ranges::find(kSensors, name) != std::end(kSensors)) {
      (is_joint ? joints : sensors).push_back(k);
      if (!bodies.bone[k]) used_as_joints.push_back(name);
    } else {
      add_object(bodies, k, demonstration);
    }
  }
  add_bodies(bodies.poses, joints, true, demonstration.streams.skeleton);
  add_bodies(bodies.poses, sensors, false, demonstration.streams.sensors);
  if (!used_as_joints.empty()) {
    add_note(demonstration.import_notes,
             "the pivots of these rigid bodies are used as joints, by their names: {}",
             fmt::join(used_as_joints, ", "));
  }
}

}  // namespace morphe::imports
