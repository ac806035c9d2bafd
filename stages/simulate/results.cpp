#include "stages/simulate/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/motion/input_error.hpp"
#include "core/motion/version.hpp"
#include "core/physics/model.hpp"

namespace morphe::simulate {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "morphe-simulation";
constexpr int kVersion = 1;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
/// Newtons: those that no squeeze is enough for are infinite.
double newtons_of(const Json& json) { return json.is_null() ? kInfinity : json.get<double>(); }
double value_of(const Json& json) { return json.is_null() ? kNotSeen : json.get<double>(); }

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
double at(const Json& json, const char* key) { return json.at(key).get<double>(); }

Vec3 vector_of(const Json& json) {
  const auto values = json.get<std::array<double, 3>>();
  return Vec3(values[0], values[1], values[2]);
}

Json json_of(const Way& way) { return {{"m", way.distance_m}, {"deg", way.angle_deg}}; }
Way way_of(const Json& json) { return {at(json, "m"), at(json, "deg")}; }

Json json_of(const Holding& holding) {
  return {{"failure", name_of(holding.failure)}, {"detail", holding.detail},
          {"sag", json_of(holding.sag)},         {"creep", json_of(holding.creep)},
          {"largest", json_of(holding.largest)}, {"slip_m", holding.slip_m},
          {"needed_N", number(holding.needed_N)}};
}

Holding holding_of(const Json& json) {
  return {named<Failure>(json.at("failure").get<std::string>()).value(),
          json.at("detail").get<std::string>(),
          way_of(json.at("sag")),
          way_of(json.at("creep")),
          way_of(json.at("largest")),
          at(json, "slip_m"),
          newtons_of(json.at("needed_N"))};
}

/// The matrix, row by row: a quaternion would not give its last digits back.
Json json_of(const Pose& pose) {
  Json rows = Json::array();
  for (Eigen::Index r = 0; r < 4; ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < 4; ++c) row.push_back(pose.matrix()(r, c));
    rows.push_back(row);
  }
  return rows;
}

Pose pose_of(const Json& json) {
  Pose pose;
  for (Eigen::Index r = 0; r < 4; ++r) {
    for (Eigen::Index c = 0; c < 4; ++c)
      pose.matrix()(r, c) =
          json.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
  }
  return pose;
}

Json json_of(const Rollout& rollout) {
  const Variation& varied = rollout.variation;
  Json directions = Json::array();
  for (const Holding& holding : rollout.directions) directions.push_back(json_of(holding));
  return {{"friction", varied.friction},
          {"torsion_m", varied.torsion_m},
          {"mass_kg", varied.mass_kg},
          {"target", json_of(varied.base_from_target)},
          {"arm_error", rollout.arm_error},
          {"hand_error", rollout.hand_error},
          {"contact_s", number(rollout.contact_s)},
          {"pushed", json_of(rollout.pushed)},
          {"torque_share", rollout.torque_share},
          {"given_N", rollout.given_N},
          {"needed_worst_N", number(rollout.needed_worst_N)},
          {"needed_down_N", number(rollout.needed_down_N)},
          {"pressed_N", rollout.pressed_N},
          {"lift", json_of(rollout.lift)},
          {"directions", directions}};
}

Rollout rollout_of(const Json& json) {
  Rollout rollout;
  rollout.variation = {at(json, "friction"), at(json, "torsion_m"), at(json, "mass_kg"),
                       pose_of(json.at("target"))};
  rollout.arm_error = at(json, "arm_error");
  rollout.hand_error = at(json, "hand_error");
  rollout.contact_s = value_of(json.at("contact_s"));
  rollout.pushed = way_of(json.at("pushed"));
  rollout.torque_share = at(json, "torque_share");
  rollout.given_N = at(json, "given_N");
  rollout.needed_worst_N = newtons_of(json.at("needed_worst_N"));
  rollout.needed_down_N = newtons_of(json.at("needed_down_N"));
  rollout.pressed_N = json.at("pressed_N").get<std::vector<double>>();
  rollout.lift = holding_of(json.at("lift"));
  for (const Json& holding : json.at("directions"))
    rollout.directions.push_back(holding_of(holding));
  return rollout;
}

PlanResult result_of(const Json& json) {
  PlanResult result;
  result.plan = json.at("plan").get<std::string>();
  result.plan_sha256 = json.at("plan_sha256").get<std::string>();
  result.unfit = named<Unfit>(json.at("unfit").get<std::string>()).value();
  result.detail = json.at("detail").get<std::string>();
  result.notes = json.at("notes").get<std::vector<std::string>>();
  for (const Json& press : json.at("presses")) {
    result.tips.push_back(press.at("tip_name").get<std::string>());
    result.presses.push_back({press.at("tip").get<std::size_t>(), vector_of(press.at("point")),
                              vector_of(press.at("inward")), at(press, "force_N"),
                              vector_of(press.at("aside"))});
  }
  result.planned_squeeze = json.at("squeeze") == "plan";
  result.force_share = at(json, "force_share");
  result.planned_contact_s = value_of(json.at("planned_contact_s"));
  for (const Json& rollout : json.at("rollouts")) result.rollouts.push_back(rollout_of(rollout));
  return result;
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

/// Quoted where it must be (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string result_json(const PlanResult& result, const SimulateOptions& options,
                        const std::string& key) {
  Json presses = Json::array(), rollouts = Json::array();
  for (std::size_t k = 0; k < result.presses.size(); ++k) {
    const Press& press = result.presses[k];
    presses.push_back({{"tip", press.tip},
                       {"tip_name", result.tips[k]},
                       {"point", json_of(press.point)},
                       {"inward", json_of(press.inward)},
                       {"force_N", press.force_N},
                       {"aside", json_of(press.aside)}});
  }
  for (const Rollout& rollout : result.rollouts) rollouts.push_back(json_of(rollout));
  Json settings;
  const auto add = [&](const char* name, const auto& value) { settings[name] = value; };
  fields(add, options);
  const Json json = {{"format", kFormat},
                     {"version", kVersion},
                     {"software", software()},
                     {"engine", physics::engine()},
                     {"key", key},
                     {"options", settings},
                     {"assumed", assumptions(options)},
                     {"plan", result.plan},
                     {"plan_sha256", result.plan_sha256},
                     {"unfit", name_of(result.unfit)},
                     {"detail", result.detail},
                     {"notes", result.notes},
                     {"held", result.held()},
                     {"presses", presses},
                     {"squeeze", result.planned_squeeze ? "plan" : "nearest"},
                     {"force_share", result.force_share},
                     {"planned_contact_s", number(result.planned_contact_s)},
                     {"rollouts", rollouts}};
  return json.dump(1) + "\n";
}

std::optional<PlanResult> read_result(const std::filesystem::path& file, const std::string& key) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    const Json json = Json::parse(text);
    if (json.at("key") != key) return std::nullopt;
    return result_of(json);
  } catch (const std::exception&) {  // of another version, or not ours: it is made anew
    return std::nullopt;
  }
}

StoredResult stored_result(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat || json.at("version") != kVersion)
      throw InputError("is of another format or version");
    return {result_of(json), json.at("engine").get<std::string>()};
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("{}: is no result of morphe simulate: {}", file.string(), error.what()));
  }
}

std::string csv_head() {
  return "plan,rollout,held,failure,friction,torsion_m,mass_kg,arm_error_deg,hand_error_deg,"
         "contact_s,planned_contact_s,pushed_m,pushed_deg,sag_m,sag_deg,slip_m,creep_m,creep_deg,"
         "largest_m,largest_deg,torque_share,squeeze,needed_worst_N,needed_down_N,needed_lift_N,"
         "given_N,pressed_N,foretold,directions\n";
}

std::string csv_rows(const PlanResult& result) {
  std::string rows;
  const std::string plan = cell(result.plan);
  for (std::size_t k = 0; k < result.rollouts.size(); ++k) {
    const Rollout& one = result.rollouts[k];
    const Holding& lift = one.lift;
    std::string directions;
    for (const Holding& holding : one.directions)
      directions += fmt::format("{}{}", directions.empty() ? "" : " ", name_of(holding.failure));
    fmt::format_to(
        std::back_inserter(rows),
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},"
        "{}\n",
        plan, k, lift.held() ? 1 : 0, name_of(lift.failure), one.variation.friction,
        one.variation.torsion_m, one.variation.mass_kg, one.arm_error, one.hand_error,
        one.contact_s, result.planned_contact_s, one.pushed.distance_m, one.pushed.angle_deg,
        lift.sag.distance_m, lift.sag.angle_deg, lift.slip_m, lift.creep.distance_m,
        lift.creep.angle_deg, lift.largest.distance_m, lift.largest.angle_deg, one.torque_share,
        result.planned_squeeze ? "plan" : "nearest", one.needed_worst_N, one.needed_down_N,
        lift.needed_N, one.given_N, largest_of(one.pressed_N), one.foretold(lift) ? 1 : 0,
        directions);
  }
  if (result.rollouts.empty()) {
    // As many empty cells as there are columns beside the plan, the rollout and the two verdicts.
    rows = fmt::format("{},,0,{}{}\n", plan, name_of(result.unfit), std::string(25, ','));
  }
  return rows;
}

}  // namespace morphe::simulate
