// Whole-state checks and certified edges of the PA10 with the DLR/HIT II among a table and five
// objects: ours, FCL's trees on the same states, and sampling at fixed steps.
//   bench_collision [--quick] [--json OUT]
//   bench_collision --pairs N   errors of N random pairs against the convex problem, solved to 1e-9
//   bench_collision --walls N   N random motions past walls 1 mm thin: certified, finely and
//                               coarsely sampled
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/collision/continuous_check.hpp"
#include "core/collision/fcl_engine.hpp"
#include "core/robot/files/description.hpp"
#include "tests/core/collision/random_pairs.hpp"
#include "tests/core/collision/thin_walls.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe {
namespace {

using Clock = std::chrono::steady_clock;

SceneObject object(std::string name, Shape shape, std::vector<double> size, const Vec3& at) {
  SceneObject made;
  made.name = std::move(name);
  made.shape = shape;
  made.size = std::move(size);
  made.time = {0};
  made.position = {at};
  made.orientation = {Quat::Identity()};
  return made;
}

/// In the robot's base frame, before and beside it.
Scene table_and_five() {
  Scene scene;
  scene.objects = {object("table", Shape::box, {0.8, 1.2, 0.04}, {0.65, 0, 0.18}),
                   object("box", Shape::box, {0.1, 0.15, 0.2}, {0.55, 0.3, 0.3}),
                   object("cup", Shape::cylinder, {0.035, 0.1}, {0.5, -0.1, 0.25}),
                   object("ball", Shape::sphere, {0.05}, {0.7, 0.1, 0.25}),
                   object("bottle", Shape::capsule, {0.04, 0.18}, {0.6, -0.3, 0.33}),
                   object("post", Shape::cylinder, {0.02, 0.6}, {0.35, 0.45, 0.5})};
  return scene;
}

struct Bench {
  robot::Robot robot{robot::load_robot(std::filesystem::path(MORPHE_SOURCE_DIR) /
                                       "configs/robots/pa10_dlr_hit2.yaml")
                         .table};
  Scene scene = table_and_five();
  collision::CollisionWorld world = collision::make_world(robot, scene, {}, {});
  collision::CollisionScratch scratch;
};

struct Times {
  std::vector<double> us;
  double at(double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(us.size() - 1));
    std::nth_element(us.begin(), us.begin() + k, us.end());
    return us[static_cast<std::size_t>(k)];
  }
};

/// Median and 99th percentile of a call for each item, each the least of three tries: what else
/// runs on the machine is not its business.
template <class Item, class Call>
Times timed(const std::vector<Item>& items, Call call) {
  Times times;
  for (const Item& item : items) {
    double least = 1e9;
    for (int tries = 0; tries < 3; ++tries) {
      const auto begin = Clock::now();
      call(item);
      least =
          std::min(least, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    }
    times.us.push_back(least);
  }
  return times;
}

struct Edge {
  JointVector from, to;
};

/// Frames at 100 Hz of rest-to-rest quintics between free states, as fast as the limits allow, but
/// 0.8 s at least: a human's tempo.
std::vector<Edge> edges_of(Bench& bench, const std::vector<JointVector>& free_states,
                           std::size_t count) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < free_states.size() && edges.size() < count; ++k) {
    const JointVector& from = free_states[k];
    // Part of the way: a reach turns its joints by about a radian.
    const JointVector to = from + 0.3 * (free_states[k + 1] - from);
    const double slowest =
        ((to - from).cwiseAbs().array() * 1.875 / bench.robot.velocity.array()).maxCoeff();
    const int frames = static_cast<int>(100 * std::max(0.8, slowest));
    const auto at = [&](int frame) {
      const double t = static_cast<double>(frame) / frames;
      return JointVector(from + t * t * t * (10 + t * (6 * t - 15)) * (to - from));
    };
    for (int frame = 0; frame < frames; ++frame) edges.push_back({at(frame), at(frame + 1)});
  }
  if (edges.size() > count) edges.resize(count);
  return edges;
}

std::string row(const std::string& name, Times& ours, const std::string& rest = "") {
  return fmt::format("{:38} {:9.2f} {:9.2f}  {}\n", name, ours.at(0.5), ours.at(0.99), rest);
}

using Json = nlohmann::ordered_json;

/// A row of the file that --json asks for, as docs/formats.md says.
struct Case {
  std::string name;
  std::size_t n = 0;
  Times ours;
  Json errors = Json::object(), peers = Json::object();

  void add_peer(const std::string& peer, Times& times) {
    peers[peer] = {{"median_us", times.at(0.5)},
                   {"p99_us", times.at(0.99)},
                   {"ratio", times.at(0.5) / ours.at(0.5)}};
  }
  Json json() {
    return {{"case", name},
            {"n", n},
            {"ours", {{"median_us", ours.at(0.5)}, {"p99_us", ours.at(0.99)}}},
            {"errors", errors},
            {"peers", peers}};
  }
};

int run(bool quick, const std::string& file) {
  Json rows = Json::array();
  Bench bench;
  collision::FclEngine fcl(bench.world);
  std::mt19937_64 random(1);
  const std::size_t wanted = quick ? 500 : 5000;
  std::vector<JointVector> all, free_states;
  int differ = 0;
  while (free_states.size() < wanted) {
    const JointVector q = random_position(bench.robot, random);
    const bool free = collision::is_free(bench.world, q, 0, bench.scratch);
    differ += free != fcl.is_free(q, 0, bench.scratch);
    if (all.size() < wanted) all.push_back(q);
    if (free) free_states.push_back(q);
  }
  fmt::print("{} capsules, {} pairs of them, {} objects; verdicts that differ from FCL's: {}\n",
             bench.robot.capsules.size(), bench.world.pairs.size(), bench.scene.objects.size(),
             differ);
  fmt::print("{:38} {:>9} {:>9}  us\n", "", "median", "99 %");
  const auto ours = [&](const JointVector& q) {
    return collision::is_free(bench.world, q, 0, bench.scratch);
  };
  const auto theirs = [&](const JointVector& q) { return fcl.is_free(q, 0, bench.scratch); };
  for (const auto& [name, states] :
       {std::pair("free states", &free_states), {"any states", &all}}) {
    Times mine = timed(*states, ours), tree = timed(*states, theirs);
    fmt::print("{}", row(fmt::format("whole state, {}", name), mine));
    fmt::print("{}", row("  FCL, dynamic tree", tree,
                         fmt::format("{:.1f} times ours", tree.at(0.5) / mine.at(0.5))));
    Case one{fmt::format("whole state, {}", name), states->size(), mine};
    one.errors["verdicts_unlike_fcl"] = differ;
    one.add_peer("fcl_dynamic_tree", tree);
    rows.push_back(one.json());
    Times slack = timed(*states, [&](const JointVector& q) {
      return collision::least_slack(bench.world, q, 0, bench.scratch);
    });
    fmt::print("{}", row("  least slack and its pair", slack));
  }
  Times state = timed(free_states, ours);
  const std::vector<Edge> edges = edges_of(bench, free_states, wanted);
  std::vector<double> checks;
  int free_edges = 0;
  Times certified = timed(edges, [&](const Edge& edge) {
    return collision::check_motion(
        bench.world, collision::straight_motion(edge.from, edge.to, 0, 0.01), bench.scratch);
  });
  for (const Edge& edge : edges) {
    const collision::MotionCheck check = collision::check_motion(
        bench.world, collision::straight_motion(edge.from, edge.to, 0, 0.01), bench.scratch);
    free_edges += check.verdict == collision::MotionVerdict::free;
  }
  const auto sampled = [&](int steps) {
    return timed(edges, [&, steps](const Edge& edge) {
      bool free = true;
      for (int k = 0; k <= steps && free; ++k) {
        const JointVector q = edge.from + (edge.to - edge.from) * k / steps;
        free = collision::is_free(bench.world, q, 0, bench.scratch);
      }
      return free;
    });
  };
  fmt::print("\nedges between frames at 100 Hz: {}, free {}\n", edges.size(), free_edges);
  fmt::print("{}", row("certified", certified,
                       fmt::format("{:.1f} state checks", certified.at(0.5) / state.at(0.5))));
  Case edge{"certified edge, 100 Hz", edges.size(), certified};
  edge.add_peer("one_state_check", state);
  for (const int steps : {1, 10, 100}) {
    Times times = sampled(steps);
    fmt::print("{}", row(fmt::format("sampled at {} steps", steps), times));
    edge.add_peer(fmt::format("sampled_at_{}_steps", steps), times);
  }
  rows.push_back(edge.json());
  if (!file.empty()) {
    const Json json{{"bench", "collision"}, {"preset", MORPHE_PRESET}, {"rows", rows}};
    std::ofstream(file) << json.dump(1) << "\n";
  }
  return 0;
}

int pairs(int count) {
  constexpr Shape kShapes[] = {Shape::sphere, Shape::box, Shape::cylinder, Shape::capsule,
                               Shape::mesh};
  fmt::print("{:10} {:>9} {:>12} {:>12} {:>12}  m\n", "capsule -", "pairs", "over", "under",
             "reference");
  for (const Shape shape : kShapes) {
    collision::RandomBodies random(81);
    collision::DistanceError worst{-1, -1, -1};
    for (int k = 0; k < count / 5; ++k) {
      const collision::DistanceError error = collision::random_pair_error(random, shape, k);
      worst.over = std::max(worst.over, error.over);
      worst.under = std::max(worst.under, error.under);
      worst.uncertain = std::max(worst.uncertain, error.uncertain);
    }
    fmt::print("{:10} {:9} {:12.1e} {:12.1e} {:12.1e}\n", name_of(shape), count / 5, worst.over,
               worst.under, worst.uncertain);
  }
  return 0;
}

int walls(int motions) {
  collision::RandomBodies random(82);
  collision::CollisionScratch scratch;
  collision::ThinWallCount count;
  for (int k = 0; k < motions; ++k) count_thin_walls(random, count, scratch);
  fmt::print(
      "{} motions; colliding at 0.1 mm steps: {}, of those proved free: {}, free at ten "
      "steps: {}\nclear of margin and band: {}, of those not proved free: {} ({:.2f} %)\n",
      count.motions, count.colliding, count.missed, count.missed_by_ten, count.clear, count.refused,
      100.0 * count.refused / std::max(count.clear, 1));
  return 0;
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  CLI::App app{"Collision checks: whole states and certified edges, against FCL and sampling"};
  bool quick = false;
  int pairs = 0, walls = 0;
  std::string json;
  app.add_flag("--quick", quick);
  app.add_option("--json", json, "file of the figures");
  app.add_option("--pairs", pairs, "errors of this many random pairs instead");
  app.add_option("--walls", walls, "this many random motions past thin walls instead");
  CLI11_PARSE(app, argc, argv);
  if (pairs > 0) return morphe::pairs(pairs);
  if (walls > 0) return morphe::walls(walls);
  return morphe::run(quick, json);
}
