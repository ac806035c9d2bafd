#include "stages/import/guess/recording_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

PointSummary summarise_point(const RecordedPoints& points, int k) {
  PointSummary point;
  point.name = points.names[k];
  Eigen::AlignedBox3d box;
  double count = 0;
  for (std::size_t i = 0; i < points.position.rows; ++i) {
    if (!is_known(points.position(i, k))) continue;
    box.extend(points.position(i, k));
    ++count;
  }
  const bool seen = count > 0;
  point.seen_share = seen ? count / static_cast<double>(points.position.rows) : 0;
  point.extent = seen ? Vec3(box.sizes()) : unknown_point();
  point.centre = seen ? Vec3(box.center()) : unknown_point();
  point.body_part = points.parts[k];
  return point;
}

std::string xyz_text(const Vec3& v) {
  return is_known(v) ? fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x(), v.y(), v.z()) : "never visible";
}

}  // namespace

RecordingSummary summarise_points(const RecordedPoints& points,
                                  const std::map<std::string, std::string>& renamed) {
  RecordingSummary summary;
  summary.rows = points.time.size();
  if (points.time.size() > 1) {
    summary.duration_s = points.time.back() - points.time.front();
    summary.rate_hz = static_cast<double>(points.time.size() - 1) / summary.duration_s;
  }
  for (int k = 0; k < std::ssize(points.names); ++k) {
    PointSummary& point = summary.points.emplace_back(summarise_point(points, k));
    const auto found = renamed.find(point.name);
    if (found != renamed.end()) point.body_part = body_part(found->second);
  }
  return summary;
}

std::string summary_text(const RecordingSummary& summary) {
  if (summary.points.empty()) return "";
  constexpr std::size_t kMaxListedPoints = 40;
  std::size_t width = 5;
  std::vector<std::string> others;
  std::vector<const PointSummary*> shown;
  for (const PointSummary& point : summary.points) {
    if (point.body_part.empty() && summary.points.size() > kMaxListedPoints) {
      others.push_back(point.name);
      continue;
    }
    shown.push_back(&point);
    width = std::max(width, point.name.size());
  }
  const std::string unit = summary.unit.empty() ? "in the file's unit" : "in " + summary.unit;
  std::string text = fmt::format("{}: {} point{}, {} row{}", summary.file, summary.points.size(),
                                 summary.points.size() == 1 ? "" : "s", summary.rows,
                                 summary.rows == 1 ? "" : "s");
  if (summary.rate_hz > 0)
    text += fmt::format(", {:.4g} rows per second, {:.2f} s", summary.rate_hz, summary.duration_s);
  text += fmt::format("; x, y, z {}\n  {:<{}}  {:>7}  {:<28}  {:<28}  used as\n", unit, "point",
                      width, "visible", "centre", "extent");
  for (const PointSummary* point : shown) {
    text += fmt::format("  {:<{}}  {:>5.0f} %  {:<28}  {:<28}  {}\n", point->name, width,
                        100 * point->seen_share, xyz_text(point->centre), xyz_text(point->extent),
                        point->body_part.empty() ? "-" : point->body_part);
  }
  if (!others.empty()) {
    const std::size_t listed = std::min(others.size(), kMaxListedPoints);
    const std::size_t rest = others.size() - listed;
    others.resize(listed);
    text += fmt::format("  not used: {}{}\n", fmt::join(others, ", "),
                        rest > 0 ? fmt::format(" and {} more", rest) : "");
  }
  return text;
}

}  // namespace morphe::imports
