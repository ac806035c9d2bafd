#include "stages/repair/path_smoothing.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace morphe::repair {
namespace {

int random_index(int limit, std::mt19937_64& random) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
}
double random_fraction(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<double> edge_lengths(const RobotModel& robot,
                                 const std::vector<JointVector>& vertices) {
  const JointVector span = (robot.upper - robot.lower).cwiseMax(1e-6);
  std::vector<double> lengths;
  for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
    lengths.push_back((vertices[k + 1] - vertices[k]).cwiseQuotient(span).norm());
  return lengths;
}

/// Returns the rows of d that minimise the cost over the rows inside (first, last), with all other
/// rows fixed.
Eigen::MatrixXd best_correction(const Eigen::MatrixXd& d, int first, int last, double length) {
  const int m = last - first - 1;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(m, m);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(m, d.cols());
  const auto add = [&](int row, std::initializer_list<double> stencil, double weight) {
    for (int i = 0; i < static_cast<int>(stencil.size()); ++i) {
      const int a = row + i - first - 1;
      if (a < 0 || a >= m) continue;
      for (int j = 0; j < static_cast<int>(stencil.size()); ++j) {
        const int b = row + j - first - 1;
        const double product = weight * stencil.begin()[i] * stencil.begin()[j];
        if (b >= 0 && b < m)
          normal(a, b) += product;
        else if (row + j >= 0 && row + j < d.rows())
          right.row(a) -= product * d.row(row + j);
      }
    }
  };
  for (int k = first - 1; k <= last; ++k) {
    add(k, {1}, 1);
    add(k, {-1, 1}, length * length);
    add(k, {1, -2, 1}, length * length * length * length);
  }
  return normal.ldlt().solve(right);
}

bool is_within_limits(const RobotModel& robot, const JointRows& rows) {
  const auto below = rows.rowwise() - robot.lower.transpose();
  const auto above = rows.rowwise() - robot.upper.transpose();
  return (below.array() >= 0).all() && (above.array() <= 0).all();
}

/// Returns true if the steps to the rows in (first, last] are free. Checks `at` first and the rows
/// far from it last, because the next candidate is likely to fail at the same row; `at` becomes the
/// row of a failure.
bool are_steps_free(const PaddedWorld& world, const std::vector<double>& times,
                    const JointRows& rows, int first, int last,
                    collision::CollisionScratch& scratch, int& at) {
  const auto free = [&](int k) {
    const auto sample = static_cast<std::size_t>(k);
    return is_motion_free(world, rows.row(k - 1), rows.row(k), times[sample - 1], times[sample],
                          scratch);
  };
  const int begin = std::clamp(at, first + 1, last);
  for (int away = 0; away < last - first; ++away) {
    for (const int k : {begin + away, begin - away - 1}) {
      if (k <= first || k > last || free(k)) continue;
      at = k;
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<JointVector> shortcut(const IntervalWorld& interval, std::vector<JointVector> vertices,
                                  int attempts, std::mt19937_64& random) {
  collision::CollisionScratch scratch;
  for (int attempt = 0; attempt < attempts && vertices.size() > 2; ++attempt) {
    const std::vector<double> lengths = edge_lengths(*interval.world.environment.robot, vertices);
    double total = 0;
    for (const double length : lengths) total += length;
    const auto locate = [&](double along, std::size_t& edge, JointVector& point) {
      for (edge = 0; edge + 1 < lengths.size() && along > lengths[edge]; ++edge)
        along -= lengths[edge];
      const double part = lengths[edge] > 0 ? std::min(1.0, along / lengths[edge]) : 0;
      point = vertices[edge] + part * (vertices[edge + 1] - vertices[edge]);
    };
    // The first attempt is the straight line from end to end, the others are between random points.
    double a = attempt == 0 ? 0 : random_fraction(random) * total;
    double b = attempt == 0 ? total : random_fraction(random) * total;
    if (a > b) std::swap(a, b);
    std::size_t first_edge = 0, last_edge = 0;
    JointVector from, to;
    locate(a, first_edge, from);
    locate(b, last_edge, to);
    // The remaining parts of the two edges are certified separately: a part of a line may be within
    // the tolerance band that the bisection of the whole line never had to examine.
    const auto free = [&](const JointVector& p, const JointVector& q) {
      return is_motion_free(interval, p, q, scratch);
    };
    if (first_edge == last_edge || !free(from, to) || !free(vertices[first_edge], from) ||
        !free(to, vertices[last_edge + 1])) {
      continue;
    }
    std::vector<JointVector> shorter(vertices.begin(), vertices.begin() + first_edge + 1);
    if (a > 0) shorter.push_back(from);
    if (b < total) shorter.push_back(to);
    shorter.insert(shorter.end(), vertices.begin() + last_edge + 1, vertices.end());
    vertices = std::move(shorter);
  }
  return vertices;
}

JointRows resample(const RobotModel& robot, const std::vector<JointVector>& vertices, int count) {
  const int edges = static_cast<int>(vertices.size()) - 1;
  if (edges < 1 || edges > count - 1) return {};
  const std::vector<double> lengths = edge_lengths(robot, vertices);
  // Each edge starts with one step; every further step is added to the edge with the longest steps.
  std::vector<int> steps(edges, 1);
  for (int left = count - 1 - edges; left > 0; --left) {
    std::size_t longest = 0;
    for (std::size_t e = 1; e < steps.size(); ++e)
      if (lengths[e] / steps[e] > lengths[longest] / steps[longest]) longest = e;
    ++steps[longest];
  }
  JointRows rows(count, vertices.front().size());
  int row = 0;
  for (std::size_t e = 0; e < steps.size(); ++e)
    for (int k = 0; k < steps[e]; ++k)
      rows.row(row++) = vertices[e] + (vertices[e + 1] - vertices[e]) * k / steps[e];
  rows.row(row) = vertices.back();
  return rows;
}

void pull_towards_original(const PaddedWorld& world, const std::vector<double>& times,
                           const JointRows& original, int attempts, std::mt19937_64& random,
                           JointRows& planned) {
  constexpr std::array<double, 4> kStepShares = {1, 0.5, 0.25, 0.1};
  const int rows = static_cast<int>(planned.rows()), joints = static_cast<int>(planned.cols());
  if (rows < 3) return;
  const double length = std::max(2.0, rows / 8.0);
  collision::CollisionScratch scratch;
  int failed_at = rows / 2;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const int half_size = std::max(2, rows >> (1 + random() % 4));
    const int middle = 1 + random_index(rows - 2, random);
    const int first = std::max(0, middle - half_size);
    const int last = std::min(rows - 1, middle + half_size);
    const int kind = attempt % 3;  // all joints, half of them, or one
    const int single = random_index(joints, random);
    JointVector chosen(joints);
    for (int j = 0; j < joints; ++j) {
      const bool half = random() % 2 == 0;
      chosen[j] = kind == 0 || (kind == 1 && half) || (kind == 2 && j == single) ? 1 : 0;
    }
    const Eigen::MatrixXd d = planned - original;
    const Eigen::MatrixXd towards =
        (best_correction(d, first, last, length) - d.middleRows(first + 1, last - first - 1)) *
        chosen.asDiagonal();
    if (towards.isZero(0)) continue;
    for (const double step : kStepShares) {
      JointRows candidate = planned;
      auto moved = candidate.middleRows(first + 1, last - first - 1);
      moved += step * towards;
      if (!is_within_limits(*world.environment.robot, moved) ||
          !are_steps_free(world, times, candidate, first, last, scratch, failed_at)) {
        continue;
      }
      planned = std::move(candidate);
      break;
    }
  }
}

}  // namespace morphe::repair
