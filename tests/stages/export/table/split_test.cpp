#include "stages/export/table/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/math/random_stream.hpp"

namespace morphe::exports {
namespace {

/// Plans of random persons, demonstrations and movements, in a random order.
std::vector<Plan> random_plans(math::RandomStream& random) {
  std::vector<Plan> plans(static_cast<std::size_t>(random.uniform(1, 60)));
  const double persons = random.uniform(1, 12), demonstrations = random.uniform(1, 20);
  for (Plan& plan : plans) {
    const int person = static_cast<int>(random.uniform(0, persons));
    plan.subject = person == 0 ? "" : "P" + std::to_string(person);
    const int number = static_cast<int>(random.uniform(0, demonstrations));
    plan.demonstration = plan.subject + "_reach_" + std::to_string(number);
    plan.movement.index = static_cast<int>(random.uniform(0, 4));
  }
  return plans;
}

std::vector<std::string> keys_of(const std::vector<Plan>& plans, SplitBy by) {
  std::vector<std::string> keys;
  for (const Plan& plan : plans) keys.push_back(split_key(plan, by));
  return keys;
}

TEST(Split, NoDemonstrationIsOnBothSides) {
  math::RandomStream random(1, "splits");
  for (int round = 0; round < 300; ++round) {
    const std::vector<Plan> plans = random_plans(random);
    const double share = random.uniform(0.01, 0.99);
    for (const SplitBy by : {SplitBy::demonstration, SplitBy::person}) {
      const std::vector<std::string> keys = keys_of(plans, by);
      const auto sides = split_sides(keys, share);
      std::map<std::string, std::string_view> by_demonstration, by_person;
      for (std::size_t k = 0; k < plans.size(); ++k) {
        const auto [found, is_new] = by_demonstration.emplace(plans[k].demonstration, sides[k]);
        ASSERT_EQ(found->second, sides[k]);
        if (by == SplitBy::demonstration || plans[k].subject.empty()) continue;
        ASSERT_EQ(by_person.emplace(plans[k].subject, sides[k]).first->second, sides[k]);
      }
      // Two demonstrations or persons are enough for both sides.
      const bool several = std::ranges::count(keys, keys.front()) < std::ssize(keys);
      EXPECT_EQ(std::ranges::count(sides, kValid) > 0, several);
      EXPECT_GT(std::ranges::count(sides, kTrain), 0);
    }
  }
}

TEST(Split, IsTheSameForOthersAndInAnyOrder) {
  std::vector<std::string> few, many;
  for (int k = 0; k < 400; ++k) many.push_back("demonstration/" + std::to_string(k));
  few.assign(many.begin() + 100, many.begin() + 200);
  std::ranges::reverse(few);
  const auto of_few = split_sides(few, 0.2), of_many = split_sides(many, 0.2);
  for (std::size_t k = 0; k < few.size(); ++k) EXPECT_EQ(of_few[k], of_many[199 - k]);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(of_many, kValid)), 80, 30);
}

TEST(Split, IsTheSameOnEveryMachine) {
  // SHA-256("0/split/demonstration/a") begins with 0x672e, b with 0x0bff, c with 0x7a66
  // (sha256sum); 0.45 is 0x7333.
  const std::vector<std::string> keys{"demonstration/a", "demonstration/b", "demonstration/c"};
  const auto sides = split_sides(keys, 0.45);
  EXPECT_EQ(std::vector<std::string>(sides.begin(), sides.end()),
            (std::vector<std::string>{"valid", "valid", "train"}));
}

}  // namespace
}  // namespace morphe::exports
