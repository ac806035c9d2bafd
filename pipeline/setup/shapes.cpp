#include "pipeline/setup/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "core/collision/mesh_file.hpp"
#include "core/motion/count_with_noun.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;
using robot::UrdfShape;

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

/// Names of the same kind: the first one, and how many different ones there are.
struct NameGroup {
  std::set<std::string> names;
  std::string first;

  void add(const std::string& name) {
    if (names.empty()) first = name;
    names.insert(name);
  }
};

struct Reader {
  const Kinematics& robot;
  const PackagePaths& places;
  LinkShapes found = {};
  std::map<std::string, NameGroup> missing = {};   ///< meshes that do not exist, by package
  std::map<std::string, NameGroup> problems = {};  ///< files that cannot be read, by problem
  NameGroup by_tail = {};                          ///< meshes that were not where they should be
  std::string tail_example = {};
  std::set<std::string> noted = {};

  void note(const std::string& sentence) {
    if (noted.insert(sentence).second) found.notes.push_back(sentence);
  }

  void note_missing(const std::string& package, const NameGroup& group) {
    const std::string advice =
        package.empty()
            ? ""
            : fmt::format("; give the folder of the package: --package {}=DIR", package);
    note(fmt::format(
        "{}: {} not found, so the link{} no shape: {}'{}'{}", robot.model->file.string(),
        group.names.size() == 1 ? "a mesh was"
                                : fmt::format("{} meshes{} were", group.names.size(),
                                              package.empty() ? "" : " of package " + package),
        group.names.size() == 1 ? " has" : "s have", group.names.size() == 1 ? "" : "first ",
        group.first, advice));
  }

  /// Adds one note for each kind of problem with files.
  void note_problems() {
    for (const auto& [package, group] : missing) note_missing(package, group);
    for (const auto& [problem, group] : problems) {
      note(group.names.size() == 1
               ? group.first + problem
               : fmt::format("{} and {}{}", group.first,
                             count_with_noun(group.names.size() - 1, "other mesh", "other meshes"),
                             problem));
    }
    if (by_tail.names.empty()) return;
    note(fmt::format("{}: {} found by the end of {} path: {}", robot.model->file.string(),
                     count_with_noun(by_tail.names.size(), "mesh was", "meshes were"),
                     by_tail.names.size() == 1 ? "its" : "their", tail_example));
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
    const MeshPlace place = find_mesh(robot.model->file, shape.mesh, places);
    const fs::path& file = place.file;
    if (file.empty()) {
      missing[place.package].add(shape.mesh);
      return false;
    }
    if (place.by_tail) {
      by_tail.add(shape.mesh);
      if (tail_example.empty())
        tail_example = fmt::format("'{}' is taken to be {}", shape.mesh, file.string());
    }
    const std::string problem = collision::load_raw_mesh(file, mesh);
    if (!problem.empty()) {
      problems[problem.substr(file.string().size())].add(file.string());
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
  Reader reader{robot, places};
  for (const bool visual : {false, true}) {
    std::set<int> shaped;
    for (const auto& [frame, objects] : reader.found.shapes_by_frame) shaped.insert(frame);
    for (const UrdfShape& shape : robot.model->shapes) {
      const int frame = robot.model->links.at(shape.link);
      if (shape.visual == visual && !shaped.contains(frame)) reader.read(shape, frame);
    }
  }
  reader.note_problems();
  return std::move(reader.found);
}

}  // namespace morphe::setup
