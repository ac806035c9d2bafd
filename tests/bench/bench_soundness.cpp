// Are the shapes of a robot's links clear of each other wherever its description says so?
//   bench_soundness URDF DESCRIPTION [--postures 10000]
// For random postures, and each pair of links that the description checks: if all capsules of the
// two are 1 mm apart, as the certificate asks, do the shapes of the URDF overlap? Then the pairs
// that the description excuses: their shapes must overlap in all of these postures, or in no one,
// or stay together as bars of a mechanism do; with their overlap at rest, or their least and
// largest distance. Exit code 1 if any pair is unsound.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/math/random_stream.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/find_allowed_links.hpp"
#include "pipeline/setup/moved_pair.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe {
namespace {

constexpr double kMargin_m = 0.001;

struct Study {
  robot::RobotDescription robot;
  std::map<int, std::vector<RobotModel::Capsule>> capsules;
  setup::LinkBodies bodies;
  std::vector<Pose> poses;

  std::string name(int frame) const {
    for (const auto& [link, own] : robot.links)
      if (own == frame) return link;
    return frame < 0 ? "base" : robot.table.frames[frame].name;
  }
  Pose pose(int frame) const { return frame < 0 ? Pose::Identity() : poses[frame]; }
  double capsule_distance(int one, int other) const {
    double least = kInfinity;
    for (const RobotModel::Capsule& a : capsules.at(one)) {
      for (const RobotModel::Capsule& b : capsules.at(other)) {
        least = std::min(
            least, collision::capsule_capsule({pose(one) * a.from, pose(one) * a.to, a.radius},
                                              {pose(other) * b.from, pose(other) * b.to, b.radius})
                       .distance);
      }
    }
    return least;
  }
  Pose between(int one, int other) const { return pose(one).inverse() * pose(other); }
};

Study read(const std::string& urdf, const std::string& description) {
  Study study{robot::load_robot(description), {}, {}, {}};
  const robot::UrdfModel model = robot::load_urdf_model(urdf);
  const setup::Kinematics kinematics = setup::kinematics_of(model);
  setup::LinkShapes shapes = setup::read_shapes(kinematics, {});
  std::map<int, std::vector<SceneObject>> by_frame;
  for (auto& [frame, objects] : shapes.shapes_by_frame) {
    const auto link = study.robot.links.find(kinematics.link[frame]);
    if (link != study.robot.links.end()) by_frame[link->second] = std::move(objects);
  }
  for (const RobotModel::Capsule& capsule : study.robot.table.capsules)
    study.capsules[capsule.frame].push_back(capsule);
  study.bodies = setup::link_bodies(by_frame, study.robot.table);
  return study;
}

/// The pairs of links with shapes that a joint moves relative to each other.
std::vector<std::array<int, 2>> pairs_of(const Study& study, bool excused) {
  const RobotModel& table = study.robot.table;
  std::vector<std::array<int, 2>> pairs;
  for (auto a = study.bodies.begin(); a != study.bodies.end(); ++a) {
    for (auto b = std::next(a); b != study.bodies.end(); ++b) {
      if (a->second.assumed || b->second.assumed) continue;
      const int one = robot::moving_frame_of(table, a->first),
                other = robot::moving_frame_of(table, b->first);
      const auto above = [&](int frame) {
        return frame < 0 ? -2 : robot::moving_frame_of(table, table.frames[frame].parent);
      };
      if (one == other || above(one) == other || above(other) == one) continue;
      const auto capsule_of = [&](int frame) {
        return static_cast<int>(
            std::ranges::find(table.capsules, frame, &RobotModel::Capsule::frame) -
            table.capsules.begin());
      };
      const auto [low, high] = std::minmax({capsule_of(a->first), capsule_of(b->first)});
      if (std::ranges::binary_search(table.allowed_collision_pairs, std::array{low, high}) ==
          excused)
        pairs.push_back({a->first, b->first});
    }
  }
  return pairs;
}

JointVector random_position(const RobotModel& table, math::RandomStream& random) {
  JointVector q(table.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(table.lower[j], table.upper[j]);
  return q;
}

/// Prints the overlaps and distances of an excused pair's shapes at rest and in random postures.
/// Returns false if the shapes overlap in some of these, and are farther apart in others than the
/// bars of a mechanism.
bool is_excused_soundly(Study& study, int one, int other, int postures) {
  const RobotModel& table = study.robot.table;
  const setup::LinkBody &a = study.bodies.at(one), &b = study.bodies.at(other);
  math::RandomStream random(1, "excused");
  int overlaps = 0;
  double least_m = kInfinity, largest_m = 0;
  for (int k = 0; k < postures; ++k) {
    robot::forward_kinematics(table, random_position(table, random), study.poses);
    const double distance_m = a.mesh.distance(b.mesh, study.between(one, other));
    if (distance_m <= 0) ++overlaps;
    least_m = std::min(least_m, distance_m);
    largest_m = std::max(largest_m, distance_m);
  }
  robot::forward_kinematics(table, setup::rest_position(table), study.poses);
  const bool sound = overlaps == 0 || largest_m <= setup::kLinkagePlay_m;
  fmt::print(
      "  excused: [{}, {}]: shapes overlap at rest by {:.1f} mm, and in {} of {} postures; apart "
      "by "
      "{:.2f} to {:.2f} mm{}\n",
      study.name(one), study.name(other),
      1e3 * setup::overlap_depth_m(a, b, study.between(one, other)), overlaps, postures,
      1e3 * least_m, 1e3 * largest_m, sound ? "" : ": UNSOUND");
  return sound;
}

int run(const std::string& urdf, const std::string& description, int postures) {
  Study study = read(urdf, description);
  const RobotModel& table = study.robot.table;
  const auto checked = pairs_of(study, false);
  math::RandomStream random(1, "soundness");
  long clear = 0, near = 0, unsound = 0;
  double deepest_m = 0;
  for (int k = 0; k < postures; ++k) {
    robot::forward_kinematics(table, random_position(table, random), study.poses);
    for (const auto& [one, other] : checked) {
      if (study.capsule_distance(one, other) < kMargin_m) {
        ++near;
        continue;
      }
      ++clear;
      const setup::LinkBody &a = study.bodies.at(one), &b = study.bodies.at(other);
      if (!a.mesh.overlaps(b.mesh, study.between(one, other))) continue;
      ++unsound;
      deepest_m = std::max(deepest_m, setup::overlap_depth_m(a, b, study.between(one, other)));
    }
  }
  fmt::print(
      "{}: {} postures, {} pairs: {} times clear by capsules, {} not; of the clear ones {} "
      "overlap by shapes, by at most {:.2f} mm\n",
      table.name, postures, checked.size(), clear, near, unsound, 1e3 * deepest_m);
  for (const auto& [one, other] : pairs_of(study, true))
    if (!is_excused_soundly(study, one, other, postures)) ++unsound;
  return unsound > 0 ? 1 : 0;
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  CLI::App app{"Are links clear wherever their description says so?"};
  std::string urdf, description;
  int postures = 10000;
  app.add_option("URDF", urdf)->required();
  app.add_option("DESCRIPTION", description)->required();
  app.add_option("--postures", postures);
  CLI11_PARSE(app, argc, argv);
  return morphe::run(urdf, description, postures);
}
