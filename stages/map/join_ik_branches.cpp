#include "stages/map/join_ik_branches.hpp"

#include <algorithm>
#include <numeric>

namespace morphe::map {
namespace {

using Eigen::Index;

/// The costs of the cheapest sequences up to each frame on each branch, and the previous branch of
/// each.
struct ViterbiTable {
  Eigen::MatrixXd cost;  ///< [F, ways]
  Eigen::MatrixXi from;  ///< [F, ways]
};

/// Returns [F, branches]: each frame's own cost and that of its differences from previous frames on
/// the same branch.
Eigen::MatrixXd branch_costs(const std::vector<IkBranch>& ways,
                             const std::array<JointVector, 3>& difference_weight) {
  const Index frames = ways.front().q.rows();
  Eigen::MatrixXd cost(frames, ways.size());
  for (std::size_t w = 0; w < ways.size(); ++w) {
    JointRows difference = ways[w].q;
    auto column = cost.col(w);
    column = Eigen::Map<const Eigen::VectorXd>(ways[w].frame_cost.data(), frames);
    for (std::size_t order = 0; order < 3 && difference.rows() > 1; ++order) {
      const Index rows = difference.rows() - 1;
      difference = JointRows(difference.bottomRows(rows) - difference.topRows(rows));
      column.tail(rows) += difference.cwiseAbs2() * difference_weight[order];
    }
  }
  return cost;
}

/// Computes the table from the first frame to the last; if reversed, from the last to the first.
ViterbiTable viterbi_pass(const std::vector<IkBranch>& ways, const Eigen::MatrixXd& cost,
                          const JointVector& step_weight, bool reversed) {
  const Index frames = cost.rows(), count = cost.cols();
  ViterbiTable table{cost, Eigen::MatrixXi::Zero(frames, count)};
  const auto at = [&](Index f) { return reversed ? frames - 1 - f : f; };
  for (Index f = 1; f < frames; ++f) {
    // A change occurs between two frames: in either direction it is a step at the later one.
    const Index here = at(f), before = at(f - 1), step_at = std::max(here, before);
    for (Index to = 0; to < count; ++to) {
      double least = table.cost(before, to);
      table.from(here, to) = static_cast<int>(to);
      const auto& own = ways[to].q;
      for (Index from = 0; from < count; ++from) {
        if (table.cost(before, from) >= least) continue;
        const auto& other = ways[from].q;
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

std::vector<JointRows> join_ik_branches(const std::vector<IkBranch>& ways,
                                        const std::array<JointVector, 3>& difference_weight) {
  if (ways.empty()) return {};
  const Eigen::MatrixXd cost = branch_costs(ways, difference_weight);
  const JointVector step_weight =
      difference_weight[0] + 2 * difference_weight[1] + 6 * difference_weight[2];
  const ViterbiTable ahead = viterbi_pass(ways, cost, step_weight, false);
  const ViterbiTable back = viterbi_pass(ways, cost, step_weight, true);

  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto through = [&](std::size_t w) {
    const auto key = static_cast<Index>(ways[w].key_frame), branch = static_cast<Index>(w);
    return ahead.cost(key, branch) + back.cost(key, branch) - cost(key, branch);
  };
  std::ranges::stable_sort(order, {}, through);

  std::vector<JointRows> sequences;
  for (const std::size_t w : order) {
    JointRows sequence(cost.rows(), ways[w].q.cols());
    const auto key = static_cast<Index>(ways[w].key_frame);
    const auto row_of = [&](Index f, Index way) { return ways[way].q.row(f); };
    auto branch = static_cast<Index>(w);
    for (Index f = key; f >= 0; --f) {
      sequence.row(f) = row_of(f, branch);
      branch = ahead.from(f, branch);
    }
    branch = w;
    for (Index f = key; f < cost.rows(); ++f) {
      sequence.row(f) = row_of(f, branch);
      branch = back.from(f, branch);
    }
    const bool known =
        std::ranges::any_of(sequences, [&](const JointRows& other) { return other == sequence; });
    if (!known) sequences.push_back(std::move(sequence));
  }
  return sequences;
}

}  // namespace morphe::map
