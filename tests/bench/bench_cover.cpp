// Covers of meshes by capsules, and what the exact choice would cost.
//   bench_cover MESH… [--budgets N,N…]    a row a mesh and budget: figures, seconds
//   bench_cover MESH… --exact             a mesh against its own copy beside it, turned a hundred
//                                         ways: FCL's distance of the two convex hulls, and that of
//                                         their covers, one capsule against the other [µs a query],
//                                         and by how much the covers' distance is less [mm, mean]
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/collision/mesh_file.hpp"
#include "core/cover/fit_capsules.hpp"

namespace morphe {
namespace {

using Clock = std::chrono::steady_clock;
using Covers = std::vector<cover::CapsuleFit>;

double seconds(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

SceneObject at_origin(SceneObject mesh) {
  mesh.shape = Shape::mesh;
  mesh.time = {0};
  mesh.position = {Vec3::Zero()};
  mesh.orientation = {Quat::Identity()};
  return mesh;
}

fcl::Convexd convex_of(const SceneObject& hull) {
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Eigen::Vector3i& triangle : hull.triangles) {
    faces->insert(faces->end(), {3, triangle[0], triangle[1], triangle[2]});
  }
  return {std::make_shared<const std::vector<fcl::Vector3d>>(hull.vertices.begin(),
                                                             hull.vertices.end()),
          static_cast<int>(hull.triangles.size()), faces, true};
}

double between(const cover::CapsuleFit& a, const cover::CapsuleFit& b, const Pose& a_from_b) {
  double least = std::numeric_limits<double>::infinity();
  for (const collision::CapsuleBody& second : b.capsules) {
    const collision::CapsuleBody there{a_from_b * second.from, a_from_b * second.to, second.radius};
    for (const collision::CapsuleBody& first : a.capsules) {
      least = std::min(least, collision::capsule_capsule(first, there).distance);
    }
  }
  return least;
}

void compare(const std::string& name, const SceneObject& mesh, const std::vector<int>& budgets) {
  SceneObject hull = mesh;
  if (!collision::replace_by_convex_hull(hull)) return;
  const fcl::Convexd convex = convex_of(hull);
  double reach = 0;
  for (const Vec3& vertex : hull.vertices) reach = std::max(reach, vertex.norm());
  std::vector<Pose> poses;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 100; ++k) {
    Pose pose = Pose::Identity();
    pose.linear() = Quat(number(random), number(random), number(random), number(random))
                        .normalized()
                        .toRotationMatrix();
    const Vec3 way = Vec3(number(random), number(random), number(random)).normalized();
    pose.translation() = (2 * reach + 0.02) * way;
    poses.push_back(pose);
  }
  fcl::DistanceRequestd request;
  request.enable_signed_distance = false;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  std::vector<double> exact;
  auto begin = Clock::now();
  for (const Pose& pose : poses) {
    fcl::DistanceResultd result;
    fcl::Transform3d there = fcl::Transform3d::Identity();
    there.matrix() = pose.matrix();
    exact.push_back(
        fcl::distance(&convex, fcl::Transform3d::Identity(), &convex, there, request, result));
  }
  std::string row =
      fmt::format("| {} | {} | {:.1f} |", name, hull.vertices.size(), 1e4 * seconds(begin));
  for (const int budget : budgets) {
    const cover::CapsuleFit cover = cover::fit_capsules({mesh}, {budget}, name);
    double less = 0;
    std::vector<double> found;
    begin = Clock::now();
    for (const Pose& pose : poses) found.push_back(between(cover, cover, pose));
    const double took = seconds(begin);
    for (std::size_t k = 0; k < poses.size(); ++k) less += exact[k] - found[k];
    row += fmt::format(" {} | {:.1f} | {:.1f} |", cover.capsules.size(), 1e4 * took,
                       1e3 * less / static_cast<double>(poses.size()));
  }
  fmt::print("{}\n", row);
}

void figures(const std::string& name, const SceneObject& mesh, int budget) {
  const auto begin = Clock::now();
  const cover::CapsuleFit cover = cover::fit_capsules({mesh}, {budget}, name);
  const cover::FitQuality& f = cover.quality;
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.1f} | {:.1f} | {:.0f} | {:.2f} |\n", name,
             mesh.triangles.size(), cover.capsules.size(), 100 * f.coverage, 1e3 * f.largest_gap_m,
             1e3 * f.standoff_median_m, 1e3 * f.standoff_95_m, 100 * f.near_share, seconds(begin));
}

int run(const std::vector<std::string>& files, const std::vector<int>& budgets, bool exact) {
  if (exact) {
    fmt::print("| mesh | corners of its hull | FCL, µs |");
    for (std::size_t k = 0; k < budgets.size(); ++k) fmt::print(" capsules | µs | nearer, mm |");
    fmt::print("\n|---|---|---|");
    for (std::size_t k = 0; k < budgets.size(); ++k) fmt::print("---|---|---|");
    fmt::print("\n");
  } else {
    fmt::print(
        "| mesh | triangles | capsules | inside, % | largest gap, mm | off, median mm | 95 % | "
        "within 5 mm, % | s |\n|---|---|---|---|---|---|---|---|---|\n");
  }
  for (const std::string& file : files) {
    SceneObject mesh;
    const std::string wrong = collision::load_raw_mesh(file, mesh);
    if (!wrong.empty()) {
      fmt::print(stderr, "{}: {}\n", file, wrong);
      return 2;
    }
    mesh = at_origin(std::move(mesh));
    const std::filesystem::path path(file);
    const std::string name =
        (path.parent_path().parent_path().filename() / path.filename()).generic_string();
    if (exact) {
      compare(name, mesh, budgets);
    } else {
      for (const int budget : budgets) figures(name, mesh, budget);
    }
  }
  return 0;
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  std::vector<std::string> files;
  std::vector<int> budgets = {4, 12};
  bool exact = false;
  CLI::App app("Covers of meshes by capsules");
  app.add_option("MESH", files)->required()->check(CLI::ExistingFile);
  app.add_option("--budgets", budgets, "Capsules of a mesh")->delimiter(',')->expected(1, 100);
  app.add_flag("--exact", exact, "Convex hulls through FCL beside them");
  CLI11_PARSE(app, argc, argv);
  return morphe::run(files, budgets, exact);
}
