#include "stages/retime/path_parameter.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::retime {
namespace {

/// Factor by which a recorded step may exceed the joints' full speed before its parameter interval
/// is stretched; below this, the time parametrisation slows down smoothly.
constexpr double kMaxRecordedSpeedRatio = 4;
constexpr double kPauseSpeedRatio = 0.02;  ///< share of the joints' full speed
/// for a joint with a higher limit or without a limit
constexpr double kMaxJointSpeed_rad_s = 100;

double step_of(const RobotModel& robot, const JointPath& path, std::size_t i, double recorded_s,
               bool keep_pauses) {
  const auto row = static_cast<Eigen::Index>(i);
  const JointVector way = (path.position.row(row + 1) - path.position.row(row)).transpose();
  const double full_speed_s =
      way.cwiseAbs().cwiseQuotient(robot.velocity.cwiseMin(kMaxJointSpeed_rad_s)).maxCoeff();
  const bool planned =
      path.origin[i] == SampleOrigin::planned || path.origin[i + 1] == SampleOrigin::planned;
  const double least_s = planned ? full_speed_s : full_speed_s / kMaxRecordedSpeedRatio;
  const double most_s =
      keep_pauses ? recorded_s : std::min(recorded_s, full_speed_s / kPauseSpeedRatio);
  return std::max(most_s, least_s);
}

std::size_t sample_before(const ParameterizedPath& path, double clock) {
  const auto after = std::upper_bound(path.parameter.begin(), path.parameter.end(), clock);
  const auto index = static_cast<std::size_t>(after - path.parameter.begin());
  return std::min(index == 0 ? 0 : index - 1, path.parameter.size() - 2);
}

double share_at(const ParameterizedPath& path, std::size_t i, double clock) {
  const double span = path.parameter[i + 1] - path.parameter[i];
  return span > 0 ? std::clamp((clock - path.parameter[i]) / span, 0.0, 1.0) : 1.0;
}

}  // namespace

ParameterizedPath parameterize_path(const RobotModel& robot, const JointPath& path, double step_s,
                                    bool keep_pauses) {
  const std::size_t samples = path.demonstration_time.size();
  ParameterizedPath out;
  std::vector<JointVector> rows;
  const auto add = [&](double clock, const JointVector& q, double time_s, SampleOrigin origin) {
    out.parameter.push_back(clock);
    rows.push_back(q);
    out.demonstration_time.push_back(time_s);
    out.origin.push_back(origin);
  };
  const auto row_of = [&](std::size_t i) -> JointVector {
    return path.position.row(i).transpose();
  };
  add(0, row_of(0), path.demonstration_time[0], path.origin[0]);
  for (std::size_t i = 0; i + 1 < samples; ++i) {
    const double from_s = path.demonstration_time[i];
    const double recorded_s = std::max(0.0, path.demonstration_time[i + 1] - from_s);
    const double step = step_of(robot, path, i, recorded_s, keep_pauses);
    const int parts = std::max(1, static_cast<int>(std::ceil(step / step_s - 1e-6)));
    const double begin = out.parameter.back();
    for (int part = 1; part <= parts; ++part) {
      const double share = part == parts ? 1.0 : static_cast<double>(part) / parts;
      add(begin + share * step, row_of(i) + share * (row_of(i + 1) - row_of(i)),
          from_s + share * recorded_s, path.origin[share < 0.5 ? i : i + 1]);
    }
  }
  // Even a path of one point becomes a motion of a few controller periods.
  if (out.parameter.back() == 0) {
    add(step_s, rows.back(), out.demonstration_time.back(), out.origin.back());
  }
  const double longer = std::max(1.0, step_s / out.parameter.back());
  for (double& clock : out.parameter) clock *= longer;
  out.position.resize(rows.size(), path.position.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.position.row(i) = rows[i].transpose();
  }
  return out;
}

double demonstration_time_at(const ParameterizedPath& path, double clock) {
  const std::size_t i = sample_before(path, clock);
  const double share = share_at(path, i, clock);
  return (1 - share) * path.demonstration_time[i] + share * path.demonstration_time[i + 1];
}

SampleOrigin origin_at(const ParameterizedPath& path, double clock) {
  const std::size_t i = sample_before(path, clock);
  return path.origin[share_at(path, i, clock) < 0.5 ? i : i + 1];
}

}  // namespace morphe::retime
