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
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {
namespace {

/// Checks that every movement of a demonstration is present, numbered from 000 without gaps.
void verify_plan_numbering(const std::vector<std::string>& paths, ViolationLog& violations) {
  if (paths.empty()) violations.note_plan("structure", "plans", 0, 1);
  std::map<std::string, int> number;
  for (const std::string& path : paths) {
    const std::string demonstration = path.substr(0, path.find('/'));
    const std::string expected = fmt::format("{}/{:03}", demonstration, number[demonstration]++);
    if (path != expected)
      violations.note_plan("structure", "plans/" + expected, kUnknown, kUnknown);
  }
}

/// Returns the file's request; nullopt, and a violation, if it cannot be determined.
std::optional<PlanRequest> verify_header(const store::PlanReader& reader,
                                         const RequirementsReader& read_request,
                                         ViolationLog& violations) {
  if (!read_request) return std::nullopt;
  try {
    const PlanRequest request = read_request(reader.header());
    if (reader.header().config_sha256 != request.config_sha256)
      violations.note_plan("config", "config_sha256", kUnknown, kUnknown);
    verify_robot(reader.robot(), request.robot, violations);
    return request;
  } catch (const InputError& error) {
    std::string message = error.what();
    std::ranges::replace(message, '\n', ';');
    violations.note_plan("config", message, kUnknown, kUnknown);
    return std::nullopt;
  }
}

using NamedPlan = std::pair<std::string, Plan>;

struct VerifiedPlan {
  Status status = Status::infeasible;
  std::vector<Violation> violations;
};

}  // namespace

VerifyReport verify_file(const std::filesystem::path& file, const RequirementsReader& read_request,
                         int jobs) {
  const store::PlanReader reader(file);
  VerifyReport report;
  ViolationLog violations("");
  verify_plan_numbering(reader.plan_paths(), violations);
  const std::optional<PlanRequest> request = verify_header(reader, read_request, violations);
  report.violations = violations.finish();
  const bool comparable = request && request->robot.joint_names == reader.robot().joint_names;
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
                                                comparable ? &*request : nullptr)});
  };
  map.write = [&](const VerifiedPlan& verified) {
    ++(verified.status == Status::executable    ? report.executable
       : verified.status == Status::approximate ? report.approximate
                                                : report.infeasible);
    for (const Violation& violation : verified.violations) report.violations.push_back(violation);
  };
  parallel::run(map, jobs);
  return report;
}

}  // namespace morphe::verify
