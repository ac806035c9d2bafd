#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

// The numbers below were chosen by hand, not measured, unless a reason is given.
constexpr int kLoopSampleCount = 21;       ///< positions of the driver over its range
constexpr int kLoopIterationCount = 60;    ///< of Gauss-Newton, per sample
constexpr double kGapWeight_per_m2 = 1e6;  ///< of the gap, so that springs open it by < 0.1 mm
constexpr double kSpringWeight = 1e-2;     ///< of the stiffest spring [per rad^2]
constexpr double kRestWeight = 1e-6;       ///< of the change since the last sample [per rad^2]
constexpr double kClosedGap_m = 5e-4;      ///< a loop with a larger gap cannot be closed
/// A coupling may open the loop by so much, which the pad of a fingertip yields, and differ by so
/// much from the joint's path.
constexpr double kMaxLinearGap_m = 2e-3, kMaxDeviation_rad = 5 * kRadPerDegree;
constexpr double kHeldRange_rad = 1e-3;  ///< a joint that moves less over all samples is held

/// A loop with the joints that move its ends relative to each other.
struct Linkage {
  const MjcfModel& model;
  const MjcfLoop& loop;
  const MjcfJointIndex& joints;
  MjcfJoint* driver = nullptr;
  std::vector<MjcfJoint*> passive = {};

  /// Returns the position of a joint that is the driver, passive, or follows one; others stay at
  /// their reference, which moves both ends equally.
  double position(const MjcfJoint& joint, double driven, const Eigen::VectorXd& q) const {
    double ratio = 1, offset = 0;
    const MjcfJoint* root = &joint;
    for (; root->coupling; root = joints.at(root->coupling->driver)) {
      offset += ratio * root->coupling->offset;
      ratio *= root->coupling->ratio;
      if (root->coupling->driver.empty()) return offset;
    }
    if (root == driver) return offset + ratio * driven;
    const auto found = std::ranges::find(passive, root);
    const double own = found == passive.end() ? root->reference : q[found - passive.begin()];
    return offset + ratio * own;
  }

  Vec3 point_in_world(int body, Vec3 point, double driven, const Eigen::VectorXd& q) const {
    for (; body >= 0; body = model.bodies[body].parent) {
      const MjcfBody& owner = model.bodies[body];
      for (auto joint = owner.joints.rbegin(); joint != owner.joints.rend(); ++joint)
        point = joint->motion(position(*joint, driven, q)) * point;
      point = owner.parent_from_body * point;
    }
    return point;
  }

  Vec3 gap(double driven, const Eigen::VectorXd& q) const {
    return point_in_world(loop.first, loop.point_in_first, driven, q) -
           point_in_world(loop.second, loop.point_in_second, driven, q);
  }

  /// Returns the residuals that are minimised: the gap, the springs, and the change since `last`.
  Eigen::VectorXd residuals(double driven, const Eigen::VectorXd& q,
                            const Eigen::VectorXd& last) const {
    double stiffest = 0;
    for (const MjcfJoint* joint : passive) stiffest = std::max(stiffest, joint->stiffness);
    Eigen::VectorXd r(3 + 2 * q.size());
    r.head<3>() = std::sqrt(kGapWeight_per_m2) * gap(driven, q);
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const MjcfJoint& joint = *passive[static_cast<std::size_t>(k)];
      const double share = stiffest > 0 ? joint.stiffness / stiffest : 0;
      r[3 + k] = std::sqrt(kSpringWeight * share) * (q[k] - joint.spring_reference);
      r[3 + q.size() + k] = std::sqrt(kRestWeight) * (q[k] - last[k]);
    }
    return r;
  }

  Eigen::VectorXd within_limits(Eigen::VectorXd q) const {
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const auto& range = passive[static_cast<std::size_t>(k)]->range;
      if (range) q[k] = std::clamp(q[k], (*range)[0], (*range)[1]);
    }
    return q;
  }

  /// Returns true if a joint is at its limit and the gradient pushes it beyond.
  bool is_stopped(Eigen::Index k, double value, double gradient) const {
    const auto& range = passive[static_cast<std::size_t>(k)]->range;
    if (!range) return false;
    return (value <= (*range)[0] && gradient > 0) || (value >= (*range)[1] && gradient < 0);
  }

  /// Minimises the residuals within the limits, from `q` (damped Gauss-Newton).
  Eigen::VectorXd solve(double driven, Eigen::VectorXd q) const {
    constexpr double kStep_rad = 1e-7, kMinDamping = 1e-12, kMaxDamping = 1e8;
    const Eigen::VectorXd last = q;
    double damping = 1e-3;
    for (int i = 0; i < kLoopIterationCount && damping < kMaxDamping; ++i) {
      const Eigen::VectorXd r = residuals(driven, q, last);
      Eigen::MatrixXd jacobian(r.size(), q.size());
      for (Eigen::Index k = 0; k < q.size(); ++k) {
        Eigen::VectorXd moved = q;
        moved[k] += kStep_rad;
        jacobian.col(k) = (residuals(driven, moved, last) - r) / kStep_rad;
      }
      const Eigen::VectorXd gradient = jacobian.transpose() * r;
      for (Eigen::Index k = 0; k < q.size(); ++k)
        if (is_stopped(k, q[k], gradient[k])) jacobian.col(k).setZero();
      Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
      normal.diagonal() = (1 + damping) * normal.diagonal().array() + kMinDamping;
      const Eigen::VectorXd step = normal.ldlt().solve(jacobian.transpose() * r);
      const Eigen::VectorXd next = within_limits(q - step);
      const bool better = residuals(driven, next, last).squaredNorm() < r.squaredNorm();
      if (better) q = next;
      damping = better ? std::max(kMinDamping, damping / 10) : damping * 10;
    }
    return q;
  }
};

/// The positions of the driver and those of the passive joints, [samples].
struct LoopPath {
  std::vector<double> driver;
  std::vector<Eigen::VectorXd> passive;
  double largest_gap_m = 0;
};

/// Follows the loop over the driver's range, in both directions from its reference.
LoopPath follow_loop(const Linkage& linkage) {
  const auto [lower, upper] = *linkage.driver->range;
  LoopPath path;
  for (int k = 0; k < kLoopSampleCount; ++k)
    path.driver.push_back(lower + (upper - lower) * k / (kLoopSampleCount - 1));
  const double start = std::clamp(linkage.driver->reference, lower, upper);
  const auto first = std::ranges::min_element(
      path.driver, {}, [&](double driven) { return std::abs(driven - start); });
  const std::ptrdiff_t middle = first - path.driver.begin();
  Eigen::VectorXd q(std::ssize(linkage.passive));
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = linkage.passive[static_cast<std::size_t>(k)]->reference;
  path.passive.assign(path.driver.size(), linkage.within_limits(q));
  const auto solve = [&](std::ptrdiff_t k, std::ptrdiff_t from) {
    path.passive[k] = linkage.solve(path.driver[k], path.passive[from]);
    path.largest_gap_m =
        std::max(path.largest_gap_m, linkage.gap(path.driver[k], path.passive[k]).norm());
  };
  solve(middle, middle);
  for (std::ptrdiff_t k = middle + 1; k < kLoopSampleCount; ++k) solve(k, k - 1);
  for (std::ptrdiff_t k = middle - 1; k >= 0; --k) solve(k, k + 1);
  return path;
}

/// Returns the straight line through the path of a passive joint, by least squares.
MjcfCoupling fit_coupling(const Linkage& linkage, const LoopPath& path, Eigen::Index joint) {
  double mean_driver = 0, mean = 0, covariance = 0, variance = 0;
  double lowest = kInfinity, highest = -kInfinity;
  const double count = static_cast<double>(path.driver.size());
  for (std::size_t k = 0; k < path.driver.size(); ++k) {
    mean_driver += path.driver[k] / count;
    mean += path.passive[k][joint] / count;
    lowest = std::min(lowest, path.passive[k][joint]);
    highest = std::max(highest, path.passive[k][joint]);
  }
  if (highest - lowest < kHeldRange_rad) return {"", 0, mean};
  for (std::size_t k = 0; k < path.driver.size(); ++k) {
    covariance += (path.driver[k] - mean_driver) * (path.passive[k][joint] - mean);
    variance += (path.driver[k] - mean_driver) * (path.driver[k] - mean_driver);
  }
  const double ratio = covariance / variance;
  return {linkage.driver->name, ratio, mean - ratio * mean_driver};
}

/// Couples the passive joints of a linkage to its driver. Returns a clause on how well straight
/// lines describe it, "" if they do not.
std::string couple_passive_joints(const Linkage& linkage) {
  const LoopPath path = follow_loop(linkage);
  if (path.largest_gap_m > kClosedGap_m) return "";
  std::vector<MjcfCoupling> couplings;
  for (Eigen::Index k = 0; k < std::ssize(linkage.passive); ++k)
    couplings.push_back(fit_coupling(linkage, path, k));
  double gap_m = 0, deviation_rad = 0;
  for (std::size_t i = 0; i < path.driver.size(); ++i) {
    Eigen::VectorXd q = path.passive[i];
    for (Eigen::Index k = 0; k < q.size(); ++k)
      q[k] = couplings[static_cast<std::size_t>(k)].offset +
             couplings[static_cast<std::size_t>(k)].ratio * path.driver[i];
    gap_m = std::max(gap_m, linkage.gap(path.driver[i], q).norm());
    deviation_rad = std::max(deviation_rad, (q - path.passive[i]).cwiseAbs().maxCoeff());
  }
  if (gap_m > kMaxLinearGap_m || deviation_rad > kMaxDeviation_rad) return "";
  std::vector<std::string> clauses;
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    clauses.push_back(couplings[k].driver.empty()
                          ? fmt::format("{} is held", linkage.passive[k]->name)
                          : fmt::format("{} turns {:.3g} times as far", linkage.passive[k]->name,
                                        couplings[k].ratio));
    linkage.passive[k]->coupling = couplings[k];
  }
  return fmt::format("follows {} along straight lines, with gaps up to {:.2g} mm: {}",
                     linkage.driver->name, gap_m * kMillimetresPerMetre, fmt::join(clauses, ", "));
}

/// Returns the indices of a body and all bodies that carry it.
std::vector<int> bodies_above(const MjcfModel& model, int body) {
  std::vector<int> found;
  for (; body >= 0; body = model.bodies[body].parent) found.push_back(body);
  return found;
}

/// Finds the passive joints between the ends of a loop and their only driver, which must be a
/// joint with limits. Returns false if the loop is of another kind.
bool find_linkage_joints(const std::set<std::string>& driven, MjcfModel& model, Linkage& linkage) {
  const std::vector<int> first = bodies_above(model, linkage.loop.first);
  const std::vector<int> second = bodies_above(model, linkage.loop.second);
  std::set<MjcfJoint*> drivers;
  const auto collect = [&](const std::vector<int>& path, const std::vector<int>& other) {
    for (const int body : path) {
      if (std::ranges::count(other, body) > 0) return;
      for (MjcfJoint& joint : model.bodies[body].joints) {
        MjcfJoint* root = &joint;
        while (root->coupling && !root->coupling->driver.empty())
          root = linkage.joints.at(root->coupling->driver);
        if (root->coupling) continue;  // held
        if (is_driven(model, *root, driven))
          drivers.insert(root);
        else if (std::ranges::count(linkage.passive, root) == 0)
          linkage.passive.push_back(root);
      }
    }
  };
  collect(first, second);
  collect(second, first);
  if (drivers.size() != 1 || linkage.passive.empty()) return false;
  linkage.driver = *drivers.begin();
  return linkage.driver->range.has_value();
}

}  // namespace

void close_mjcf_loops(const std::set<std::string>& driven, MjcfModel& model) {
  const MjcfJointIndex joints = joints_by_name(model);
  std::vector<std::string> open;
  for (const MjcfLoop& loop : model.loops) {
    Linkage linkage{model, loop, joints};
    const std::string clause =
        find_linkage_joints(driven, model, linkage) ? couple_passive_joints(linkage) : "";
    if (clause.empty())
      open.push_back(loop.name);
    else
      model.to_check.push_back(
          fmt::format("{}: the loop {} {}", model.file.string(), loop.name, clause));
  }
  if (open.empty()) return;
  model.notes.push_back(fmt::format("{}: closed loops are left open, as a URDF is a tree: {}",
                                    model.file.string(), fmt::join(open, ", ")));
}

}  // namespace morphe::robot
