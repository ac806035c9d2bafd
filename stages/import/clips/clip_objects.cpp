#include "stages/import/clips/clip_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/collision/mesh_file.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;
using files::NpyArray;

constexpr double kSamePosition_m = 1e-6;  ///< tolerance for poses of an object held by both hands

void add_poses(const ClipArrays& clip, const NpyArray& array, std::size_t first, std::size_t count,
               const TrackerFrame& frame, SceneObject& object) {
  for (std::size_t k = 0; k < count; ++k) {
    const Pose pose = clip_pose(clip, array, first + k);
    object.position.push_back(frame.point(pose.translation()));
    object.orientation.push_back(pose.linear().allFinite() ? frame.rotation(Quat(pose.linear()))
                                                           : unknown_rotation());
  }
}

/// Returns an object with the mesh objects/<id>/visual.obj, times `scale`; without it a sphere.
SceneObject shape_of(const std::string& clip_file, const std::string& id, double scale,
                     std::vector<std::string>& reports) {
  const fs::path folder = fs::path(clip_file).parent_path();
  const bool plain = !id.empty() && id.find('/') == std::string::npos && id != "..";
  for (const fs::path& above : {folder, folder / ".."}) {
    const fs::path file = above / "objects" / id / "visual.obj";
    std::error_code error;
    if (!plain || !fs::is_regular_file(file, error)) continue;
    SceneObject mesh;
    mesh.shape = Shape::mesh;
    const std::string fault = collision::load_mesh(file, scale, false, mesh);
    if (!fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), fault));
    mesh.name = id;
    add_note(reports, "object {}: shape from {}", id, file.string());
    return mesh;
  }
  return placeholder_sphere(id, reports);
}

void drop_unseen_instants(SceneObject& object) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < object.time.size(); ++k) {
    if (!is_known(object.position[k]) || !is_known(object.orientation[k])) continue;
    object.time[kept] = object.time[k];
    object.position[kept] = object.position[k];
    object.orientation[kept++] = object.orientation[k];
  }
  object.time.resize(kept);
  object.position.resize(kept);
  object.orientation.resize(kept, Quat::Identity());
}

/// Adds an object if it was ever seen. If another has its name, it becomes "NAME_2", "NAME_3", ….
void add_object(SceneObject object, std::vector<SceneObject>& objects) {
  drop_unseen_instants(object);
  if (object.time.empty()) return;
  const std::string name = object.name;
  const auto is_used = [&] {
    return std::ranges::find(objects, object.name, &SceneObject::name) != objects.end();
  };
  for (int n = 2; is_used(); ++n) object.name = fmt::format("{}_{}", name, n);
  objects.push_back(std::move(object));
}

bool same_path(const SceneObject& a, const SceneObject& b) {
  for (std::size_t k = 0; k < std::min(a.position.size(), b.position.size()); ++k) {
    if ((a.position[k] - b.position[k]).norm() > kSamePosition_m) return false;
  }
  return a.position.size() == b.position.size();
}

void add_handled_object(ClipArrays& clip, Side side, const std::vector<double>& time,
                        const TrackerFrame& frame, std::vector<std::string>& reports,
                        std::vector<SceneObject>& objects) {
  const std::string prefix = fmt::format("obj_{}_", name_of(side));
  const NpyArray* const poses = clip.numbers(prefix + "pose", {time.size(), 4, 4});
  const std::string id = clip.text(prefix + "id").value_or(fmt::format("{}_object", name_of(side)));
  const double scale = clip.number(prefix + "scale").value_or(1);
  if (poses == nullptr) return;
  if (!(scale > 0)) clip.fail(prefix + "scale", "must be positive");
  std::vector<std::string> notes;
  SceneObject object = shape_of(clip.file(), id, scale, notes);
  object.time = time;
  add_poses(clip, *poses, 0, time.size(), frame, object);
  const auto other = std::ranges::find(objects, id, &SceneObject::name);
  if (other != objects.end() && same_path(*other, object)) return;
  reports.insert(reports.end(), notes.begin(), notes.end());
  add_object(std::move(object), objects);
}

void add_context(ClipArrays& clip, const std::vector<double>& time, const TrackerFrame& frame,
                 std::vector<std::string>& reports, std::vector<SceneObject>& objects) {
  const std::vector<std::string> ids = clip.texts("desk_context_ids");
  const NpyArray* const scales = clip.numbers("desk_context_scales", {ids.size()});
  const NpyArray* const poses = clip.numbers("desk_context_poses", {ids.size(), time.size(), 4, 4});
  if (poses == nullptr) return;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const double scale = scales == nullptr ? 1 : scales->values[k];
    if (!(scale > 0)) clip.fail("desk_context_scales", "must be positive");
    SceneObject object = shape_of(clip.file(), ids[k], scale, reports);
    object.time = time;
    add_poses(clip, *poses, k * time.size(), time.size(), frame, object);
    add_object(std::move(object), objects);
  }
}

void add_discs(ClipArrays& clip, const std::vector<double>& time, const TrackerFrame& frame,
               std::vector<SceneObject>& objects) {
  const NpyArray* const discs = clip.numbers("support_discs", {ClipArrays::kAnyLength, 5});
  for (std::size_t k = 0; discs != nullptr && k < discs->shape[0]; ++k) {
    const double* const disc = discs->values.data() + 5 * k;  // x, y, top, radius, height
    SceneObject object;
    object.name = "support";
    object.shape = Shape::cylinder;
    object.size = {frame.unit_m * disc[3], frame.unit_m * disc[4]};
    if (!(object.size[0] > 0 && object.size[1] > 0))
      clip.fail("support_discs", "radius and height must be positive");
    object.time = {time.front()};
    object.position = {frame.point(Vec3(disc[0], disc[1], disc[2] - disc[4] / 2))};
    object.orientation = {frame.rotation(Quat::Identity())};
    add_object(std::move(object), objects);
  }
}

std::size_t size_count(Shape shape) {
  return shape == Shape::sphere ? 1 : shape == Shape::box ? 3 : shape == Shape::mesh ? 0 : 2;
}

void read_mesh(ClipArrays& clip, const std::string& prefix, double metres, SceneObject& object) {
  for (const Vec3& vertex : clip.points(prefix + "vertices", ClipArrays::kAnyLength)) {
    if (!is_known(vertex)) clip.fail(prefix + "vertices", "has a value that is not a number");
    object.vertices.push_back(metres * vertex);
  }
  for (const Vec3& corners : clip.points(prefix + "triangles", ClipArrays::kAnyLength)) {
    for (const double corner : corners) {
      if (!(corner >= 0 && corner < static_cast<double>(object.vertices.size())) ||
          corner != std::floor(corner)) {
        clip.fail(prefix + "triangles",
                  fmt::format("vertex {} does not exist; there are {} vertices", corner,
                              object.vertices.size()));
      }
    }
    object.triangles.emplace_back(corners.cast<int>());
  }
  if (object.triangles.empty()) clip.fail(prefix + "triangles", "a mesh must have triangles");
}

void read_shape(ClipArrays& clip, const std::string& prefix, double metres,
                std::vector<std::string>& reports, SceneObject& object) {
  const bool mesh = clip.has(prefix + "vertices");
  const std::string name = clip.text(prefix + "shape").value_or(mesh ? "mesh" : "");
  if (name.empty()) {
    const SceneObject ball = placeholder_sphere(object.name, reports);
    object.shape = ball.shape;
    object.size = ball.size;
    return;
  }
  const auto shape = enum_from_name<Shape>(name);
  if (!shape) {
    clip.fail(prefix + "shape",
              fmt::format("must be sphere, box, cylinder, capsule or mesh, not '{}'", name));
  }
  object.shape = *shape;
  if (object.shape == Shape::mesh) return read_mesh(clip, prefix, metres, object);
  const NpyArray* const size = clip.numbers(prefix + "size", {size_count(object.shape)});
  if (size == nullptr)
    clip.fail(prefix + "size", fmt::format("is missing; required for a {}", name));
  for (const double length : size->values) {
    if (!(length > 0) || !std::isfinite(length)) clip.fail(prefix + "size", "must be positive");
    object.size.push_back(metres * length);
  }
}

/// Returns an object's own times in seconds. They may not last much longer than the clip.
std::vector<double> own_times(const ClipArrays& clip, const files::NpyArray& times,
                              const ClipClock& clock) {
  constexpr double kMaxDurationRatio = 100;  // chosen by hand: ms, taken for s, last 1000 times
  std::vector<double> seconds;
  for (const double value : times.values) seconds.push_back(clock.seconds * value);
  clip.expect_increasing(times.name, seconds);
  const double clip_s = clock.time.back() - clock.time.front();
  if (!seconds.empty() && seconds.back() - seconds.front() > kMaxDurationRatio * clip_s) {
    clip.fail(times.name, fmt::format("last {:.6g} s, but the clip {:.6g} s; must be in its unit",
                                      seconds.back() - seconds.front(), clip_s));
  }
  return seconds;
}

SceneObject read_object(ClipArrays& clip, const std::string& name, const ClipClock& clock,
                        const TrackerFrame& frame, std::vector<std::string>& reports) {
  const std::vector<double>& time = clock.time;
  const std::string prefix = "object_" + name + "_";
  SceneObject object;
  object.name = name;
  const NpyArray* const poses = clip.numbers(prefix + "pose", {ClipArrays::kAnyLength, 4, 4});
  const std::size_t count = poses->shape[0];
  if (const auto* const times = clip.numbers(prefix + "times", {count})) {
    object.time = own_times(clip, *times, clock);
  } else if (count == time.size()) {
    object.time = time;
  } else if (count == 1) {
    object.time = {time.front()};
  } else {
    clip.fail(prefix + "pose", fmt::format("has {} poses, but the clip has {} frames; give {}times",
                                           count, time.size(), prefix));
  }
  if (count == 0) clip.fail(prefix + "pose", "has no poses");
  add_poses(clip, *poses, 0, count, frame, object);
  read_shape(clip, prefix, frame.unit_m, reports, object);
  return object;
}

}  // namespace

std::vector<SceneObject> read_clip_objects(ClipArrays& clip, const ClipClock& clock,
                                           const TrackerFrame& frame,
                                           std::vector<std::string>& reports) {
  const std::vector<double>& time = clock.time;
  std::vector<SceneObject> objects;
  for (const std::string& name : clip.names_between("object_", "_pose"))
    add_object(read_object(clip, name, clock, frame, reports), objects);
  for (const Side side : {Side::right, Side::left})
    add_handled_object(clip, side, time, frame, reports, objects);
  add_context(clip, time, frame, reports, objects);
  add_discs(clip, time, frame, objects);
  return objects;
}

}  // namespace morphe::imports
