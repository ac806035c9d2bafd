#include "stages/simulate/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/version.hpp"
#include "core/physics/model.hpp"

namespace morphe::simulate {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "morphe-simulation";
constexpr int kVersion = 3;

constexpr const char* kOwnHash = "sha256";

/// Returns the SHA-256 of all members but the hash itself.
std::string hash_without_own(Json json) {
  json.erase(kOwnHash);
  return files::sha256(json.dump());
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
/// Reads a force [N]; null stands for infinity, for loads that no squeeze supports.
double newtons_of(const Json& json) { return json.is_null() ? kInfinity : json.get<double>(); }
double value_of(const Json& json) { return json.is_null() ? kUnknown : json.get<double>(); }

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
double number_at(const Json& json, const char* key) { return json.at(key).get<double>(); }

Vec3 vector_of(const Json& json) {
  const auto values = json.get<std::array<double, 3>>();
  return Vec3(values[0], values[1], values[2]);
}

Json json_of(const Displacement& d) { return {{"m", d.distance_m}, {"deg", d.angle_deg}}; }
Displacement displacement_at(const Json& json, const char* key) {
  return {number_at(json.at(key), "m"), number_at(json.at(key), "deg")};
}

template <class Enum>
Enum enum_at(const Json& json, const char* key) {
  return enum_from_name<Enum>(json.at(key).get<std::string>()).value();
}

/// Values that were not measured are null.
Json json_of(const TaskResult& task) {
  const auto measured = [](const Displacement& d) {
    return Json{{"m", number(d.distance_m)}, {"deg", number(d.angle_deg)}};
  };
  return {{"failure", name_of(task.failure)},
          {"rise_m", number(task.rise_m)},
          {"palm_offset", measured(task.palm_offset)},
          {"arm_error", number(task.arm_error)},
          {"carried_error", measured(task.carried_error)},
          {"place_error", measured(task.place_error)},
          {"tilt_deg", number(task.tilt_deg)},
          {"standing_motion", measured(task.standing_motion)}};
}

TaskResult task_result_of(const Json& json) {
  const auto measured = [&](const char* key) {
    return Displacement{value_of(json.at(key).at("m")), value_of(json.at(key).at("deg"))};
  };
  return {enum_at<Failure>(json, "failure"), value_of(json.at("rise_m")), measured("palm_offset"),
          value_of(json.at("arm_error")),    measured("carried_error"),   measured("place_error"),
          value_of(json.at("tilt_deg")),     measured("standing_motion")};
}

Json json_of(const HoldResult& hold) {
  return {{"failure", name_of(hold.failure)},
          {"detail", hold.detail},
          {"droop", json_of(hold.droop)},
          {"drift", json_of(hold.drift)},
          {"in_hand_displacement", json_of(hold.in_hand_displacement)},
          {"slip_m", hold.slip_m},
          {"required_force_N", number(hold.required_force_N)}};
}

HoldResult hold_result_of(const Json& json) {
  return {enum_at<Failure>(json, "failure"),
          json.at("detail").get<std::string>(),
          displacement_at(json, "droop"),
          displacement_at(json, "drift"),
          displacement_at(json, "in_hand_displacement"),
          number_at(json, "slip_m"),
          newtons_of(json.at("required_force_N"))};
}

/// Returns the matrix, row by row, because a quaternion would not restore the last digits.
Json json_of(const Pose& pose) {
  Json rows = Json::array();
  for (int r = 0; r < 4; ++r) {
    Json row = Json::array();
    for (int c = 0; c < 4; ++c) row.push_back(pose.matrix()(r, c));
    rows.push_back(row);
  }
  return rows;
}

Pose pose_of(const Json& json) {
  Pose pose;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) pose.matrix()(r, c) = json.at(r).at(c).get<double>();
  return pose;
}

Json json_of(const Rollout& rollout) {
  const Variation& variation = rollout.variation;
  Json directions = Json::array();
  for (const HoldResult& hold : rollout.load_directions) directions.push_back(json_of(hold));
  return {{"friction", variation.friction},
          {"torsional_friction_m", variation.torsional_friction_m},
          {"mass_kg", variation.mass_kg},
          {"base_from_target", json_of(variation.base_from_target)},
          {"arm_error", rollout.arm_error},
          {"hand_error", rollout.hand_error},
          {"contact_s", number(rollout.contact_s)},
          {"pregrasp_displacement", json_of(rollout.pregrasp_displacement)},
          {"torque_ratio", rollout.torque_ratio},
          {"commanded_force_N", rollout.commanded_force_N},
          {"required_force_worst_N", number(rollout.required_force_worst_N)},
          {"required_force_gravity_N", number(rollout.required_force_gravity_N)},
          {"measured_force_N", rollout.measured_force_N},
          {"lift", json_of(rollout.lift)},
          {"task", rollout.task ? json_of(*rollout.task) : Json(nullptr)},
          {"load_directions", directions}};
}

Rollout rollout_of(const Json& json) {
  Rollout rollout;
  rollout.variation = {number_at(json, "friction"), number_at(json, "torsional_friction_m"),
                       number_at(json, "mass_kg"), pose_of(json.at("base_from_target"))};
  rollout.arm_error = number_at(json, "arm_error");
  rollout.hand_error = number_at(json, "hand_error");
  rollout.contact_s = value_of(json.at("contact_s"));
  rollout.pregrasp_displacement = displacement_at(json, "pregrasp_displacement");
  rollout.torque_ratio = number_at(json, "torque_ratio");
  rollout.commanded_force_N = number_at(json, "commanded_force_N");
  rollout.required_force_worst_N = newtons_of(json.at("required_force_worst_N"));
  rollout.required_force_gravity_N = newtons_of(json.at("required_force_gravity_N"));
  rollout.measured_force_N = json.at("measured_force_N").get<std::vector<double>>();
  rollout.lift = hold_result_of(json.at("lift"));
  if (!json.at("task").is_null()) rollout.task = task_result_of(json.at("task"));
  for (const Json& hold : json.at("load_directions"))
    rollout.load_directions.push_back(hold_result_of(hold));
  return rollout;
}

PlanResult result_of(const Json& json) {
  PlanResult result;
  result.plan = json.at("plan").get<std::string>();
  result.plan_sha256 = json.at("plan_sha256").get<std::string>();
  result.not_verified = json.at("not_verified").get<std::string>();
  result.skip_reason = enum_at<SkipReason>(json, "skip_reason");
  result.detail = json.at("detail").get<std::string>();
  result.notes = json.at("notes").get<std::vector<std::string>>();
  for (const Json& press : json.at("finger_forces")) {
    result.tips.push_back(press.at("tip_name").get<std::string>());
    result.finger_forces.push_back({press.at("tip").get<int>(), vector_of(press.at("point")),
                                    vector_of(press.at("normal")), number_at(press, "force_N"),
                                    vector_of(press.at("friction_force_N"))});
  }
  result.contact_source = enum_at<ContactSource>(json, "contact_source");
  result.force_scale = number_at(json, "force_scale");
  result.planned_contact_s = value_of(json.at("planned_contact_s"));
  for (const Json& rollout : json.at("rollouts")) result.rollouts.push_back(rollout_of(rollout));
  return result;
}

}  // namespace

std::string result_json(const PlanResult& result, const SimulateOptions& options,
                        const std::string& key) {
  Json finger_forces = Json::array(), rollouts = Json::array();
  for (int k = 0; k < std::ssize(result.finger_forces); ++k) {
    const FingerForce& press = result.finger_forces[k];
    finger_forces.push_back({{"tip", press.tip},
                             {"tip_name", result.tips[k]},
                             {"point", json_of(press.point)},
                             {"normal", json_of(press.normal)},
                             {"force_N", press.force_N},
                             {"friction_force_N", json_of(press.friction_force_N)}});
  }
  for (const Rollout& rollout : result.rollouts) rollouts.push_back(json_of(rollout));
  Json settings;
  const auto add = [&](const char* name, const auto& value) { settings[name] = value; };
  fields(add, options);
  Json json = {{"format", kFormat},
               {"version", kVersion},
               {"software", software()},
               {"engine", physics::engine_version()},
               {"input_sha256", key},
               {"options", settings},
               {"assumptions", assumptions(options)},
               {"plan", result.plan},
               {"plan_sha256", result.plan_sha256},
               {"not_verified", result.not_verified},
               {"skip_reason", name_of(result.skip_reason)},
               {"detail", result.detail},
               {"notes", result.notes},
               {"held", result.held_count()},
               {"finger_forces", finger_forces},
               {"contact_source", name_of(result.contact_source)},
               {"force_scale", result.force_scale},
               {"planned_contact_s", number(result.planned_contact_s)},
               {"rollouts", rollouts}};
  json[kOwnHash] = hash_without_own(json);
  return json.dump(1) + "\n";
}

std::optional<PlanResult> read_result(const std::filesystem::path& file, const std::string& key) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    const Json json = Json::parse(text);
    if (json.at("input_sha256") != key || json.at(kOwnHash) != hash_without_own(json))
      return std::nullopt;
    return result_of(json);
    // A file of another version or program, or one that was changed, counts as missing.
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

StoredResult load_result(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat || json.at("version") != kVersion)
      throw InputError("it has another format or version");
    if (json.at(kOwnHash) != hash_without_own(json))
      throw InputError("it was changed since; simulate again into this folder");
    return {result_of(json), json.at("engine").get<std::string>()};
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("{}: is not a result of morphe simulate: {}", file.string(), error.what()));
  }
}

}  // namespace morphe::simulate
