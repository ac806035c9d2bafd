#include "core/motion/stream_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace morphe {
namespace {

using IsSeen = std::function<bool(int row, int column)>;

StreamReport report_stream(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const IsSeen& is_seen) {
  StreamReport report;
  report.name = name;
  report.columns = columns.size();
  if (time.size() < 2) return report;
  report.begin_s = time.front();
  report.duration_s = time.back() - time.front();
  report.rate_hz = static_cast<double>(time.size() - 1) / report.duration_s;
  std::size_t valid_count = 0;
  for (int column = 0; column < std::ssize(columns); ++column) {
    int column_valid_count = 0;
    for (int row = 0; row < std::ssize(time); ++row) {
      if (is_seen(row, column)) {
        ++column_valid_count;
        continue;
      }
      const int first = row;
      while (row + 1 < std::ssize(time) && !is_seen(row + 1, column)) ++row;
      ++report.gaps;
      const double length_s = time[row] - time[first] + 1 / report.rate_hz;
      if (length_s <= report.longest_gap_s) continue;
      report.longest_gap_s = length_s;
      report.longest_gap_column = columns[column];
    }
    if (column_valid_count == 0) report.empty_columns.push_back(columns[column]);
    valid_count += column_valid_count;
  }
  const std::size_t all = time.size() * columns.size();
  report.valid_share = all == 0 ? 0 : static_cast<double>(valid_count) / static_cast<double>(all);
  return report;
}

StreamReport report_points(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const Array2D<Vec3>& points) {
  return report_stream(name, time, columns,
                       [&](int row, int column) { return is_known(points(row, column)); });
}

StreamReport report_angles(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const JointRows& angles) {
  return report_stream(name, time, columns,
                       [&](int row, int column) { return std::isfinite(angles(row, column)); });
}

const char* display_name(HandKind kind) {
  return kind == HandKind::joint_angles ? "hand angles" : name_of(kind).data();
}

}  // namespace

std::vector<StreamReport> report_streams(const Streams& streams) {
  std::vector<StreamReport> reports;
  if (const auto& s = streams.markers)
    reports.push_back(report_points("markers", s->time, s->names, s->position));
  if (const auto& s = streams.sensors)
    reports.push_back(report_points("sensors", s->time, s->names, s->position));
  if (const auto& s = streams.skeleton)
    reports.push_back(report_points("skeleton", s->time, s->names, s->position));
  if (const auto& s = streams.arm_angles)
    reports.push_back(report_angles("arm_angles", s->time, s->joints, s->angles));
  if (const auto& s = streams.hand) {
    if (!s->names.empty()) {
      reports.push_back(report_angles(display_name(s->kind), s->time, s->names, s->angles));
    } else {
      std::vector<std::string> points;
      for (std::size_t k = 0; k < s->position.cols; ++k)
        points.push_back(fmt::format("point {}", k));
      reports.push_back(report_points(display_name(s->kind), s->time, points, s->position));
    }
  }
  return reports;
}

double longest_duration_s(const std::vector<StreamReport>& streams) {
  double longest = 0;
  for (const StreamReport& stream : streams) longest = std::max(longest, stream.duration_s);
  return longest;
}

}  // namespace morphe
