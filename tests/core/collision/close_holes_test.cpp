#include <gtest/gtest.h>

#include "core/collision/close_holes.hpp"
#include "tests/core/collision/meshes.hpp"

namespace morphe::collision {
namespace {

/// With corners of its own for every triangle, shaken by up to 0.3 um, as an exporter's rounding.
SceneObject loose(const SceneObject& mesh) {
  SceneObject out = mesh;
  out.vertices.clear();
  for (Eigen::Vector3i& t : out.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto number = static_cast<double>(out.vertices.size());
      out.vertices.push_back(mesh.vertices[static_cast<std::size_t>(t[k])] +
                             3e-7 * Vec3(std::sin(number), std::cos(3 * number), 0));
      t[k] = static_cast<int>(out.vertices.size()) - 1;
    }
  }
  return out;
}

bool closed(SceneObject mesh) {
  weld(mesh);
  close_holes(mesh, 0.01);
  const MeshObject made = mesh_object(mesh.vertices, mesh.triangles);
  return !is_open(*made.solid) && is_inside(*made.solid, Vec3(0.001, 0.002, 0.003));
}

TEST(CloseHoles, LooseCornersAreSewn) {
  SceneObject mesh = loose(box_mesh(Vec3::Constant(0.4)));
  ASSERT_EQ(mesh.vertices.size(), 36u);
  weld(mesh);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_TRUE(closed(loose(box_mesh(Vec3::Constant(0.4)))));
}

TEST(CloseHoles, ASmallHoleGetsALidAWideOneStays) {
  MeshObject ball = torus_mesh(0.2, 0.07, 96, 48);
  for (Vec3& vertex : ball.vertices) vertex.x() -= 0.2;
  EXPECT_TRUE(closed(ball));
  SceneObject leaky = ball;
  leaky.triangles.erase(leaky.triangles.begin() + 100, leaky.triangles.begin() + 101);
  leaky.triangles.erase(leaky.triangles.begin() + 3000, leaky.triangles.begin() + 3002);
  EXPECT_TRUE(is_open(*mesh_object(leaky.vertices, leaky.triangles).solid));
  EXPECT_TRUE(closed(leaky));
  // A ring of the tube is missing: two holes 14 cm wide.
  SceneObject cut = ball;
  cut.triangles.erase(cut.triangles.begin() + 40 * 96, cut.triangles.begin() + 44 * 96);
  EXPECT_FALSE(closed(cut));
}

/// One side of the box is one face, its neighbour's edge has a corner between: as CAD programs
/// write it. The slit has no width.
TEST(CloseHoles, ACornerOnAnEdgeIsNoHole) {
  MeshObject mesh = box_mesh(Vec3::Constant(0.4));
  const Eigen::Vector3i split = mesh.triangles[0];
  mesh.vertices.push_back(0.5 * (mesh.vertices[static_cast<std::size_t>(split[0])] +
                                 mesh.vertices[static_cast<std::size_t>(split[1])]));
  mesh.triangles[0] = {split[0], 8, split[2]};
  mesh.triangles.push_back({8, split[1], split[2]});
  EXPECT_TRUE(is_open(*mesh_object(mesh.vertices, mesh.triangles).solid));
  EXPECT_TRUE(closed(mesh));
  // The whole seam around a face is split and has opened by 2 mm.
  MeshObject torn = box_mesh(Vec3::Constant(0.4));
  const std::size_t corners = torn.vertices.size();
  for (std::size_t k = 0; k < corners; ++k) torn.vertices.push_back(torn.vertices[k]);
  for (std::size_t t = 0; t < 2; ++t) torn.triangles[t] += Eigen::Vector3i::Constant(8);
  for (std::size_t k = corners; k < 2 * corners; ++k) torn.vertices[k].z() -= 0.002;
  EXPECT_FALSE(closed(torn));  // two parts: nothing tells that they belong together
}

TEST(CloseHoles, ASheetIsLeftAlone) {
  MeshObject sheet = box_mesh(Vec3(0.4, 0.4, 0.001), 1);
  const std::size_t triangles = sheet.triangles.size();
  close_holes(sheet, 0.01);
  EXPECT_EQ(sheet.triangles.size(), triangles);
}

}  // namespace
}  // namespace morphe::collision
