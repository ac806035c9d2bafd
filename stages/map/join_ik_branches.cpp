#include "stages/map/join_ik_branches.hpp"

#include <algorithm>
#include <numeric>

namespace morphe::map {
namespace {

using Eigen::Index;

/// The cost of the cheapest sequence that ends at each frame on each branch, and its previous
/// branch.
struct ViterbiTable {
  Eigen::MatrixXd cost;                                           ///< [F, branches]
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> previous;  ///< [F, branches]
};

/// Returns [F, branches]: each frame's cost plus that of its differences along the branch.
Eigen::MatrixXd branch_costs(const std::vector<IkBranch>& branches,
                             const std::array<JointVector, 3>& difference_weight) {
  const Index frames = branches.front().q.rows();
  Eigen::MatrixXd cost(frames, branches.size());
  for (int b = 0; b < std::ssize(branches); ++b) {
    JointRows difference = branches[b].q;
    auto column = cost.col(b);
    column = Eigen::Map<const Eigen::VectorXd>(branches[b].frame_cost.data(), frames);
    for (int order = 0; order < 3 && difference.rows() > 1; ++order) {
      const Index rows = difference.rows() - 1;
      difference = JointRows(difference.bottomRows(rows) - difference.topRows(rows));
      column.tail(rows) += difference.cwiseAbs2() * difference_weight[order];
    }
  }
  return cost;
}

/// Computes the table from the first frame to the last; if reversed, from the last to the first.
ViterbiTable viterbi_pass(const std::vector<IkBranch>& branches, const Eigen::MatrixXd& cost,
                          const JointVector& step_weight, bool reversed) {
  const Index frames = cost.rows(), count = cost.cols();
  ViterbiTable table{cost, decltype(ViterbiTable::previous)::Zero(frames, count)};
  const auto frame_at = [&](Index f) { return reversed ? frames - 1 - f : f; };
  for (Index f = 1; f < frames; ++f) {
    // The step of a change between two frames belongs to the later one, in either direction.
    const Index frame = frame_at(f), before = frame_at(f - 1), later = std::max(frame, before);
    for (Index to = 0; to < count; ++to) {
      double best_cost = table.cost(before, to);
      table.previous(frame, to) = to;
      for (Index from = 0; from < count; ++from) {
        if (table.cost(before, from) >= best_cost) continue;
        const double step = (branches[to].q.row(later) - branches[from].q.row(later))
                                .cwiseAbs2()
                                .dot(step_weight.transpose());
        if (table.cost(before, from) + step >= best_cost) continue;
        best_cost = table.cost(before, from) + step;
        table.previous(frame, to) = from;
      }
      table.cost(frame, to) += best_cost;
    }
  }
  return table;
}

}  // namespace

std::vector<JointRows> join_ik_branches(const std::vector<IkBranch>& branches,
                                        const std::array<JointVector, 3>& difference_weight) {
  if (branches.empty()) return {};
  const Eigen::MatrixXd cost = branch_costs(branches, difference_weight);
  const JointVector step_weight =
      difference_weight[0] + 2 * difference_weight[1] + 6 * difference_weight[2];
  const ViterbiTable ahead = viterbi_pass(branches, cost, step_weight, false);
  const ViterbiTable back = viterbi_pass(branches, cost, step_weight, true);

  std::vector<Index> order(branches.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index b) {
    const Index key = branches[b].key_frame;
    return ahead.cost(key, b) + back.cost(key, b) - cost(key, b);
  });

  std::vector<JointRows> sequences;
  for (const Index start_branch : order) {
    JointRows sequence(cost.rows(), branches[start_branch].q.cols());
    Index branch = start_branch;
    for (Index f = branches[start_branch].key_frame; f >= 0; --f) {
      sequence.row(f) = branches[branch].q.row(f);
      branch = ahead.previous(f, branch);
    }
    branch = start_branch;
    for (Index f = branches[start_branch].key_frame; f < cost.rows(); ++f) {
      sequence.row(f) = branches[branch].q.row(f);
      branch = back.previous(f, branch);
    }
    const bool known =
        std::ranges::any_of(sequences, [&](const JointRows& other) { return other == sequence; });
    if (!known) sequences.push_back(std::move(sequence));
  }
  return sequences;
}

}  // namespace morphe::map
