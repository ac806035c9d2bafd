#include "pipeline/study/retime_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/random_stream.hpp"

namespace morphe::study {
namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;

double log_uniform(math::RandomStream& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

RobotModel random_robot(math::RandomStream& random, Eigen::Index joints) {
  RobotModel robot;
  robot.name = "random";
  robot.velocity.resize(joints);
  robot.acceleration.resize(joints);
  robot.jerk.resize(joints);
  for (Eigen::Index k = 0; k < joints; ++k) {
    robot.joint_names.push_back("joint");
    robot.velocity[k] = log_uniform(random, 0.5, 6);
    robot.acceleration[k] = robot.velocity[k] * log_uniform(random, 2, 20);
    robot.jerk[k] = robot.acceleration[k] * log_uniform(random, 5, 100);
  }
  return robot;
}

/// Adds three sines per joint, with periods that are not short relative to the path.
void add_sines(math::RandomStream& random, JointPath& path) {
  const double duration_s = path.demonstration_time.back();
  for (Eigen::Index k = 0; k < path.position.cols(); ++k) {
    for (int wave = 1; wave <= 3; ++wave) {
      const double amplitude = random.uniform(0, 0.8) / (wave * wave);
      const double phase = random.uniform(0, kFullTurn_rad);
      const double rate = kFullTurn_rad * wave * random.uniform(0.3, 1) / std::max(0.6, duration_s);
      for (Eigen::Index i = 0; i < path.position.rows(); ++i) {
        path.position(i, k) += amplitude * std::sin(phase + rate * path.demonstration_time[i]);
      }
    }
  }
}

void add_noise(math::RandomStream& random, JointPath& path) {
  const double amplitude = log_uniform(random, 1e-5, 1e-2);
  for (Eigen::Index i = 0; i < path.position.size(); ++i)
    path.position.data()[i] += random.uniform(-amplitude, amplitude);
}

/// Adds a triangle wave to some joints.
void add_reversals(math::RandomStream& random, JointPath& path) {
  for (Eigen::Index k = 0; k < path.position.cols(); ++k) {
    if (random.bernoulli(0.5)) continue;
    const double amplitude = random.uniform(0.01, 0.3), period = random.uniform(0.2, 1);
    for (Eigen::Index i = 0; i < path.position.rows(); ++i) {
      const double periods = path.demonstration_time[i] / period;
      path.position(i, k) += amplitude * std::abs(2 * (periods - std::floor(periods)) - 1);
    }
  }
}

/// Returns a random share, up to `max_share`, of a count, rounded down.
Eigen::Index random_part(math::RandomStream& random, double max_share, double count) {
  return static_cast<Eigen::Index>(random.uniform(0, max_share) * count);
}

/// Replaces the later ones of a series of waypoints by the first, on request with its time.
void repeat_waypoint(math::RandomStream& random, JointPath& path, bool same_time) {
  const auto rows = static_cast<double>(path.position.rows());
  const Eigen::Index from = random_part(random, 0.9, rows);
  const Eigen::Index to = std::min(path.position.rows(), from + 1 + random_part(random, 0.2, rows));
  for (Eigen::Index i = from + 1; i < to; ++i) {
    path.position.row(i) = path.position.row(from);
    if (!same_time) continue;
    path.demonstration_time[i] = path.demonstration_time[from];
  }
}

RandomPath begin_path(math::RandomStream& random, int joints, int waypoints, double duration_s) {
  RandomPath out;
  out.robot = random_robot(random, joints);
  out.path.position = JointRows::Zero(waypoints, joints);
  out.path.origin.assign(waypoints, SampleOrigin::mapped);
  for (int i = 0; i < waypoints; ++i)
    out.path.demonstration_time.push_back(duration_s * i / std::max(1, waypoints - 1));
  return out;
}

void set_range(RandomPath& out, double margin) {
  out.robot.lower = out.path.position.colwise().minCoeff().transpose().array() - margin;
  out.robot.upper = out.path.position.colwise().maxCoeff().transpose().array() + margin;
}

struct PathSizes {
  int joints, waypoints;  ///< maximum numbers
  double longest_step_s;  ///< of paths with few waypoints
  double max_position;    ///< range of random positions [rad]
};

RandomPath sample_path(math::RandomStream random, const PathSizes& sizes) {
  const int joints = 1 + static_cast<int>(random.uniform(0, sizes.joints));
  const int waypoints = static_cast<int>(std::lround(log_uniform(random, 2, sizes.waypoints)));
  const double step_s =
      waypoints < 30 ? random.uniform(0.01, sizes.longest_step_s) : random.uniform(0.004, 0.02);
  RandomPath out = begin_path(random, joints, waypoints, step_s * waypoints);
  JointPath& path = out.path;
  if (waypoints < 30 && random.bernoulli(0.5)) {
    for (Eigen::Index i = 0; i < path.position.size(); ++i)
      path.position.data()[i] = random.uniform(-sizes.max_position, sizes.max_position);
  } else {
    add_sines(random, path);
  }
  if (random.bernoulli(0.3)) add_reversals(random, path);
  if (random.bernoulli(0.4)) add_noise(random, path);
  while (random.bernoulli(0.3)) repeat_waypoint(random, path, false);
  while (random.bernoulli(0.3)) repeat_waypoint(random, path, true);
  if (random.bernoulli(0.3)) {
    const auto still_joint = static_cast<Eigen::Index>(random.uniform(0, joints));
    path.position.col(still_joint).setConstant(path.position(0, still_joint));
  }
  if (random.bernoulli(0.2)) {
    const Eigen::Index from = random_part(random, 0.7, waypoints);
    const auto count = static_cast<Eigen::Index>(0.3 * waypoints);
    std::fill_n(path.origin.begin() + from, count, SampleOrigin::planned);
  }
  if (random.bernoulli(0.15)) out.robot.jerk.setConstant(kInfinity);
  set_range(out, random.bernoulli(0.3) ? 0 : 0.5);
  return out;
}

}  // namespace

RandomPath smooth_path(std::uint64_t seed, std::uint64_t index, int joints, int waypoints,
                       double duration_s) {
  math::RandomStream random(seed, fmt::format("path {}", index));
  RandomPath out = begin_path(random, joints, waypoints, duration_s);
  add_sines(random, out.path);
  set_range(out, 1);
  return out;
}

RandomPath random_path(std::uint64_t seed, std::uint64_t index) {
  return sample_path({seed, fmt::format("path {}", index)}, {44, 2000, 0.3, 1});
}

RandomPath short_path(std::uint64_t seed, std::uint64_t index) {
  math::RandomStream random(seed, fmt::format("sample rate {}", index));
  RandomPath out = sample_path({seed, fmt::format("small path {}", index)}, {4, 12, 0.06, 0.2});
  out.sample_rate_hz = log_uniform(random, 50, 500);
  return out;
}

LimitUsage measure_limit_usage(const RobotModel& robot, const Trajectory& t) {
  LimitUsage usage;
  usage.position_excess = -kInfinity;
  usage.time_increases = t.samples() > 1;
  const Eigen::Index last = t.position.rows() - 1;
  usage.at_rest = last > 0 && t.velocity.row(0).isZero(0) && t.velocity.row(last).isZero(0) &&
                  t.acceleration.row(0).isZero(0) && t.acceleration.row(last).isZero(0);
  for (Eigen::Index i = 0; i < last; ++i) {
    const double h = t.time[i + 1] - t.time[i];
    usage.time_increases = usage.time_increases && h > 0;
    for (Eigen::Index k = 0; k < t.position.cols(); ++k) {
      // p = p0 + v0 s + a0 s^2 / 2 + b s^3 + c s^4 + d s^5; dp, dv and da are the differences to
      // its first three terms at the end, multiplied by h^0, h and h^2.
      const double p0 = t.position(i, k), v0 = t.velocity(i, k), a0 = t.acceleration(i, k);
      const double dp = t.position(i + 1, k) - p0 - h * (v0 + 0.5 * h * a0);
      const double dv = (t.velocity(i + 1, k) - v0 - h * a0) * h;
      const double da = (t.acceleration(i + 1, k) - a0) * h * h;
      const double b = (10 * dp - 4 * dv + 0.5 * da) / (h * h * h);
      const double c = (-15 * dp + 7 * dv - da) / (h * h * h * h);
      const double d = (6 * dp - 3 * dv + 0.5 * da) / (h * h * h * h * h);
      for (int part = 0; part <= 16; ++part) {
        const double s = h * part / 16;
        const double p = p0 + s * (v0 + s * (0.5 * a0 + s * (b + s * (c + s * d))));
        const double v = v0 + s * (a0 + s * (3 * b + s * (4 * c + s * 5 * d)));
        const double a = a0 + s * (6 * b + s * (12 * c + s * 20 * d));
        const double j = 6 * b + s * (24 * c + s * 60 * d);
        usage.velocity = std::max(usage.velocity, std::abs(v) / robot.velocity[k]);
        usage.acceleration = std::max(usage.acceleration, std::abs(a) / robot.acceleration[k]);
        usage.jerk = std::max(usage.jerk, std::abs(j) / robot.jerk[k]);
        usage.position_excess =
            std::max({usage.position_excess, robot.lower[k] - p, p - robot.upper[k]});
      }
    }
  }
  return usage;
}

}  // namespace morphe::study
