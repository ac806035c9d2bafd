#include "pipeline/commands/place_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace morphe::commands {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isnan(value) ? Json() : Json(value); }

Json json_of(const robot::Standing& standing, const place::PlacementResult& found) {
  const place::PlannedSummary& planned = found.plan_summary;
  const place::PlacementMeasures& m = planned.measures;
  Json rotation = Json::array();
  for (const auto& turn : found.placement.rotation)
    rotation.push_back({{"axis", turn.axis}, {"angle", turn.angle}});
  const auto point = [](const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); };
  return {{"rotation", rotation},
          {"shoulder_offset", point(found.placement.shoulder_offset)},
          {"stands", robot::standing_words(standing, found.base_placement.world_from_base)},
          {"base_from_shoulder", point(found.base)},
          {"height_above_table", number(found.height_above_table)},
          {"movements", planned.movements},
          {"executable", planned.executable},
          {"failed_before_mapping", planned.failed_before_mapping.size()},
          {"unreachable_share", m.out_of_reach},
          {"tip_error_mean", m.tip_error_m},
          {"tip_error_max", number(planned.tip_error_max_m)},
          {"upper_arm_error_median", planned.upper_arm_error_median},
          {"upper_arm_error_max", planned.upper_arm_error_max},
          {"palm_error", m.palm_error},
          {"duration_ratio", m.speed_ratio},
          {"cost", place::cost_of(m)}};
}

bool is_better(const place::PlacementResult& found, const place::PlacementResult& configured) {
  return place::plan_cost(found) < place::plan_cost(configured);
}

std::string failure_note(const place::PlannedSummary& planned) {
  if (planned.failed_before_mapping.empty()) return "";
  return fmt::format(
      "note: {} of {} movements fail before they are mapped, at any placement, and are in no mean "
      "of "
      "the table: {}\n",
      planned.failed_before_mapping.size(), planned.movements,
      fmt::join(planned.failed_before_mapping, "; "));
}

bool is_kept_upright(const place::PlaceOptions& options) {
  return options.mount == place::MountDirection::floor && !options.fixed.rotation;
}

std::string upright_note(const place::PlaceOptions& options) {
  if (!is_kept_upright(options)) return "";
  if (!options.standing.has_body())
    return "note: only upright bases were searched; --mount any, ceiling, side or wall allows "
           "more\n";
  return fmt::format(
      "note: the robot has a body ({}): it stands upright and faces the person's way; --mount any "
      "lifts this\n",
      options.standing.evidence);
}

std::string no_better_note(const place::PlaceOptions& options,
                           const place::PlacementResult& configured,
                           const place::PlacementResult& best) {
  return fmt::format(
      "note: the best placement found is no better than the configured one, in which the base {} "
      "(cost {:.1f} against {:.1f} degrees): keep that one, or {}\n",
      robot::standing_words(options.standing, configured.base_placement.world_from_base),
      place::plan_cost(best), place::plan_cost(configured),
      is_kept_upright(options) ? "allow more with --mount any" : "search with more --candidates");
}

}  // namespace

std::string place_table_head() {
  return fmt::format(
      "{:<10} {:>10} {:>8} {:>8} {:>10} {:>10} {:>8} {:>8} {:>20} {:>16} {:>8}  {}\n"
      "{:<10} {:>10} {:>8} {:>8} {:>10} {:>10} {:>8} {:>8} {:>20} {:>16} {:>8}",
      "place", "executable", "out of", "tips", "upper arm", "upper arm", "palm", "duration",
      "base from shoulder", "base z axis", "above", "the base", "", "", "reach %", "mm",
      "median deg", "max deg", "deg", "ratio", "right, fwd, up mm", "right, fwd, up", "table mm");
}

std::string place_row(const std::string& name, const robot::Standing& standing,
                      const place::PlacementResult& found) {
  const place::PlannedSummary& p = found.plan_summary;
  const Vec3 base = 1e3 * found.base, up = found.base_placement.up();
  return fmt::format(
      "{:<10} {:>10} {:>8.1f} {:>8.2f} {:>10.1f} {:>10.1f} {:>8.1f} {:>8} {:>20} {:>16} {:>8}  {}",
      name, fmt::format("{} of {}", p.executable, p.movements), 100 * p.measures.out_of_reach,
      1e3 * p.measures.tip_error_m, p.upper_arm_error_median / kRadPerDegree,
      p.upper_arm_error_max / kRadPerDegree, p.measures.palm_error / kRadPerDegree,
      p.executable == p.movements ? fmt::format("{:.2f}", p.measures.speed_ratio) : "-",
      fmt::format("{:.0f} {:.0f} {:.0f}", base.x(), base.y(), base.z()),
      fmt::format("{:.2f} {:.2f} {:.2f}", up.x(), up.y(), up.z()),
      std::isnan(found.height_above_table) ? "-"
                                           : fmt::format("{:.0f}", 1e3 * found.height_above_table),
      robot::standing_words(standing, found.base_placement.world_from_base));
}

std::string placement_yaml(const map::PlacementOptions& placement) {
  std::string yaml = "placement:\n  rotation:";
  if (placement.rotation.empty()) yaml += " []";
  for (const auto& turn : placement.rotation)
    yaml += fmt::format("\n    - {{axis: {}, angle: {:.1f} deg}}", turn.axis,
                        turn.angle / kRadPerDegree);
  const Vec3& offset = placement.shoulder_offset;
  yaml += fmt::format("\n  shoulder_offset: [{:.3f}, {:.3f}, {:.3f}]\n", offset.x(), offset.y(),
                      offset.z());
  if (placement.found_by) yaml += fmt::format("  found_by: {}\n", name_of(*placement.found_by));
  return yaml;
}

std::string place_json(const robot::Standing& standing, const place::PlacementResult& configured,
                       const std::vector<place::PlacementResult>& found) {
  Json placements = Json::array();
  for (const place::PlacementResult& one : found) placements.push_back(json_of(standing, one));
  return Json{{"configured", json_of(standing, configured)},
              {"placements", placements},
              {"better_than_configured", is_better(found.front(), configured)},
              {"failed_before_mapping", found.front().plan_summary.failed_before_mapping},
              {"body_frame", standing.evidence}}
      .dump();
}

std::string place_notes(const place::PlaceOptions& options,
                        const place::PlacementResult& configured,
                        const std::vector<place::PlacementResult>& found) {
  const place::PlacementResult& best = found.front();
  return failure_note(best.plan_summary) + upright_note(options) +
         (is_better(best, configured) ? "" : no_better_note(options, configured, best));
}

}  // namespace morphe::commands
