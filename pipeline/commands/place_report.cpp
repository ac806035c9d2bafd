#include "pipeline/commands/place_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace morphe::commands {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isnan(value) ? Json() : Json(value); }

Json json_of(const place::PlacementResult& found) {
  const place::PlannedSummary& planned = found.plan_summary;
  const place::PlacementMeasures& m = planned.measures;
  Json rotation = Json::array();
  for (const auto& turn : found.placement.rotation)
    rotation.push_back({{"axis", turn.axis}, {"angle", turn.angle}});
  const auto point = [](const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); };
  return {{"rotation", rotation},
          {"shoulder_offset", point(found.placement.shoulder_offset)},
          {"base_from_shoulder", point(found.base)},
          {"height_above_table", number(found.height_above_table)},
          {"movements", planned.movements},
          {"executable", planned.executable},
          {"unreachable_share", m.out_of_reach},
          {"tip_error_mean", m.tip_error_m},
          {"tip_error_max", number(planned.tip_error_max_m)},
          {"upper_arm_error_median", planned.upper_arm_error_median},
          {"upper_arm_error_max", planned.upper_arm_error_max},
          {"palm_error", m.palm_error},
          {"duration_ratio", m.speed_ratio},
          {"cost", place::cost_of(m)}};
}

}  // namespace

std::string place_table_head() {
  return fmt::format(
      "{:<10} {:>10} {:>8} {:>8} {:>10} {:>10} {:>8} {:>8} {:>20} {:>16} {:>8}\n"
      "{:<10} {:>10} {:>8} {:>8} {:>10} {:>10} {:>8} {:>8} {:>20} {:>16} {:>8}",
      "place", "executable", "out of", "tips", "upper arm", "upper arm", "palm", "duration",
      "base from shoulder", "base z axis", "above", "", "", "reach %", "mm", "median deg",
      "max deg", "deg", "ratio", "right, fwd, up mm", "right, fwd, up", "table mm");
}

std::string place_row(const std::string& name, const place::PlacementResult& found) {
  const place::PlannedSummary& p = found.plan_summary;
  const Vec3 base = 1e3 * found.base, up = found.base_placement.up();
  return fmt::format(
      "{:<10} {:>10} {:>8.1f} {:>8.2f} {:>10.1f} {:>10.1f} {:>8.1f} {:>8} {:>20} {:>16} {:>8}",
      name, fmt::format("{} of {}", p.executable, p.movements), 100 * p.measures.out_of_reach,
      1e3 * p.measures.tip_error_m, p.upper_arm_error_median / kRadPerDegree,
      p.upper_arm_error_max / kRadPerDegree, p.measures.palm_error / kRadPerDegree,
      p.executable == p.movements ? fmt::format("{:.2f}", p.measures.speed_ratio) : "-",
      fmt::format("{:.0f} {:.0f} {:.0f}", base.x(), base.y(), base.z()),
      fmt::format("{:.2f} {:.2f} {:.2f}", up.x(), up.y(), up.z()),
      std::isnan(found.height_above_table) ? "-"
                                           : fmt::format("{:.0f}", 1e3 * found.height_above_table));
}

std::string placement_yaml(const map::PlacementOptions& placement) {
  std::string yaml = "placement:\n  rotation:";
  if (placement.rotation.empty()) yaml += " []";
  for (const auto& turn : placement.rotation)
    yaml += fmt::format("\n    - {{axis: {}, angle: {:.1f} deg}}", turn.axis,
                        turn.angle / kRadPerDegree);
  const Vec3& offset = placement.shoulder_offset;
  return yaml + fmt::format("\n  shoulder_offset: [{:.3f}, {:.3f}, {:.3f}]\n", offset.x(),
                            offset.y(), offset.z());
}

std::string place_json(const place::PlacementResult& configured,
                       const std::vector<place::PlacementResult>& found) {
  Json placements = Json::array();
  for (const place::PlacementResult& one : found) placements.push_back(json_of(one));
  return Json{{"configured", json_of(configured)}, {"placements", placements}}.dump();
}

}  // namespace morphe::commands
