#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "pipeline/motion/input_error.hpp"
#include "pipeline/store/plan_file.hpp"
#include "pipeline/verify/as_asked.hpp"
#include "pipeline/verify/verify.hpp"
#include "pipeline/verify/violation_runs.hpp"

namespace morphe::verify {
namespace {

/// Every movement of a demonstration is there, from 000 on: none was left out.
void judge_numbers(const std::vector<std::string>& paths, ViolationRuns& runs) {
  if (paths.empty()) runs.note_plan("structure", "plans", 0, 1);
  std::map<std::string, int> next;
  for (const std::string& path : paths) {
    const std::string demonstration = path.substr(0, path.find('/'));
    const std::string wanted = fmt::format("{}/{:03}", demonstration, next[demonstration]++);
    if (path != wanted) runs.note_plan("structure", "plans/" + wanted, kNotSeen, kNotSeen);
  }
}

/// Nothing if it cannot be told what the file asks for: that is a violation itself.
std::optional<Asked> judge_header(const store::PlanReader& reader, const AskedOf& asked_of,
                                  ViolationRuns& runs) {
  if (!asked_of) return std::nullopt;
  try {
    const Asked asked = asked_of(reader.header());
    if (reader.header().config_sha256 != asked.config_sha256)
      runs.note_plan("config", "config_sha256", kNotSeen, kNotSeen);
    judge_robot(reader.robot(), asked.robot, runs);
    return asked;
  } catch (const InputError& error) {
    std::string sentence = error.what();
    std::ranges::replace(sentence, '\n', ';');
    runs.note_plan("config", sentence, kNotSeen, kNotSeen);
    return std::nullopt;
  }
}

}  // namespace

VerifyReport verify_file(const std::filesystem::path& file, const AskedOf& asked_of) {
  const store::PlanReader reader(file);
  VerifyReport report;
  ViolationRuns of_the_file("");
  judge_numbers(reader.plan_paths(), of_the_file);
  const std::optional<Asked> asked = judge_header(reader, asked_of, of_the_file);
  report.violations = of_the_file.finish();
  for (std::size_t i = 0; i < reader.plan_paths().size(); ++i) {
    const Plan plan = reader.read(i);
    const Status status = plan.status();
    ++(status == Status::executable    ? report.executable
       : status == Status::approximate ? report.approximate
                                       : report.infeasible);
    const std::vector<Violation> found = verify_plan(
        reader.robot(), reader.plan_paths()[i], plan, reader.header().config,
        asked && asked->robot.joint_names == reader.robot().joint_names ? &*asked : nullptr);
    report.violations.insert(report.violations.end(), found.begin(), found.end());
  }
  return report;
}

}  // namespace morphe::verify
