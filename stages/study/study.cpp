#include "stages/study/study.hpp"

#include <fmt/format.h>

#include <array>

#include "pipeline/config/node.hpp"

namespace morphe::study {
namespace {

struct Entry {
  const char* name;
  StudyResult (*run)(const config::ConfigNode&, const StudyRun&);
};

constexpr std::array<Entry, 6> kStudies{{{"recordings", recordings_study},
                                         {"paper", paper_study},
                                         {"mapping", mapping_study},
                                         {"repair", repair_study},
                                         {"retime", retime_study},
                                         {"hands", hands_study}}};

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
  std::string known;
  for (const Entry& entry : kStudies) known += fmt::format(" {}", entry.name);
  name.fail(fmt::format("there is no study '{}'; known:{}", name.text(), known));
}

StudyRow row_of(const Case& of, const std::string& metric, const std::string& unit, double ours,
                std::size_t n) {
  StudyRow row;
  row.of = of;
  row.metric = metric;
  row.unit = unit;
  row.ours = ours;
  row.n = n;
  return row;
}

}  // namespace morphe::study
