#include "core/collision/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cstdint>
#include <exception>
#include <map>
#include <new>
#include <utility>

#include "core/collision/close_holes.hpp"
#include "core/collision/constants.hpp"
#include "core/collision/mesh_io.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/collision/stl_file.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/read_in_child.hpp"
#include "core/math/convex_hull_3d.hpp"

namespace morphe::collision {
namespace {

std::string lower_extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void append_mesh(const aiMesh& part, const aiMatrix4x4& pose, SceneObject& mesh) {
  const std::size_t first = mesh.vertices.size();
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D v = pose * part.mVertices[k];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices != 3) continue;  // skips points and lines
    mesh.triangles.emplace_back(first + face.mIndices[0], first + face.mIndices[1],
                                first + face.mIndices[2]);
  }
}

void append_mesh(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent_pose,
                 SceneObject& mesh) {
  const aiMatrix4x4 pose = parent_pose * node.mTransformation;
  for (unsigned k = 0; k < node.mNumMeshes; ++k)
    append_mesh(*scene.mMeshes[node.mMeshes[k]], pose, mesh);
  for (unsigned k = 0; k < node.mNumChildren; ++k)
    append_mesh(scene, *node.mChildren[k], pose, mesh);
}

/// Throws std::bad_alloc if a failed import lacked memory, which is no fault of the file.
void expect_memory(const Assimp::Importer& importer) {
  if (!importer.GetException()) return;
  try {
    std::rethrow_exception(importer.GetException());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {  // described by the importer's text
  }
}

std::string read_with_assimp(const std::filesystem::path& file, bool collada, SceneObject& mesh,
                             MeshSource& source) {
  Assimp::Importer importer;
  auto* const own_files = new MeshFiles(file, source.given);  // deleted by the importer
  importer.SetIOHandler(own_files);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    expect_memory(importer);
    return importer.GetErrorString();
  }
  source.read.insert(source.read.end(), own_files->opened().begin(), own_files->opened().end());
  aiMatrix4x4 root_pose;
  if (collada) {  // undoes the root's transformation, which converts unit and up axis
    root_pose = scene->mRootNode->mTransformation;
    root_pose.Inverse();
  }
  append_mesh(*scene, *scene->mRootNode, root_pose, mesh);
  return "";
}

}  // namespace

std::string load_raw_mesh(const std::filesystem::path& named, SceneObject& mesh,
                          MeshSource* source) {
  MeshSource own_source;
  if (!source) source = &own_source;
  const files::GivenFiles* const given = source->given;
  const std::filesystem::path file = files::located(named, given);
  static constexpr std::array kKinds = {".stl", ".obj", ".dae", ".gltf", ".glb"};
  const std::string kind = lower_extension(file);
  if (std::ranges::find(kKinds, kind) == kKinds.end())
    return file.string() + ": must be an STL, OBJ, DAE or glTF file";
  if (!files::is_readable_file(file, given)) return file.string() + " cannot be read";
  const std::uintmax_t size = given ? given->bytes(file).size() : std::filesystem::file_size(file);
  if (size > kMaxMeshFile_bytes)
    return file.string() + ": is larger than 200 MB; simplify the mesh first";
  if (const auto foreign = files::file_kind(files::read_file_head(file, given));
      foreign && foreign->unwrapped)
    return fmt::format("{}: is {}; {}", file.string(), foreign->name, foreign->advice);
  mesh.shape = Shape::mesh;
  mesh.size.clear();
  mesh.vertices.clear();
  mesh.triangles.clear();
  std::string problem;
  if (kind == ".stl") {
    problem = read_stl(file, mesh, given);
    source->read.push_back(file);
  } else {
    const auto read = [&] { problem = read_with_assimp(file, kind == ".dae", mesh, *source); };
    problem = files::child_read_error(size, read);
    if (problem.empty()) read();
  }
  if (problem.empty()) problem = mesh_problem(mesh);
  return problem.empty() ? "" : file.string() + ": " + problem;
}

std::string load_mesh(const std::filesystem::path& file, double scale, bool hull, SceneObject& mesh,
                      MeshSource* source) {
  std::string problem = load_raw_mesh(file, mesh, source);
  if (!problem.empty()) return problem;
  for (Vec3& vertex : mesh.vertices) vertex *= scale;
  problem = mesh_problem(mesh);
  if (problem.empty() && hull && !replace_by_convex_hull(mesh))
    problem = "the mesh is flat: it has no convex hull";
  if (problem.empty()) {
    weld(mesh);
    close_holes(mesh, kMaxHoleWidth_m);
    if (mesh.triangles.empty()) problem = "the mesh is smaller than 1 micrometre";
  }
  return problem.empty() ? "" : file.string() + ": " + problem;
}

bool replace_by_convex_hull(SceneObject& mesh) {
  const std::vector<math::HullTriangle> hull = math::convex_hull_3d(mesh.vertices);
  if (hull.empty()) return false;
  std::map<std::size_t, int> new_index;  // of each kept vertex
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (const math::HullTriangle& facet : hull) {
    Eigen::Vector3i& triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const std::size_t corner = facet.corners[k];
      const auto [vertex, added] = new_index.emplace(corner, vertices.size());
      if (added) vertices.push_back(mesh.vertices[corner]);
      triangle[k] = vertex->second;
    }
  }
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  return true;
}

}  // namespace morphe::collision
