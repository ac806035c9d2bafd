#include "stages/map/join_ik_branches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace morphe;
using namespace morphe::map;

namespace {

using Eigen::Index;

const std::array<JointVector, 3> kWeights{
    JointVector::Constant(2, 0.7), JointVector::Constant(2, 0.2), JointVector::Constant(2, 0.05)};

std::vector<IkBranch> random_ways(std::size_t count, Index frames, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<IkBranch> ways(count);
  for (IkBranch& way : ways) {
    way.key_frame = random() % static_cast<unsigned>(frames);
    way.q.resize(frames, 2);
    for (Index f = 0; f < frames; ++f) {
      way.q.row(f) << uniform(random), uniform(random);
      way.frame_cost.push_back(uniform(random));
    }
  }
  return ways;
}

/// The header's sum, for the way that is taken at each frame.
double cost_of(const std::vector<IkBranch>& ways, const std::vector<std::size_t>& taken) {
  const double binomial[] = {1, 2, 6};
  double sum = 0;
  for (std::size_t f = 0; f < taken.size(); ++f) {
    const IkBranch& way = ways[taken[f]];
    const auto row = [&](std::size_t frame) -> JointVector {
      return way.q.row(static_cast<Index>(frame)).transpose();
    };
    sum += way.frame_cost[f];
    if (f >= 1) sum += (row(f) - row(f - 1)).cwiseAbs2().dot(kWeights[0]);
    if (f >= 2) sum += (row(f) - 2 * row(f - 1) + row(f - 2)).cwiseAbs2().dot(kWeights[1]);
    if (f >= 3) {
      sum += (row(f) - 3 * row(f - 1) + 3 * row(f - 2) - row(f - 3)).cwiseAbs2().dot(kWeights[2]);
    }
    if (f == 0 || taken[f] == taken[f - 1]) continue;
    const JointVector step = row(f) - ways[taken[f - 1]].q.row(static_cast<Index>(f)).transpose();
    for (std::size_t order = 0; order < 3; ++order) {
      sum += binomial[order] * step.cwiseAbs2().dot(kWeights[order]);
    }
  }
  return sum;
}

/// Every assignment of ways to frames that passes through `through` at its key.
double least_by_enumeration(const std::vector<IkBranch>& ways, std::size_t through,
                            std::vector<std::size_t>& best) {
  const auto frames = static_cast<std::size_t>(ways.front().q.rows());
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> taken(frames, 0);
  while (true) {
    if (taken[ways[through].key_frame] == through) {
      if (const double cost = cost_of(ways, taken); cost < least) {
        least = cost;
        best = taken;
      }
    }
    std::size_t f = 0;
    while (f < frames && ++taken[f] == ways.size()) taken[f++] = 0;
    if (f == frames) return least;
  }
}

JointRows rows_of(const std::vector<IkBranch>& ways, const std::vector<std::size_t>& taken) {
  JointRows rows(static_cast<Index>(taken.size()), 2);
  for (std::size_t f = 0; f < taken.size(); ++f) {
    rows.row(static_cast<Index>(f)) = ways[taken[f]].q.row(static_cast<Index>(f));
  }
  return rows;
}

}  // namespace

TEST(Splice, FindsWhatEnumerationFinds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<IkBranch> ways = random_ways(3, 6, seed);
    std::vector<std::pair<double, JointRows>> expected;
    for (std::size_t w = 0; w < ways.size(); ++w) {
      std::vector<std::size_t> taken;
      const double cost = least_by_enumeration(ways, w, taken);
      const JointRows rows = rows_of(ways, taken);
      const bool known =
          std::ranges::any_of(expected, [&](const auto& entry) { return entry.second == rows; });
      if (!known) expected.emplace_back(cost, rows);
    }
    std::ranges::stable_sort(expected, {}, &std::pair<double, JointRows>::first);

    const std::vector<JointRows> found = join_ik_branches(ways, kWeights);
    ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k], expected[k].second) << "seed " << seed << ", sequence " << k;
    }
  }
}

TEST(Splice, TakesTheBetterHalfOfEachOfTwoWays) {
  std::vector<IkBranch> ways(2);
  for (std::size_t w = 0; w < 2; ++w) {
    ways[w].key_frame = w == 0 ? 0 : 9;
    ways[w].q = JointRows::Constant(10, 2, 0.1 * static_cast<double>(w));
    for (std::size_t f = 0; f < 10; ++f) ways[w].frame_cost.push_back((f < 5) == (w == 0) ? 1 : 2);
  }
  const std::vector<JointRows> found = join_ik_branches(ways, kWeights);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().topRows(5), ways[0].q.topRows(5));
  EXPECT_EQ(found.front().bottomRows(5), ways[1].q.bottomRows(5));
}

TEST(Splice, OfNothingIsNothing) { EXPECT_TRUE(join_ik_branches({}, kWeights).empty()); }
