#include "pipeline/run/element_location.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <utility>

namespace morphe::run {
namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"}, kHumanlikenessMetrics{"A", "B", "C"};

bool ends_in(std::string_view text, std::string_view end) { return text.ends_with(end); }

/// Returns " (0.62 s)" from the dataset of times in the same group.
std::string time_at(const store::Hdf5Group& group, std::size_t row, std::size_t rows) {
  for (const char* times : {"time", "demonstration_time"}) {
    if (!group.has(times) || group.is_group(times)) continue;
    const store::Hdf5Value value = group.value(times);
    if (!value.is_text && value.dims == std::vector<std::size_t>{rows})
      return fmt::format(" ({:.2f} s)", value.numbers[row]);
  }
  return "";
}

/// Returns the name of a column, "" if it has no name.
std::string column_name(const std::string& path, std::size_t columns, std::size_t column,
                        const ColumnNames& names) {
  const bool of_tips =
      path.starts_with("goals/tip_") || path == "goals/reachable" || ends_in(path, "_error");
  const bool of_joints =
      !path.starts_with("goals/") && !path.starts_with("scene/") &&
      (ends_in(path, "position") || ends_in(path, "velocity") || ends_in(path, "acceleration"));
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
  std::vector<std::size_t> at(dims.size());
  for (std::size_t k = dims.size(); k-- > 0; index /= dims[k]) at[k] = index % dims[k];
  const bool of_frames = path.starts_with("goals/") || path.starts_with("mapped/");
  std::vector<std::string> words{fmt::format("{} {}{}", of_frames ? "frame" : "sample", at[0],
                                             name == "time" ? "" : time_at(group, at[0], dims[0]))};
  if (dims.size() > 1) words.push_back(column_name(path, dims[1], at[1], names));
  if (dims.size() > 2)
    words.push_back(dims[2] == 3 ? kAxes.at(at[2]) : fmt::format("component {}", at[2]));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string unit_of_attribute(const std::string& name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kUnits{{
      {"required_clearance", "m"},
      {"max_penetration", "m"},
      {"max_link_penetration", "m"},
      {"tracking_tolerance", "m"},
      {"tracking_tolerance_grasp", "m"},
      {"max_tip_error", "m"},
      {"clearance", "m"},
      {"tip_error_max", "m"},
      {"tip_error_mean", "m"},
      {"tip_error_grasp", "m"},
      {"joint_limit_margin", "rad"},
      {"begin_s", "s"},
      {"end_s", "s"},
      {"humanlikeness_mapped", "m^2"},
      {"humanlikeness_final", "m^2"},
  }};
  for (const auto& [attribute, unit] : kUnits)
    if (name == attribute) return std::string(unit);
  return name.find("_error") != std::string::npos ? "rad" : "";
}

}  // namespace morphe::run
