#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/motion/flag_text.hpp"
#include "core/store/flags_json.hpp"
#include "pipeline/commands/inspect_report.hpp"

namespace morphe::commands {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const StreamReport& s) {
  return {{"name", s.name},
          {"rate_hz", s.rate_hz},
          {"valid_share", s.valid_share},
          {"begin_s", s.begin_s},
          {"duration_s", s.duration_s},
          {"columns", s.columns},
          {"gaps", s.gaps},
          {"longest_gap_s", s.longest_gap_s},
          {"longest_gap_column", s.longest_gap_column},
          {"empty_columns", s.empty_columns}};
}

Json json_of(const MovementReport& report) {
  Json phases = Json::array();
  for (const Phase& phase : report.movement.phases)
    phases.push_back({{"name", name_of(phase.kind)},
                      {"begin_s", phase.begin_s},
                      {"end_s", phase.end_s},
                      {"confidence", phase.confidence},
                      {"begin_confidence", phase.begin_confidence},
                      {"end_confidence", phase.end_confidence}});
  return {{"begin_s", report.movement.begin_s},
          {"end_s", report.movement.end_s},
          {"phases", phases},
          {"target", report.movement.target},
          {"flags", store::flags_json(report.flags)},
          {"unusable_reason", report.unusable_reason}};
}

Json json_of(const imports::PointSummary& point) {
  const auto vector = [](const Vec3& v) {
    return is_known(v) ? Json::array({v.x(), v.y(), v.z()}) : Json(nullptr);
  };
  return {{"name", point.name},
          {"body_part", point.body_part},
          {"valid_share", point.seen_share},
          {"centre_m", vector(point.centre)},
          {"extent_m", vector(point.extent)}};
}

template <class Items>
Json json_list(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(json_of(item));
  return list;
}

Json json_of(const Inspection& i) {
  Json rebuilt = Json::object(), residuals = Json::array();
  for (const auto& [point, share] : i.reconstructed_shares) rebuilt[point] = share;
  for (const Residual& r : i.residuals)
    residuals.push_back({{"name", r.name},
                         {"rms_m", std::isfinite(r.rms_m) ? Json(r.rms_m) : Json(nullptr)},
                         {"max_m", std::isfinite(r.max_m) ? Json(r.max_m) : Json(nullptr)}});
  return {{"name", i.name},
          {"duration_s", i.duration_s},
          {"streams", json_list(i.streams)},
          {"movements", json_list(i.movements)},
          {"flags", store::flags_json(i.flags)},
          {"problems", i.problems},
          {"subject", i.subject},
          {"task", i.task},
          {"hand", name_of(i.hand)},
          {"calibration", json_list(i.calibration)},
          {"objects", i.objects},
          {"rebuilt", rebuilt},
          {"residuals", residuals},
          {"estimated", i.estimated},
          {"missing", i.missing},
          {"reports", i.import_notes},
          {"points", json_list(i.survey.points)}};
}

void add_stream(const StreamReport& s, const char* prefix, std::string& text) {
  text += fmt::format("  {}{}: {} columns, {:.2f} Hz, {:.2f} to {:.2f} s, {:.1f} % valid", prefix,
                      s.name, s.columns, s.rate_hz, s.begin_s, s.begin_s + s.duration_s,
                      100 * s.valid_share);
  if (s.gaps > 0)
    text += fmt::format(", {} gaps (longest {:.2f} s: {})", s.gaps, s.longest_gap_s,
                        s.longest_gap_column);
  text += "\n";
  if (!s.empty_columns.empty())
    text += fmt::format("    never valid: {}\n", fmt::join(s.empty_columns, ", "));
}

void add_flags(const std::vector<RecordingFlag>& flags, const char* indent, std::string& text) {
  for (const RecordingFlag& flag : flags)
    text += fmt::format("{}flag: {}\n", indent, sentence(flag));
}

void add_movement(const MovementReport& report, std::string& text) {
  text +=
      fmt::format("  movement {:.2f} to {:.2f} s:", report.movement.begin_s, report.movement.end_s);
  for (const Phase& phase : report.movement.phases)
    text +=
        fmt::format(" {} {:.2f}-{:.2f} ({:.0f} %, {:.0f} %)", name_of(phase.kind), phase.begin_s,
                    phase.end_s, 100 * phase.begin_confidence, 100 * phase.end_confidence);
  if (!report.movement.target.empty()) text += fmt::format("; target {}", report.movement.target);
  if (!report.unusable_reason.empty())
    text += fmt::format("; unusable, {}", report.unusable_reason);
  text += "\n";
  add_flags(report.flags, "    ", text);
}

}  // namespace

std::string inspection_text(const Inspection& i) {
  std::string text = fmt::format("{}: {:.2f} s, {} hand", i.name, i.duration_s, name_of(i.hand));
  if (!i.subject.empty()) text += fmt::format(", subject {}", i.subject);
  if (!i.task.empty()) text += fmt::format(", {}", i.task);
  text += "\n";
  for (const StreamReport& stream : i.streams) add_stream(stream, "", text);
  for (const StreamReport& stream : i.calibration) add_stream(stream, "calibration ", text);
  if (!i.objects.empty()) text += fmt::format("  objects: {}\n", fmt::join(i.objects, ", "));
  std::vector<std::string> rebuilt;
  for (const auto& [point, share] : i.reconstructed_shares)
    if (share > 0) rebuilt.push_back(fmt::format("{} {:.0f} %", point, 100 * share));
  if (!rebuilt.empty()) text += fmt::format("  reconstructed: {}\n", fmt::join(rebuilt, ", "));
  for (const MovementReport& movement : i.movements) add_movement(movement, text);
  add_flags(i.flags, "  ", text);
  for (const auto& [kind, sentences] :
       {std::pair("estimated", &i.estimated), std::pair("missing", &i.missing),
        std::pair("import", &i.import_notes), std::pair("problem", &i.problems)})
    for (const std::string& sentence : *sentences)
      text += fmt::format("  {}: {}\n", kind, sentence);
  return text;
}

std::string inspections_json(const std::vector<Inspection>& inspections,
                             const std::vector<imports::SkippedFile>& skipped) {
  Json all = Json::array();
  for (const Inspection& inspection : inspections) all.push_back(json_of(inspection));
  Json json{{"demonstrations", all}};
  for (const imports::SkippedFile& file : skipped)
    json["skipped"].push_back(
        {{"file", file.file.string()}, {"reason", file.reason}, {"failed", file.failed}});
  return json.dump(2);
}

}  // namespace morphe::commands
