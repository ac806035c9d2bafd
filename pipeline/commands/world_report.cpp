#include "pipeline/commands/world_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

/// A point in the three frames, of one plan.
using InFrames = std::array<Vec3, 3>;

InFrames in_frames(const WorldFrames& world, const Vec3& in_base) {
  return {in_base, world.base_from_table.inverse() * in_base,
          world.base_from_world.inverse() * in_base};
}

Vec3 median_point(const std::vector<InFrames>& points, std::size_t frame) {
  Vec3 median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const InFrames& point : points) values.push_back(point[frame][axis]);
    median[axis] = median_of(values);
  }
  return median;
}

/// No -0.
std::string whole_mm(double metres) {
  return std::isnan(metres) ? "-" : fmt::format("{:.0f}", std::round(1e3 * metres) + 0.0);
}

TextTable::Row row_of_points(const std::string& name, const std::vector<InFrames>& points) {
  TextTable::Row row;
  row.cells = {name};
  double spread_m = kNotSeen;
  for (std::size_t frame = 0; frame < 3; ++frame) {
    const Vec3 median = median_point(points, frame);
    for (const double value : median) row.cells.push_back(whole_mm(value));
    for (const InFrames& point : points)
      spread_m = std::fmax(spread_m, (point[frame] - median).norm());
  }
  row.cells.push_back(whole_mm(spread_m));
  return row;
}

/// "x right 0.97, up 0.26": the parts of a base's axis along the recording's that count.
std::string axis_text(const Vec3& axis) {
  static constexpr const char* kPlus[] = {"right", "forward", "up"};
  static constexpr const char* kMinus[] = {"left", "backward", "down"};
  std::string text;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axis[k]) < 0.005) continue;
    text += fmt::format("{}{:.2f} {}", text.empty() ? "" : " ", std::abs(axis[k]),
                        axis[k] > 0 ? kPlus[k] : kMinus[k]);
  }
  return text;
}

/// Heights differ from plan to plan: of each object the first remark, and how many have one.
std::string remarks_text(const std::vector<PlanRow>& rows, std::size_t width) {
  std::map<std::string, std::pair<std::string, int>> by_object;
  for (const PlanRow& row : rows)
    for (const auto& [object, sentence] : row.remarks) {
      auto& [first, count] = by_object[object];
      if (count++ == 0) first = sentence;
    }
  std::string text;
  for (const auto& entry : by_object) {
    const auto& [sentence, count] = entry.second;
    text += folded(fmt::format("note: {} (in {} of {} movement{})", sentence, count, rows.size(),
                               rows.size() == 1 ? "" : "s"),
                   width, "");
  }
  return text;
}

}  // namespace

std::string world_text(const std::string& robot, const std::vector<PlanRow>& rows,
                       std::size_t width) {
  std::vector<InFrames> base, shoulder, table, target;
  const PlanRow* first = nullptr;
  for (const PlanRow& row : rows) {
    const WorldFrames& world = row.world;
    if (!seen(world.shoulder)) continue;
    if (!first) first = &row;
    base.push_back(in_frames(world, Vec3::Zero()));
    shoulder.push_back(in_frames(world, world.shoulder));
    if (seen(world.base_from_table))
      table.push_back(in_frames(world, world.base_from_table.translation()));
    if (seen(world.base_from_target))
      target.push_back(in_frames(world, world.base_from_target.translation()));
  }
  if (!first) return "";
  TextTable text;
  text.columns = {{"where things stand (mm)", "", true, 0},
                  {"base's", "x", false, 0},
                  {"frame", "y", false, 0},
                  {"", "z", false, 0},
                  {"table's", "right", false, 1},
                  {"frame", "forward", false, 1},
                  {"", "up", false, 1},
                  {"recording's", "X", false, 2},
                  {"frame", "Y", false, 2},
                  {"", "Z", false, 2},
                  {"differs", "by up to", false, 3}};
  text.rows = {row_of_points("base of " + robot, base),
               row_of_points("the person's shoulder", shoulder)};
  if (!table.empty()) text.rows.push_back(row_of_points("table, middle of its top", table));
  if (!target.empty()) text.rows.push_back(row_of_points("target, its centre", target));
  const Eigen::Matrix3d axes = first->world.base_from_world.linear().transpose();
  return table_text(text, width) +
         folded(fmt::format("{}: x {}, y {}, z {} of the person", robot, axis_text(axes.col(0)),
                            axis_text(axes.col(1)), axis_text(axes.col(2))),
                width, "") +
         remarks_text(rows, width);
}

}  // namespace morphe::commands
