#include "stages/retime/path_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/constants.hpp"

namespace morphe::retime {
namespace {

double step_of(const RobotModel& robot, const JointPath& path, int i, double recorded_s,
               bool keep_pauses) {
  const JointVector step = (path.position.row(i + 1) - path.position.row(i)).transpose();
  const double full_speed_s =
      step.cwiseAbs().cwiseQuotient(robot.velocity.cwiseMin(kMaxJointSpeed_rad_s)).maxCoeff();
  const bool planned =
      path.origin[i] == SampleOrigin::planned || path.origin[i + 1] == SampleOrigin::planned;
  const double min_s = planned ? full_speed_s : full_speed_s / kMaxRecordedSpeedRatio;
  const double recorded_or_pause_s =
      keep_pauses ? recorded_s : std::min(recorded_s, full_speed_s / kPauseSpeedRatio);
  return std::max(recorded_or_pause_s, min_s);
}

std::ptrdiff_t sample_before(const ParameterizedPath& path, double clock) {
  const auto after = std::ranges::upper_bound(path.parameter, clock) - path.parameter.begin();
  return std::min(std::max<std::ptrdiff_t>(after - 1, 0), std::ssize(path.parameter) - 2);
}

double share_at(const ParameterizedPath& path, std::ptrdiff_t i, double clock) {
  const double span = path.parameter[i + 1] - path.parameter[i];
  return span > 0 ? std::clamp((clock - path.parameter[i]) / span, 0.0, 1.0) : 1.0;
}

}  // namespace

ParameterizedPath parameterize_path(const RobotModel& robot, const JointPath& path, double step_s,
                                    bool keep_pauses) {
  ParameterizedPath out;
  std::vector<JointVector> rows;
  const auto add = [&](double clock, const JointVector& q, double time_s, SampleOrigin origin) {
    out.parameter.push_back(clock);
    rows.push_back(q);
    out.demonstration_time.push_back(time_s);
    out.origin.push_back(origin);
  };
  const auto row_of = [&](int i) -> JointVector { return path.position.row(i).transpose(); };
  add(0, row_of(0), path.demonstration_time[0], path.origin[0]);
  for (int i = 0; i + 1 < std::ssize(path.demonstration_time); ++i) {
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
  if (out.parameter.back() == 0)
    add(step_s, rows.back(), out.demonstration_time.back(), out.origin.back());
  const double stretch = std::max(1.0, step_s / out.parameter.back());
  for (double& clock : out.parameter) clock *= stretch;
  out.position.resize(rows.size(), path.position.cols());
  for (int i = 0; i < std::ssize(rows); ++i) out.position.row(i) = rows[i].transpose();
  return out;
}

double demonstration_time_at(const ParameterizedPath& path, double clock) {
  const std::ptrdiff_t i = sample_before(path, clock);
  const double share = share_at(path, i, clock);
  return (1 - share) * path.demonstration_time[i] + share * path.demonstration_time[i + 1];
}

SampleOrigin origin_at(const ParameterizedPath& path, double clock) {
  const std::ptrdiff_t i = sample_before(path, clock);
  return path.origin[share_at(path, i, clock) < 0.5 ? i : i + 1];
}

}  // namespace morphe::retime
