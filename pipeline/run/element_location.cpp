#include "pipeline/run/element_location.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace morphe::run {
namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"}, kHumanlikenessMetrics{"A", "B", "C"};

/// Returns " (0.62 s)" from the dataset of times in the same group, "" without one of `rows` rows.
std::string time_at(const store::Hdf5Group& group, std::size_t row, std::size_t rows) {
  for (const char* times : {"time", "demonstration_time"}) {
    if (!group.has(times) || group.is_group(times)) continue;
    const store::Hdf5Value value = group.value(times);
    if (!value.is_text && value.dims == std::vector<std::size_t>{rows})
      return fmt::format(" ({:.2f} s)", value.numbers[row]);
  }
  return "";
}

/// Returns the name of a column: of a metric, tip, joint or axis, otherwise "column 5".
std::string column_name(const std::string& path, std::size_t columns, std::size_t column,
                        const ColumnNames& names) {
  const bool of_tips =
      path.starts_with("goals/tip_") || path == "goals/reachable" || path.ends_with("_error");
  const bool of_joints =
      !path.starts_with("goals/") && !path.starts_with("scene/") &&
      (path.ends_with("position") || path.ends_with("velocity") || path.ends_with("acceleration"));
  if (path == "mapped/humanlikeness" && columns == 3) return kHumanlikenessMetrics.at(column);
  if (of_tips && columns == names.tips.size()) return names.tips[column];
  if (of_joints && columns == names.joints.size()) return names.joints[column];
  if (columns == 3) return kAxes.at(column);
  return fmt::format("column {}", column);
}

}  // namespace

ColumnNames column_names(const store::Hdf5Group& root) {
  ColumnNames names;
  if (!root.has("robot") || !root.is_group("robot")) return names;
  const store::Hdf5Group robot = root.open("robot");
  if (robot.has("joint_names")) names.joints = robot.read_strings("joint_names");
  if (robot.has("tips") && robot.is_group("tips") && robot.open("tips").has("name"))
    names.tips = robot.open("tips").read_strings("name");
  return names;
}

std::string element_location(const store::Hdf5Group& group, const std::string& name,
                             const std::string& path, const std::vector<std::size_t>& dims,
                             std::size_t index, const ColumnNames& names) {
  if (dims.empty()) return "";
  std::vector<std::size_t> indices(dims.size());
  for (std::size_t k = dims.size(); k-- > 0; index /= dims[k]) indices[k] = index % dims[k];
  const bool of_frames = path.starts_with("goals/") || path.starts_with("mapped/");
  std::vector<std::string> parts{
      fmt::format("{} {}{}", of_frames ? "frame" : "sample", indices[0],
                  name == "time" ? "" : time_at(group, indices[0], dims[0]))};
  if (dims.size() > 1) parts.push_back(column_name(path, dims[1], indices[1], names));
  if (dims.size() > 2)
    parts.push_back(dims[2] == 3 ? kAxes.at(indices[2]) : fmt::format("component {}", indices[2]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string unit_of_attribute(const std::string& name) {
  static constexpr std::array<std::string_view, 10> kMetres{"required_clearance",
                                                            "max_penetration",
                                                            "max_link_penetration",
                                                            "tracking_tolerance",
                                                            "tracking_tolerance_grasp",
                                                            "max_tip_error",
                                                            "clearance",
                                                            "tip_error_max",
                                                            "tip_error_mean",
                                                            "tip_error_grasp"};
  if (std::ranges::find(kMetres, name) != kMetres.end()) return "m";
  if (name == "humanlikeness_mapped" || name == "humanlikeness_final") return "m^2";
  if (name == "begin_s" || name == "end_s" || name == "max_goal_gap_s") return "s";
  return name == "joint_limit_margin" || name.find("_error") != std::string::npos ? "rad" : "";
}

}  // namespace morphe::run
