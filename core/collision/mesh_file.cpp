#include "core/collision/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>

#include "core/collision/close_holes.hpp"
#include "core/collision/convex_hull.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/collision/stl_file.hpp"
#include "core/files/read_in_child.hpp"

namespace morphe::collision {
namespace {

/// Width of holes that are too narrow for a robot's finger.
constexpr double kMaxHoleWidth_m = 0.01;
constexpr std::uintmax_t kMaxFileSize_bytes = 200'000'000;

std::string lower_extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void append_mesh(const aiMesh& part, const aiMatrix4x4& pose, SceneObject& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D v = pose * part.mVertices[k];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices != 3) continue;  // skips points and lines
    mesh.triangles.push_back(Eigen::Vector3i::Constant(first) +
                             Eigen::Vector3i(static_cast<int>(face.mIndices[0]),
                                             static_cast<int>(face.mIndices[1]),
                                             static_cast<int>(face.mIndices[2])));
  }
}

void append_mesh(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above,
                 SceneObject& mesh) {
  const aiMatrix4x4 pose = above * node.mTransformation;
  for (unsigned k = 0; k < node.mNumMeshes; ++k)
    append_mesh(*scene.mMeshes[node.mMeshes[k]], pose, mesh);
  for (unsigned k = 0; k < node.mNumChildren; ++k)
    append_mesh(scene, *node.mChildren[k], pose, mesh);
}

/// Reads files of the formats for which Assimp is used.
std::string read_with_assimp(const std::filesystem::path& file, bool collada, SceneObject& mesh) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) return importer.GetErrorString();
  aiMatrix4x4 above;
  if (collada) {  // undoes the transformation for unit and up axis
    above = scene->mRootNode->mTransformation;
    above.Inverse();
  }
  append_mesh(*scene, *scene->mRootNode, above, mesh);
  return "";
}

}  // namespace

std::string load_raw_mesh(const std::filesystem::path& file, SceneObject& mesh) {
  static constexpr std::array kKinds = {".stl", ".obj", ".dae", ".gltf", ".glb"};
  const std::string kind = lower_extension(file);
  if (std::ranges::find(kKinds, kind) == kKinds.end()) {
    return file.string() + ": must be an STL, OBJ, DAE or glTF file";
  }
  if (!std::filesystem::is_regular_file(file)) return file.string() + " cannot be read";
  if (std::filesystem::file_size(file) > kMaxFileSize_bytes) {
    return file.string() + ": is larger than 200 MB; simplify the mesh first";
  }
  mesh.shape = Shape::mesh;
  mesh.size.clear();
  mesh.vertices.clear();
  mesh.triangles.clear();
  std::string problem;
  if (kind == ".stl") {
    problem = read_stl(file, mesh);
  } else {
    const auto read = [&] { problem = read_with_assimp(file, kind == ".dae", mesh); };
    problem = files::child_read_error(file, read);
    if (problem.empty()) read();
  }
  if (problem.empty()) problem = mesh_problem(mesh);
  return problem.empty() ? "" : file.string() + ": " + problem;
}

std::string load_mesh(const std::filesystem::path& file, double scale, bool hull,
                      SceneObject& mesh) {
  std::string problem = load_raw_mesh(file, mesh);
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

}  // namespace morphe::collision
