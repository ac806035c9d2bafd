#include "pipeline/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "core/config/spelling_hint.hpp"
#include "pipeline/study/grasp_options.hpp"
#include "pipeline/study/hands_options.hpp"
#include "pipeline/study/mapping_options.hpp"
#include "pipeline/study/paper_options.hpp"
#include "pipeline/study/recordings_options.hpp"
#include "pipeline/study/repair_options.hpp"
#include "pipeline/study/retime_options.hpp"
#include "pipeline/study/trade_off_options.hpp"

namespace morphe::study {
namespace {

struct Entry {
  const char* name;
  StudyResult (*run)(const config::ConfigNode&, const StudyRun&);
  config::Schema (*schema)(const config::KeyDescriptions&, bool);
};

constexpr std::array<Entry, 8> kStudies{
    {{"recordings", recordings_study, config::schema_of<RecordingsStudyOptions>},
     {"paper", paper_study, config::schema_of<PaperStudyOptions>},
     {"mapping", mapping_study, config::schema_of<MappingStudyOptions>},
     {"repair", repair_study, config::schema_of<RepairStudyOptions>},
     {"retime", retime_study, config::schema_of<RetimeStudyOptions>},
     {"hands", hands_study, config::schema_of<HandsStudyOptions>},
     {"grasp", grasp_study, config::schema_of<GraspStudyOptions>},
     {"trade_off", trade_off_study, config::schema_of<TradeOffStudyOptions>}}};

}  // namespace

StudyResult run_study(const StudyRun& run) {
  const config::ConfigNode root = config::ConfigNode::load(run.config);
  const config::ConfigNode name = root["study"];
  for (const Entry& entry : kStudies) {
    if (name.text() != entry.name) continue;
    StudyResult result = entry.run(root, run);
    result.study = entry.name;
    return result;
  }
  std::vector<std::string> known;
  for (const Entry& entry : kStudies) known.emplace_back(entry.name);
  const std::string meant = config::spelling_hint(name.text(), known);
  name.fail(
      fmt::format("unknown study '{}'{}", name.text(),
                  meant.empty() ? fmt::format("; available: {}", fmt::join(known, ", ")) : meant));
}

config::Schema study_schema(const config::KeyDescriptions& meanings) {
  std::vector<std::string> names;
  config::Schema schema{{"type", "object"}, {"required", {"study"}}};
  for (const Entry& entry : kStudies) {
    names.emplace_back(entry.name);
    const config::Schema is_named{{"properties", {{"study", {{"const", entry.name}}}}}};
    schema["allOf"].push_back({{"if", is_named}, {"then", entry.schema(meanings, false)}});
  }
  schema["properties"]["study"] = config::enum_schema(names);
  return schema;
}

Case case_with(Case condition, const std::string& name, const std::string& value) {
  condition.emplace_back(name, value);
  return condition;
}

StudyRow& StudyResult::add(const Case& condition, const std::string& metric,
                           const std::string& unit, double ours, std::ptrdiff_t n) {
  StudyRow& row = rows.emplace_back();
  row.case_values = condition;
  row.metric = metric;
  row.unit = unit;
  row.ours = ours;
  row.count = n;
  return row;
}

}  // namespace morphe::study
