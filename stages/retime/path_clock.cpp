#include "stages/retime/path_clock.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::retime {
namespace {

/// A recorded step may ask for this many times the joints' full speed before its clock is
/// stretched; below, the time law slows down smoothly.
constexpr double kRecordedHaste = 4;
constexpr double kPause = 0.02;     ///< of the joints' full speed
constexpr double kFullSpeed = 100;  ///< of a joint whose limit says more, or nothing [rad/s]

double step_of(const RobotTable& robot, const JointPath& path, std::size_t i, double recorded_s,
               bool keep_pauses) {
  const auto row = static_cast<Eigen::Index>(i);
  const JointVector way = (path.position.row(row + 1) - path.position.row(row)).transpose();
  const double full_speed_s =
      way.cwiseAbs().cwiseQuotient(robot.velocity.cwiseMin(kFullSpeed)).maxCoeff();
  const bool planned = path.origin[i] == Origin::planned || path.origin[i + 1] == Origin::planned;
  const double least_s = planned ? full_speed_s : full_speed_s / kRecordedHaste;
  const double most_s = keep_pauses ? recorded_s : std::min(recorded_s, full_speed_s / kPause);
  return std::max(most_s, least_s);
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

ClockedPath clock_path(const RobotTable& robot, const JointPath& path, double step_s,
                       bool keep_pauses) {
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
    const double step = step_of(robot, path, i, recorded_s, keep_pauses);
    const int parts = std::max(1, static_cast<int>(std::ceil(step / step_s - 1e-6)));
    const double begin = out.clock.back();
    for (int part = 1; part <= parts; ++part) {
      const double share = part == parts ? 1.0 : static_cast<double>(part) / parts;
      add(begin + share * step, row_of(i) + share * (row_of(i + 1) - row_of(i)),
          from_s + share * recorded_s, path.origin[share < 0.5 ? i : i + 1]);
    }
  }
  // Even a path of one point becomes a motion of a few controller periods.
  if (out.clock.back() == 0) {
    add(step_s, rows.back(), out.demonstration_time.back(), out.origin.back());
  }
  const double longer = std::max(1.0, step_s / out.clock.back());
  for (double& clock : out.clock) clock *= longer;
  out.position.resize(static_cast<Eigen::Index>(rows.size()), path.position.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.position.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
  return out;
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

}  // namespace morphe::retime
