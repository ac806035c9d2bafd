#include "pipeline/commands/reference_frames_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

/// A point of one plan in the frames of base, table and recording.
using PointInFrames = std::array<Vec3, 3>;

PointInFrames point_in_frames(const WorldFrames& world, const Vec3& in_base) {
  return {in_base, world.base_from_table.inverse() * in_base,
          world.base_from_world.inverse() * in_base};
}

Vec3 median_point(const std::vector<PointInFrames>& points, int frame) {
  Vec3 median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const PointInFrames& point : points) values.push_back(point[frame][axis]);
    median[axis] = median_of(values);
  }
  return median;
}

/// Formats a length in millimetres without -0.
std::string rounded_mm_text(double metres) {
  return std::isnan(metres) ? "-" : fmt::format("{:.0f}", std::round(1e3 * metres) + 0.0);
}

TextTable::Row row_of_points(const std::string& name, const std::vector<PointInFrames>& points) {
  TextTable::Row row;
  row.cells = {name};
  double spread_m = kUnknown;
  for (int frame = 0; frame < 3; ++frame) {
    const Vec3 median = median_point(points, frame);
    for (const double value : median) row.cells.push_back(rounded_mm_text(value));
    for (const PointInFrames& point : points)
      spread_m = std::fmax(spread_m, (point[frame] - median).norm());
  }
  row.cells.push_back(rounded_mm_text(spread_m));
  return row;
}

/// Formats an axis of the base in the frame of the recording: "(0.26, 0.00, 0.97)".
std::string axis_text(const Vec3& axis) {
  const Vec3 rounded = (100 * axis).array().round() / 100 + 0.0;  // without -0
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", rounded.x(), rounded.y(), rounded.z());
}

/// Returns for each object the remark of the first plan that has one, and the number of such plans.
/// The remarks of one object differ only in its height.
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
    text += wrap_line(fmt::format("note: {} (in {} of {})", sentence, count,
                                  count_with_noun(rows.size(), "movement")),
                      width, "");
  }
  return text;
}

}  // namespace

std::string reference_frames_text(const std::string& robot, const std::vector<PlanRow>& rows,
                                  std::size_t width) {
  std::vector<PointInFrames> base, shoulder, table, target;
  const PlanRow* first = nullptr;
  for (const PlanRow& row : rows) {
    const WorldFrames& world = row.world;
    if (!is_known(world.shoulder)) continue;
    if (!first) first = &row;
    base.push_back(point_in_frames(world, Vec3::Zero()));
    shoulder.push_back(point_in_frames(world, world.shoulder));
    if (is_known(world.base_from_table))
      table.push_back(point_in_frames(world, world.base_from_table.translation()));
    if (is_known(world.base_from_target))
      target.push_back(point_in_frames(world, world.base_from_target.translation()));
  }
  if (!first) return "";
  TextTable text;
  text.columns = {{"positions (mm, medians)", "", true, 0},
                  {"base's", "x", false, 0},
                  {"frame", "y", false, 0},
                  {"", "z", false, 0},
                  {"table's", "right", false, 1},
                  {"frame", "forward", false, 1},
                  {"", "up", false, 1},
                  {"recording's", "X", false, 2},
                  {"frame", "Y", false, 2},
                  {"", "Z", false, 2},
                  {"spread", "max", false, 3}};
  text.rows = {row_of_points("base of " + robot, base),
               row_of_points("person's shoulder", shoulder)};
  if (!table.empty()) text.rows.push_back(row_of_points("centre of the table top", table));
  if (!target.empty()) text.rows.push_back(row_of_points("centre of the target", target));
  const Eigen::Matrix3d axes = first->world.base_from_world.linear().transpose();
  const std::string axes_text =
      fmt::format(": base axes in the person's frame (right, forward, up): x {}, y {}, z {}",
                  axis_text(axes.col(0)), axis_text(axes.col(1)), axis_text(axes.col(2)));
  return table_text(text, width) + wrap_line(robot + axes_text, width, "") +
         remarks_text(rows, width);
}

}  // namespace morphe::commands
