#include "core/collision/capsule_pairs.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "core/collision/constants.hpp"

namespace morphe::collision {
namespace {

using Capsules = std::vector<RobotModel::Capsule>;

struct Box {
  Vec3 low = Vec3::Constant(kInfinity), high = -low;

  void add(const RobotModel::Capsule& capsule) {
    const Vec3 radius = Vec3::Constant(capsule.radius);
    low = low.cwiseMin(capsule.from - radius).cwiseMin(capsule.to - radius);
    high = high.cwiseMax(capsule.from + radius).cwiseMax(capsule.to + radius);
  }
  double half_surface() const {
    const Vec3 size = high - low;
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  }
};

/// Returns box and sphere, larger by more than the rounding of a pose.
CapsuleCluster cluster_of_capsules(const Capsules& capsules, std::span<const int> members) {
  Box box;
  for (const int i : members) box.add(capsules[i]);
  CapsuleCluster cluster;
  cluster.frame = capsules[members.front()].frame;
  cluster.centre = 0.5 * (box.low + box.high);
  cluster.half_size = 0.5 * (box.high - box.low) + Vec3::Constant(kClusterPadding_m);
  for (const int i : members)
    for (const Vec3& end : {capsules[i].from, capsules[i].to})
      cluster.radius = std::max(cluster.radius, (end - cluster.centre).norm() + capsules[i].radius);
  cluster.radius += kClusterPadding_m;
  cluster.capsules.assign(members.begin(), members.end());
  std::ranges::sort(cluster.capsules);
  return cluster;
}

/// Returns for the first 1, 2, … of the capsules their number times the surface of their box: the
/// less, the fewer queries look at them.
std::vector<double> costs_of_first(const Capsules& capsules, std::span<const int> members) {
  Box box;
  std::vector<double> costs;
  for (const int i : members) {
    box.add(capsules[i]);
    costs.push_back(static_cast<double>(costs.size() + 1) * box.half_surface());
  }
  return costs;
}

/// Divides the capsules of a frame, in the order of their middles along the axis on which it costs
/// least, until a cluster has no more than kMaxClusterCapsules.
void add_clusters(const Capsules& capsules, std::vector<int> members,
                  std::vector<CapsuleCluster>& clusters) {
  if (members.size() <= kMaxClusterCapsules) {
    clusters.push_back(cluster_of_capsules(capsules, members));
    return;
  }
  double least_cost = kInfinity;
  std::vector<int> first, second;
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = [&](int i) {
      return std::pair((capsules[i].from + capsules[i].to)[axis], i);
    };
    std::ranges::sort(members, {}, place);
    const std::vector<int> reversed(members.rbegin(), members.rend());
    const std::vector<double> of_first = costs_of_first(capsules, members),
                              of_last = costs_of_first(capsules, reversed);
    for (std::size_t count = 1; count < members.size(); ++count) {
      const double cost = of_first[count - 1] + of_last[members.size() - count - 1];
      if (cost >= least_cost) continue;
      least_cost = cost;
      const auto border = members.begin() + static_cast<std::ptrdiff_t>(count);
      first.assign(members.begin(), border);
      second.assign(border, members.end());
    }
  }
  add_clusters(capsules, std::move(first), clusters);
  add_clusters(capsules, std::move(second), clusters);
}

}  // namespace

CapsulePairs::CapsulePairs(const RobotModel& robot, std::vector<std::array<int, 2>> pairs)
    : pairs_(std::move(pairs)), cluster_of_(robot.capsules.size()) {
  std::map<int, std::vector<int>> capsules_of_frame;
  for (int i = 0; i < std::ssize(robot.capsules); ++i)
    capsules_of_frame[robot.capsules[i].frame].push_back(i);
  for (auto& [frame, members] : capsules_of_frame) add_clusters(robot.capsules, members, clusters_);
  for (int c = 0; c < std::ssize(clusters_); ++c)
    for (const int i : clusters_[c].capsules) cluster_of_[i] = c;
  index_pairs();
}

void CapsulePairs::erase_if(const std::function<bool(const std::array<int, 2>&)>& unwanted) {
  std::erase_if(pairs_, unwanted);
  index_pairs();
}

void CapsulePairs::index_pairs() {
  checked_.assign(cluster_of_.size() * cluster_of_.size(), 0);
  std::vector<char> partner(clusters_.size() * clusters_.size(), 0);
  for (const auto& [i, j] : pairs_) {
    checked_[i * cluster_of_.size() + j] = 1;
    partner[cluster_of_[i] * clusters_.size() + cluster_of_[j]] = 1;
  }
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    clusters_[c].partners.clear();
    for (std::size_t d = 0; d < clusters_.size(); ++d)
      if (partner[c * clusters_.size() + d]) clusters_[c].partners.push_back(static_cast<int>(d));
  }
}

}  // namespace morphe::collision
