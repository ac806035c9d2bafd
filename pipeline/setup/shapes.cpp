#include "pipeline/setup/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "core/collision/mesh_file.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;
using robot::UrdfShape;

/// Returns the file of package://NAME/PATH (see PackagePaths), or an empty path.
fs::path resolve_package_path(const fs::path& urdf, const std::string& name, const fs::path& path,
                              const PackagePaths& places) {
  if (const auto given = places.packages.find(name); given != places.packages.end())
    return given->second / path;
  for (fs::path folder = fs::absolute(urdf).parent_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    if (folder.filename() == name && fs::exists(folder / path)) return folder / path;
    if (fs::exists(folder / name / path)) return folder / name / path;
    if (fs::exists(folder / path)) return folder / path;
  }
  return {};
}

fs::path resolve_mesh_path(const fs::path& urdf, const std::string& named,
                           const PackagePaths& places) {
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!named.starts_with(scheme)) continue;
    const std::string rest = named.substr(scheme.size());
    const std::size_t slash = rest.find('/');
    if (slash == std::string::npos) return {};
    return resolve_package_path(urdf, rest.substr(0, slash), rest.substr(slash + 1), places);
  }
  fs::path path = named.starts_with("file://") ? named.substr(7) : named;
  if (path.is_relative()) path = urdf.parent_path() / path;
  return path;
}

SceneObject solid(const UrdfShape& shape) {
  SceneObject object;
  object.shape = shape.kind;
  const std::size_t numbers = object.shape == Shape::sphere ? 1
                              : object.shape == Shape::box  ? 3
                                                            : 2;
  object.size.assign(shape.size.data(), shape.size.data() + numbers);
  object.position = {shape.link_from_shape.translation()};
  object.orientation = {Quat(shape.link_from_shape.linear())};
  return object;
}

/// Appends points on a box (its corners), a cylinder (both rims) or a sphere (four parallels).
void add_points(const SceneObject& object, std::vector<Vec3>& points) {
  const Pose pose = make_pose(object.position[0], object.orientation[0]);
  const auto& size = object.size;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2 * std::numbers::pi * (k % 16) / 16;
    const Vec3 rim(std::cos(angle), std::sin(angle), 0);
    Vec3 point = Vec3::Zero();
    if (object.shape == Shape::box) {
      point = 0.5 * Vec3((k & 1 ? 1 : -1) * size[0], (k & 2 ? 1 : -1) * size[1],
                         (k & 4 ? 1 : -1) * size[2]);
    } else if (object.shape == Shape::cylinder) {
      point = size[0] * rim + Vec3(0, 0, (k & 16 ? 0.5 : -0.5) * size[1]);
    } else {
      const double polar = std::numbers::pi * (k / 16 + 1) / 5;
      point = size[0] * (std::sin(polar) * rim + std::cos(polar) * Vec3::UnitZ());
    }
    points.push_back(pose * point);
  }
}

struct Reader {
  const Kinematics& robot;
  const PackagePaths& places;
  LinkShapes found;
  std::set<std::string> noted;

  void note(const std::string& sentence) {
    if (noted.insert(sentence).second) found.notes.push_back(sentence);
  }

  /// Adds a note for a mesh of 5 m or more, or of 1 mm or less: its unit is probably not the metre.
  void note_unusual_size(const fs::path& file, const SceneObject& mesh) {
    Vec3 lower = mesh.vertices.front(), upper = lower;
    for (const Vec3& vertex : mesh.vertices) {
      lower = lower.cwiseMin(vertex);
      upper = upper.cwiseMax(vertex);
    }
    const double extent = (upper - lower).maxCoeff();
    if (extent < 5 && extent > 0.001) return;
    note(fmt::format("{}: is {:.4g} m long; check its scale", file.string(), extent));
  }

  bool read_mesh(const UrdfShape& shape, SceneObject& mesh) {
    const fs::path file = resolve_mesh_path(robot.model->file, shape.mesh, places);
    if (file.empty() || !fs::exists(file)) {
      note(
          fmt::format("{}: mesh '{}' not found, so the link has no shape (give the folder of a "
                      "package with --package NAME=DIR)",
                      robot.model->file.string(), shape.mesh));
      return false;
    }
    const std::string problem = collision::load_raw_mesh(file, mesh);
    if (!problem.empty()) {
      note(problem);
      return false;
    }
    for (Vec3& vertex : mesh.vertices)
      vertex = shape.link_from_shape * Vec3(shape.size.cwiseProduct(vertex));
    if (shape.size.prod() < 0)
      for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    note_unusual_size(file, mesh);
    mesh.position = {Vec3::Zero()};
    mesh.orientation = {Quat::Identity()};
    return true;
  }

  void read(const UrdfShape& shape, int frame) {
    SceneObject object;
    if (shape.kind == Shape::mesh) {
      if (!read_mesh(shape, object)) return;
      auto& points = found.points[frame];
      points.insert(points.end(), object.vertices.begin(), object.vertices.end());
    } else {
      object = solid(shape);
      if (!(object.size[0] > 0)) return;
      add_points(object, found.points[frame]);
    }
    found.shapes_by_frame[frame].push_back(std::move(object));
  }
};

}  // namespace

LinkShapes read_shapes(const Kinematics& robot, const PackagePaths& places) {
  Reader reader{robot, places, {}, {}};
  for (const bool visual : {false, true}) {
    std::set<int> shaped;
    for (const auto& [frame, objects] : reader.found.shapes_by_frame) shaped.insert(frame);
    for (const UrdfShape& shape : robot.model->shapes) {
      const int frame = robot.model->links.at(shape.link);
      if (shape.visual == visual && !shaped.contains(frame)) reader.read(shape, frame);
    }
  }
  return std::move(reader.found);
}

}  // namespace morphe::setup
