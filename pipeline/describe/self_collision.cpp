#include "pipeline/describe/self_collision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "core/collision/world.hpp"

namespace morphe::describe {
namespace {

using Json = nlohmann::ordered_json;

/// Replaces std::uniform_real_distribution, which differs between libraries.
double uniform_01(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

std::array<std::string, 2> names(const RobotModel& robot, const SelfCollisionPair& pair) {
  return {robot.capsules[pair.capsules[0]].name, robot.capsules[pair.capsules[1]].name};
}

double share(const SelfCollision& found, const SelfCollisionPair& pair) {
  return static_cast<double>(pair.colliding_samples) / found.samples;
}

}  // namespace

SelfCollision sample_self_collision(const RobotModel& table, int samples) {
  const robot::Robot robot(table);
  const Scene no_objects;
  const collision::CollisionWorld world = collision::make_world(robot, no_objects, {}, {});
  std::vector<SelfCollisionPair> pairs;
  for (const auto& capsules : world.pairs) pairs.push_back({capsules, 0, kInfinity});
  std::mt19937_64 random(1);
  collision::CollisionScratch scratch;
  JointVector q(robot.lower.size());
  for (int sample = 0; sample < samples; ++sample) {
    for (int j = 0; j < q.size(); ++j)
      q[j] = robot.lower[j] + uniform_01(random) * (robot.upper[j] - robot.lower[j]);
    collision::update_bodies(world, q, 0, scratch);
    for (SelfCollisionPair& pair : pairs) {
      const auto [i, k] = pair.capsules;
      const double distance =
          collision::capsule_capsule(scratch.bodies[i], scratch.bodies[k]).distance;
      pair.distance_m = std::min(pair.distance_m, distance);
      pair.colliding_samples += distance < 0;
    }
  }
  SelfCollision found{samples, {}, {}, {}};
  for (const SelfCollisionPair& pair : pairs) {
    auto& list = pair.colliding_samples == samples ? found.always
                 : pair.colliding_samples == 0     ? found.never
                                                   : found.sometimes;
    list.push_back(pair);
  }
  return found;
}

std::string self_collision_text(const RobotModel& robot, const SelfCollision& found) {
  std::string text = fmt::format(
      "{} pairs of capsules in {} positions: {} always overlap, {} never, {} sometimes\n",
      found.always.size() + found.never.size() + found.sometimes.size(), found.samples,
      found.always.size(), found.never.size(), found.sometimes.size());
  if (!found.always.empty())
    text += "\nalways: overlap by design, add to collision.allowed_collision_pairs\n";
  for (const SelfCollisionPair& pair : found.always) {
    const auto [a, b] = names(robot, pair);
    text += fmt::format("  - [{}, {}]\n", a, b);
  }
  if (!found.sometimes.empty()) text += "\nsometimes\n";
  for (const SelfCollisionPair& pair : found.sometimes) {
    const auto [a, b] = names(robot, pair);
    text += fmt::format("  [{}, {}]  {:.2g} %, up to {:.1f} mm deep\n", a, b,
                        100 * share(found, pair), -1e3 * pair.distance_m);
  }
  if (!found.never.empty()) text += "\nnever (in these samples, not proven)\n";
  for (const SelfCollisionPair& pair : found.never) {
    const auto [a, b] = names(robot, pair);
    text += fmt::format("  - [{}, {}]  # at least {:.1f} mm apart\n", a, b, 1e3 * pair.distance_m);
  }
  return text;
}

std::string self_collision_json(const RobotModel& robot, const SelfCollision& found) {
  Json always = Json::array(), never = Json::array(), sometimes = Json::array();
  for (const auto& pair : found.always) always.push_back(names(robot, pair));
  for (const auto& pair : found.never)
    never.push_back({{"pair", names(robot, pair)}, {"least_m", pair.distance_m}});
  for (const auto& pair : found.sometimes)
    sometimes.push_back({{"pair", names(robot, pair)},
                         {"share", share(found, pair)},
                         {"least_m", pair.distance_m}});
  const Json json = {
      {"samples", found.samples}, {"always", always}, {"never", never}, {"sometimes", sometimes}};
  return json.dump(2);
}

}  // namespace morphe::describe
