#include "stages/study/study.hpp"

#include <fmt/format.h>

#include <array>

#include "pipeline/config/node.hpp"

namespace morphe {
namespace {

struct Entry {
  const char* name;
  StudyResult (*run)(const ConfigNode&, const StudyRun&);
};

constexpr std::array<Entry, 5> kStudies{{{"recordings", recordings_study},
                                         {"paper", paper_study},
                                         {"mapping", mapping_study},
                                         {"repair", repair_study},
                                         {"retime", retime_study}}};

}  // namespace

StudyResult run_study(const StudyRun& run) {
  const ConfigNode root = ConfigNode::load(run.config);
  const ConfigNode name = root["study"];
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

}  // namespace morphe
