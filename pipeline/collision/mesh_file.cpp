#include "pipeline/collision/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>

#include "pipeline/collision/close_holes.hpp"
#include "pipeline/collision/convex_hull.hpp"
#include "pipeline/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

/// No finger of a robot fits through.
constexpr double kWidestHole_m = 0.01;

std::string lower_extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void take(const aiMesh& part, double scale, SceneObject& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D& v = part.mVertices[k];
    mesh.vertices.push_back(scale * Vec3(v.x, v.y, v.z));
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices != 3) continue;  // points and lines
    mesh.triangles.push_back(Eigen::Vector3i::Constant(first) +
                             Eigen::Vector3i(static_cast<int>(face.mIndices[0]),
                                             static_cast<int>(face.mIndices[1]),
                                             static_cast<int>(face.mIndices[2])));
  }
}

}  // namespace

std::string load_mesh(const std::filesystem::path& file, double scale, bool hull,
                      SceneObject& mesh) {
  const std::string kind = lower_extension(file);
  if (kind != ".stl" && kind != ".obj") return "must be an STL or OBJ file";
  if (!std::filesystem::is_regular_file(file)) return file.string() + " cannot be read";
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene) return file.string() + ": " + importer.GetErrorString();
  mesh.shape = Shape::mesh;
  mesh.size.clear();
  mesh.vertices.clear();
  mesh.triangles.clear();
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) take(*scene->mMeshes[k], scale, mesh);
  std::string problem = mesh_problem(mesh);
  if (problem.empty() && hull && !take_hull(mesh)) problem = "it is flat: it has no hull";
  if (problem.empty()) {
    weld(mesh);
    close_holes(mesh, kWidestHole_m);
    if (mesh.triangles.empty()) problem = "it is smaller than a micrometre";
  }
  if (!problem.empty()) return file.string() + ": " + problem;
  return "";
}

}  // namespace morphe::collision
