#include "stages/retime/path_clock.hpp"

#include <algorithm>
#include <cmath>

namespace morphe {
namespace {

/// A recorded step may ask for this many times the joints' full speed before its clock is
/// stretched; below, the time law slows down smoothly.
constexpr double kRecordedHaste = 4;
constexpr double kMostStretch = 6;
/// Samples of a spline when its clock is stretched: two a knot even where it is stretched most.
constexpr std::size_t kCellsPerKnot = 12;

double least_step_s(const RobotTable& robot, const JointPath& path, std::size_t i) {
  const auto row = static_cast<Eigen::Index>(i);
  const JointVector way = (path.position.row(row + 1) - path.position.row(row)).transpose();
  const double full_speed_s = way.cwiseAbs().cwiseQuotient(robot.velocity).maxCoeff();
  const bool planned = path.origin[i] == Origin::planned || path.origin[i + 1] == Origin::planned;
  return planned ? full_speed_s : full_speed_s / kRecordedHaste;
}

/// The largest of velocity, acceleration^(1/2), jerk^(1/3) over the limits: the pace is too fast by
/// this factor.
double demand(const RobotTable& robot, const JointRows& q) {
  const auto worst = [&](Eigen::Index order, const JointVector& limit) {
    return q.row(order).transpose().cwiseAbs().cwiseQuotient(limit).maxCoeff();
  };
  return std::max({worst(1, robot.velocity), std::sqrt(worst(2, robot.acceleration)),
                   std::cbrt(worst(3, robot.jerk))});
}

/// Each value replaced by the largest (the mean) of those at most `reach` away.
std::vector<double> widened(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, reach));
    const auto to =
        values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), i + reach + 1));
    out.push_back(*std::max_element(from, to));
  }
  return out;
}
std::vector<double> averaged(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t from = i - std::min(i, reach), to = std::min(values.size(), i + reach + 1);
    double sum = 0;
    for (std::size_t k = from; k < to; ++k) sum += values[k];
    out.push_back(sum / static_cast<double>(to - from));
  }
  return out;
}

std::size_t sample_before(const ClockedPath& path, double clock) {
  const auto after = std::upper_bound(path.clock.begin(), path.clock.end(), clock);
  const auto index = static_cast<std::size_t>(after - path.clock.begin());
  return std::min(index == 0 ? 0 : index - 1, path.clock.size() - 2);
}

double share_at(const ClockedPath& path, std::size_t i, double clock) {
  const double span = path.clock[i + 1] - path.clock[i];
  return span > 0 ? std::clamp((clock - path.clock[i]) / span, 0.0, 1.0) : 1.0;
}

}  // namespace

ClockedPath clock_path(const RobotTable& robot, const JointPath& path, double step_s) {
  const std::size_t samples = path.demonstration_time.size();
  ClockedPath out;
  std::vector<JointVector> rows;
  const auto add = [&](double clock, const JointVector& q, double time_s, Origin origin) {
    out.clock.push_back(clock);
    rows.push_back(q);
    out.demonstration_time.push_back(time_s);
    out.origin.push_back(origin);
  };
  const auto row_of = [&](std::size_t i) -> JointVector {
    return path.position.row(static_cast<Eigen::Index>(i)).transpose();
  };
  add(0, row_of(0), path.demonstration_time[0], path.origin[0]);
  for (std::size_t i = 0; i + 1 < samples; ++i) {
    const double from_s = path.demonstration_time[i];
    const double recorded_s = std::max(0.0, path.demonstration_time[i + 1] - from_s);
    const double step = std::max(recorded_s, least_step_s(robot, path, i));
    const int parts = std::max(1, static_cast<int>(std::ceil(step / step_s - 1e-6)));
    const double begin = out.clock.back();
    for (int part = 1; part <= parts; ++part) {
      const double share = part == parts ? 1.0 : static_cast<double>(part) / parts;
      add(begin + share * step, row_of(i) + share * (row_of(i + 1) - row_of(i)),
          from_s + share * recorded_s, path.origin[share < 0.5 ? i : i + 1]);
    }
  }
  // Even a path of one point becomes a motion of a few controller periods.
  if (out.clock.back() < step_s) {
    add(step_s, rows.back(), out.demonstration_time.back(), out.origin.back());
  }
  out.position.resize(static_cast<Eigen::Index>(rows.size()), path.position.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.position.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
  out.stretch.assign(rows.size(), 1.0);
  return out;
}

ClockedPath stretch_clock(const RobotTable& robot, const ClockedPath& path,
                          const JointSpline& spline, double bearable) {
  const auto cells = static_cast<std::size_t>(spline.intervals) * kCellsPerKnot;
  const double cell = spline.length / static_cast<double>(cells);
  const auto at = [&](std::size_t i) {
    return i == cells ? spline.length : static_cast<double>(i) * cell;
  };
  ClockedPath out;
  out.position.resize(static_cast<Eigen::Index>(cells) + 1, spline.coefficient.cols());
  JointRows q;
  for (std::size_t i = 0; i <= cells; ++i) {
    evaluate(spline, at(i), q);
    out.position.row(static_cast<Eigen::Index>(i)) = q.row(0);
    out.demonstration_time.push_back(demonstration_time_at(path, at(i)));
    out.origin.push_back(origin_at(path, at(i)));
    out.stretch.push_back(std::clamp(demand(robot, q) / bearable, 1.0, kMostStretch));
  }
  out.stretch = widened(out.stretch, kCellsPerKnot * 4);
  for (int pass = 0; pass < 3; ++pass) out.stretch = averaged(out.stretch, kCellsPerKnot * 2);
  out.clock.push_back(0);
  for (std::size_t i = 0; i < cells; ++i) {
    out.clock.push_back(out.clock.back() + cell * 0.5 * (out.stretch[i] + out.stretch[i + 1]));
  }
  return out;
}

double stretch_at(const ClockedPath& path, double clock) {
  const std::size_t i = sample_before(path, clock);
  const double share = share_at(path, i, clock);
  return (1 - share) * path.stretch[i] + share * path.stretch[i + 1];
}

double demonstration_time_at(const ClockedPath& path, double clock) {
  const std::size_t i = sample_before(path, clock);
  const double share = share_at(path, i, clock);
  return (1 - share) * path.demonstration_time[i] + share * path.demonstration_time[i + 1];
}

Origin origin_at(const ClockedPath& path, double clock) {
  const std::size_t i = sample_before(path, clock);
  return path.origin[share_at(path, i, clock) < 0.5 ? i : i + 1];
}

}  // namespace morphe
