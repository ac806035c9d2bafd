#include "stages/repair/path_smoothing.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "stages/repair/constants.hpp"

namespace morphe::repair {
namespace {

Eigen::Index random_index(Eigen::Index limit, std::mt19937_64& random) { return random() % limit; }
double random_fraction(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<double> edge_lengths(const RobotModel& robot, const std::vector<JointVector>& points) {
  const JointVector span = (robot.upper - robot.lower).cwiseMax(1e-6);
  std::vector<double> lengths;
  for (int k = 0; k + 1 < std::ssize(points); ++k)
    lengths.push_back((points[k + 1] - points[k]).cwiseQuotient(span).norm());
  return lengths;
}

/// Returns the rows of d inside (first, last) that minimise the cost for L = `length`, with all
/// other rows fixed.
Eigen::MatrixXd best_correction(const Eigen::MatrixXd& d, Eigen::Index first, Eigen::Index last,
                                double length) {
  const Eigen::Index m = last - first - 1;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(m, m);
  Eigen::MatrixXd right_side = Eigen::MatrixXd::Zero(m, d.cols());
  const auto add = [&](Eigen::Index row, std::initializer_list<double> stencil, double weight) {
    for (int i = 0; i < std::ssize(stencil); ++i) {
      const Eigen::Index a = row + i - first - 1;
      if (a < 0 || a >= m) continue;
      for (int j = 0; j < std::ssize(stencil); ++j) {
        const Eigen::Index b = row + j - first - 1;
        const double product = weight * stencil.begin()[i] * stencil.begin()[j];
        if (b >= 0 && b < m)
          normal(a, b) += product;
        else if (row + j >= 0 && row + j < d.rows())
          right_side.row(a) -= product * d.row(row + j);
      }
    }
  };
  for (Eigen::Index k = first - 1; k <= last; ++k) {
    add(k, {1}, 1);
    add(k, {-1, 1}, length * length);
    add(k, {1, -2, 1}, length * length * length * length);
  }
  return normal.ldlt().solve(right_side);
}

bool is_within_limits(const RobotModel& robot, const JointRows& rows) {
  const auto below = rows.rowwise() - robot.lower.transpose();
  const auto above = rows.rowwise() - robot.upper.transpose();
  return (below.array() >= 0).all() && (above.array() <= 0).all();
}

/// Returns true if the steps to the rows in (first, last] are free; otherwise sets `failed_row`.
/// The steps nearest to `failed_row`, where the previous check failed, are checked first.
bool are_steps_free(const PaddedWorld& world, const std::vector<double>& times,
                    const JointRows& rows, Eigen::Index first, Eigen::Index last,
                    collision::CollisionScratch& scratch, Eigen::Index& failed_row) {
  const Eigen::Index begin = std::clamp(failed_row, first + 1, last);
  for (Eigen::Index distance = 0; distance < last - first; ++distance) {
    for (const Eigen::Index k : {begin + distance, begin - distance - 1}) {
      if (k <= first || k > last) continue;
      if (is_motion_free(world, rows.row(k - 1), rows.row(k), times[k - 1], times[k], scratch))
        continue;
      failed_row = k;
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
    const auto locate = [&](double along, int& edge, JointVector& point) {
      for (edge = 0; edge + 1 < std::ssize(lengths) && along > lengths[edge]; ++edge)
        along -= lengths[edge];
      const double share = lengths[edge] > 0 ? std::min(1.0, along / lengths[edge]) : 0;
      point = vertices[edge] + share * (vertices[edge + 1] - vertices[edge]);
    };
    // The first attempt is the straight line from end to end, the others are between random points.
    double a = attempt == 0 ? 0 : random_fraction(random) * total;
    double b = attempt == 0 ? total : random_fraction(random) * total;
    if (a > b) std::swap(a, b);
    int first_edge = 0, last_edge = 0;
    JointVector from, to;
    locate(a, first_edge, from);
    locate(b, last_edge, to);
    // The rest of both edges is certified anew: a whole edge's bisection may not have examined it.
    const auto free = [&](const JointVector& p, const JointVector& q) {
      return is_motion_free(interval, p, q, scratch);
    };
    if (first_edge == last_edge || !free(from, to) || !free(vertices[first_edge], from) ||
        !free(to, vertices[last_edge + 1]))
      continue;
    std::vector<JointVector> shorter(vertices.begin(), vertices.begin() + first_edge + 1);
    if (a > 0) shorter.push_back(from);
    if (b < total) shorter.push_back(to);
    shorter.insert(shorter.end(), vertices.begin() + last_edge + 1, vertices.end());
    vertices = std::move(shorter);
  }
  return vertices;
}

JointRows resample(const RobotModel& robot, const std::vector<JointVector>& vertices, int count) {
  const std::ptrdiff_t edges = std::ssize(vertices) - 1;
  if (edges < 1 || edges > count - 1) return {};
  const std::vector<double> lengths = edge_lengths(robot, vertices);
  // Each edge starts with one step; every further step is added to the edge with the longest steps.
  std::vector<int> steps(edges, 1);
  for (std::ptrdiff_t remaining = count - 1 - edges; remaining > 0; --remaining) {
    int longest = 0;
    for (int e = 1; e < edges; ++e)
      if (lengths[e] / steps[e] > lengths[longest] / steps[longest]) longest = e;
    ++steps[longest];
  }
  JointRows rows(count, vertices.front().size());
  int row = 0;
  for (int e = 0; e < edges; ++e)
    for (int k = 0; k < steps[e]; ++k)
      rows.row(row++) = vertices[e] + (vertices[e + 1] - vertices[e]) * k / steps[e];
  rows.row(row) = vertices.back();
  return rows;
}

void pull_towards_original(const PaddedWorld& world, const std::vector<double>& times,
                           const JointRows& original, int attempts, std::mt19937_64& random,
                           JointRows& planned) {
  const Eigen::Index rows = planned.rows(), joints = planned.cols();
  if (rows < 3) return;
  const double length = std::max(kMinSmoothingLength, static_cast<double>(rows) * kSmoothingRatio);
  collision::CollisionScratch scratch;
  Eigen::Index failed_row = rows / 2;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const auto half_size = std::max<Eigen::Index>(2, rows >> (1 + random() % kMaxWindowHalvings));
    const Eigen::Index middle = 1 + random_index(rows - 2, random);
    const Eigen::Index first = std::max<Eigen::Index>(0, middle - half_size);
    const Eigen::Index last = std::min(rows - 1, middle + half_size);
    const int kind = attempt % 3;  // all joints, half of them, or one
    const Eigen::Index single = random_index(joints, random);
    JointVector mask(joints);
    for (int j = 0; j < joints; ++j) {
      const bool half = random() % 2 == 0;
      mask[j] = kind == 0 || (kind == 1 && half) || (kind == 2 && j == single) ? 1 : 0;
    }
    const Eigen::MatrixXd d = planned - original;
    const Eigen::MatrixXd correction_step =
        (best_correction(d, first, last, length) - d.middleRows(first + 1, last - first - 1)) *
        mask.asDiagonal();
    if (correction_step.isZero(0)) continue;
    for (const double step : kPullShares) {
      JointRows candidate = planned;
      auto window = candidate.middleRows(first + 1, last - first - 1);
      window += step * correction_step;
      if (!is_within_limits(*world.environment.robot, window) ||
          !are_steps_free(world, times, candidate, first, last, scratch, failed_row))
        continue;
      planned = std::move(candidate);
      break;
    }
  }
}

}  // namespace morphe::repair
