#include "stages/import/guess/recording_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

PointSummary survey_point(const RecordedPoints& points, std::size_t k) {
  PointSummary point;
  point.name = points.names[k];
  Eigen::AlignedBox3d box;
  double count = 0;
  for (std::size_t i = 0; i < points.position.rows; ++i) {
    if (!is_known(points.position(i, k))) continue;
    box.extend(points.position(i, k));
    ++count;
  }
  const bool any = count > 0;
  point.seen_share = any ? count / static_cast<double>(points.position.rows) : 0;
  point.extent = any ? Vec3(box.sizes()) : unknown_point();
  point.centre = any ? Vec3(box.center()) : unknown_point();
  point.body_part = points.parts[k];
  return point;
}

std::string numbers(const Vec3& v) {
  return is_known(v) ? fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x(), v.y(), v.z()) : "never visible";
}

}  // namespace

RecordingSummary summarise_points(const RecordedPoints& points,
                                  const std::map<std::string, std::string>& renamed) {
  RecordingSummary survey;
  survey.rows = points.time.size();
  if (points.time.size() > 1) {
    survey.duration_s = points.time.back() - points.time.front();
    survey.rate_hz = static_cast<double>(points.time.size() - 1) / survey.duration_s;
  }
  for (std::size_t k = 0; k < points.names.size(); ++k) {
    PointSummary& point = survey.points.emplace_back(survey_point(points, k));
    const auto found = renamed.find(point.name);
    if (found != renamed.end()) point.body_part = body_part(found->second);
  }
  return survey;
}

std::string summary_text(const RecordingSummary& survey) {
  if (survey.points.empty()) return "";
  constexpr std::size_t kMaxListedPoints = 40;
  std::size_t width = 5;
  std::vector<std::string> others;
  std::vector<const PointSummary*> shown;
  for (const PointSummary& point : survey.points) {
    if (point.body_part.empty() && survey.points.size() > kMaxListedPoints) {
      others.push_back(point.name);
      continue;
    }
    shown.push_back(&point);
    width = std::max(width, point.name.size());
  }
  const std::string unit = survey.unit.empty() ? "in the file's unit" : "in " + survey.unit;
  std::string text =
      fmt::format("{}: {} point{}, {} row{}", survey.file, survey.points.size(),
                  survey.points.size() == 1 ? "" : "s", survey.rows, survey.rows == 1 ? "" : "s");
  if (survey.rate_hz > 0) {
    text += fmt::format(", {:.4g} rows per second, {:.2f} s", survey.rate_hz, survey.duration_s);
  }
  text += fmt::format("; x, y, z {}\n  {:<{}}  {:>7}  {:<28}  {:<28}  used as\n", unit, "point",
                      width, "visible", "centre", "extent");
  for (const PointSummary* point : shown) {
    text += fmt::format("  {:<{}}  {:>5.0f} %  {:<28}  {:<28}  {}\n", point->name, width,
                        100 * point->seen_share, numbers(point->centre), numbers(point->extent),
                        point->body_part.empty() ? "-" : point->body_part);
  }
  if (!others.empty()) {
    const std::size_t left =
        others.size() > kMaxListedPoints ? others.size() - kMaxListedPoints : 0;
    others.resize(others.size() - left);
    text += fmt::format("  not used: {}{}\n", fmt::join(others, ", "),
                        left > 0 ? fmt::format(" and {} more", left) : "");
  }
  return text;
}

}  // namespace morphe::imports
