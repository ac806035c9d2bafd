#include "stages/map/splice.hpp"

#include <algorithm>
#include <numeric>

namespace morphe::map {
namespace {

using Eigen::Index;

/// What the cheapest sequence up to a frame, on each way, costs, and which way it came on.
struct Sequences {
  Eigen::MatrixXd cost;  ///< [F, ways]
  Eigen::MatrixXi from;  ///< [F, ways]
};

/// [F, ways] a frame's own cost and its differences from the frames before on the same way.
Eigen::MatrixXd costs_along(const std::vector<Way>& ways,
                            const std::array<JointVector, 3>& difference_weight) {
  const Index frames = ways.front().q.rows();
  Eigen::MatrixXd cost(frames, static_cast<Index>(ways.size()));
  for (std::size_t w = 0; w < ways.size(); ++w) {
    JointRows difference = ways[w].q;
    auto column = cost.col(static_cast<Index>(w));
    column = Eigen::Map<const Eigen::VectorXd>(ways[w].value.data(), frames);
    for (std::size_t order = 0; order < 3 && difference.rows() > 1; ++order) {
      const Index rows = difference.rows() - 1;
      difference = JointRows(difference.bottomRows(rows) - difference.topRows(rows));
      column.tail(rows) += difference.cwiseAbs2() * difference_weight[order];
    }
  }
  return cost;
}

/// From the first frame to the last; reversed: from the last to the first.
Sequences cheapest(const std::vector<Way>& ways, const Eigen::MatrixXd& cost,
                   const JointVector& step_weight, bool reversed) {
  const Index frames = cost.rows(), count = cost.cols();
  Sequences table{cost, Eigen::MatrixXi::Zero(frames, count)};
  const auto at = [&](Index f) { return reversed ? frames - 1 - f : f; };
  for (Index f = 1; f < frames; ++f) {
    // A change lies between two frames: seen from either side, it is a step at the later one.
    const Index here = at(f), before = at(f - 1), step_at = std::max(here, before);
    for (Index to = 0; to < count; ++to) {
      double least = table.cost(before, to);
      table.from(here, to) = static_cast<int>(to);
      const auto& own = ways[static_cast<std::size_t>(to)].q;
      for (Index from = 0; from < count; ++from) {
        if (table.cost(before, from) >= least) continue;
        const auto& other = ways[static_cast<std::size_t>(from)].q;
        const double step =
            (own.row(step_at) - other.row(step_at)).cwiseAbs2().dot(step_weight.transpose());
        if (table.cost(before, from) + step >= least) continue;
        least = table.cost(before, from) + step;
        table.from(here, to) = static_cast<int>(from);
      }
      table.cost(here, to) += least;
    }
  }
  return table;
}

}  // namespace

std::vector<JointRows> splice(const std::vector<Way>& ways,
                              const std::array<JointVector, 3>& difference_weight) {
  if (ways.empty()) return {};
  const Eigen::MatrixXd cost = costs_along(ways, difference_weight);
  const JointVector step_weight =
      difference_weight[0] + 2 * difference_weight[1] + 6 * difference_weight[2];
  const Sequences ahead = cheapest(ways, cost, step_weight, false);
  const Sequences back = cheapest(ways, cost, step_weight, true);

  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto through = [&](std::size_t w) {
    const auto key = static_cast<Index>(ways[w].key), way = static_cast<Index>(w);
    return ahead.cost(key, way) + back.cost(key, way) - cost(key, way);
  };
  std::ranges::stable_sort(order, {}, through);

  std::vector<JointRows> sequences;
  for (const std::size_t w : order) {
    JointRows sequence(cost.rows(), ways[w].q.cols());
    const auto key = static_cast<Index>(ways[w].key);
    const auto row_of = [&](Index f, Index way) {
      return ways[static_cast<std::size_t>(way)].q.row(f);
    };
    auto way = static_cast<Index>(w);
    for (Index f = key; f >= 0; --f) {
      sequence.row(f) = row_of(f, way);
      way = ahead.from(f, way);
    }
    way = static_cast<Index>(w);
    for (Index f = key; f < cost.rows(); ++f) {
      sequence.row(f) = row_of(f, way);
      way = back.from(f, way);
    }
    const bool known =
        std::ranges::any_of(sequences, [&](const JointRows& other) { return other == sequence; });
    if (!known) sequences.push_back(std::move(sequence));
  }
  return sequences;
}

}  // namespace morphe::map
