#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "core/motion/input_error.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/store/plan_file.hpp"
#include "stages/verify/requirements.hpp"
#include "stages/verify/verify.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {
namespace {

/// Checks that every movement of a demonstration is present, numbered from 000 without gaps.
void verify_plan_numbering(const std::vector<std::string>& paths, ViolationCollector& runs) {
  if (paths.empty()) runs.note_plan("structure", "plans", 0, 1);
  std::map<std::string, int> next;
  for (const std::string& path : paths) {
    const std::string demonstration = path.substr(0, path.find('/'));
    const std::string wanted = fmt::format("{}/{:03}", demonstration, next[demonstration]++);
    if (path != wanted) runs.note_plan("structure", "plans/" + wanted, kUnknown, kUnknown);
  }
}

/// Returns the file's request; nullopt if it cannot be determined, which is recorded as a
/// violation.
std::optional<PlanRequest> verify_header(const store::PlanReader& reader,
                                         const RequirementsReader& asked_of,
                                         ViolationCollector& runs) {
  if (!asked_of) return std::nullopt;
  try {
    const PlanRequest asked = asked_of(reader.header());
    if (reader.header().config_sha256 != asked.config_sha256)
      runs.note_plan("config", "config_sha256", kUnknown, kUnknown);
    verify_robot(reader.robot(), asked.robot, runs);
    return asked;
  } catch (const InputError& error) {
    std::string sentence = error.what();
    std::ranges::replace(sentence, '\n', ';');
    runs.note_plan("config", sentence, kUnknown, kUnknown);
    return std::nullopt;
  }
}

using NamedPlan = std::pair<std::string, Plan>;

struct VerifiedPlan {
  Status status = Status::infeasible;
  std::vector<Violation> violations;
};

}  // namespace

VerifyReport verify_file(const std::filesystem::path& file, const RequirementsReader& asked_of,
                         int jobs) {
  const store::PlanReader reader(file);
  VerifyReport report;
  ViolationCollector of_the_file("");
  verify_plan_numbering(reader.plan_paths(), of_the_file);
  const std::optional<PlanRequest> asked = verify_header(reader, asked_of, of_the_file);
  report.violations = of_the_file.finish();
  const bool comparable = asked && asked->robot.joint_names == reader.robot().joint_names;
  parallel::OrderedParallelMap<NamedPlan, VerifiedPlan> map;
  map.next = [&, i = std::size_t{0}]() mutable {
    if (i == reader.plan_paths().size()) return std::unique_ptr<NamedPlan>();
    const std::string& path = reader.plan_paths()[i];
    return std::make_unique<NamedPlan>(path, reader.read(i++));
  };
  map.work = [&](const NamedPlan& named) {
    const auto& [path, plan] = named;
    return std::make_unique<VerifiedPlan>(
        VerifiedPlan{plan.status(), verify_plan(reader.robot(), path, plan, reader.header().config,
                                                comparable ? &*asked : nullptr)});
  };
  map.write = [&](const VerifiedPlan& judged) {
    ++(judged.status == Status::executable    ? report.executable
       : judged.status == Status::approximate ? report.approximate
                                              : report.infeasible);
    report.violations.insert(report.violations.end(), judged.violations.begin(),
                             judged.violations.end());
  };
  parallel::run(map, jobs);
  return report;
}

}  // namespace morphe::verify
