#include "stages/map/choose_branch.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "core/robot/arm_branch.hpp"

namespace morphe::map {
namespace {

unsigned branch_number(const robot::Robot& robot, const JointRows& path) {
  const std::vector<double> time(path.rows());
  return static_cast<unsigned>(robot::branch_of_path(robot, path, time).number.value_or(0));
}

}  // namespace

std::size_t choose_branch(const robot::Robot& robot, const std::vector<CandidatePath>& paths,
                          const JointVector& reference, double share) {
  const double best = std::ranges::min_element(paths, {}, &CandidatePath::value)->value;
  const unsigned preferred = reference.size() > 0 ? branch_number(robot, reference.transpose()) : 0;
  std::vector<std::tuple<bool, int, double>> order;  // too dear, parts that differ, value
  for (const CandidatePath& path : paths) {
    const int differing =
        reference.size() > 0 ? std::popcount(branch_number(robot, path.q) ^ preferred) : 0;
    order.emplace_back(path.value > (1 + share) * best, differing, path.value);
  }
  return std::ranges::min_element(order) - order.begin();
}

}  // namespace morphe::map
