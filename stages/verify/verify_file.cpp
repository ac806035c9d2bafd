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

bool is_sha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

void note_contract_faults(const std::vector<std::string>& faults, ViolationLog& violations) {
  for (const std::string& fault : faults)
    violations.note_plan("structure", fault, kUnknown, kUnknown);
}

/// Returns the file's request; nullopt, and a violation, if it cannot be determined.
std::optional<PlanRequest> verify_header(const store::PlanReader& reader,
                                         const RequirementsReader& read_request,
                                         ViolationLog& violations) {
  if (!read_request) return std::nullopt;
  try {
    const PlanRequest request = read_request(reader.header());
    for (const std::string& fault : request.header_faults)
      violations.note_plan("config", fault, kUnknown, kUnknown);
    verify_robot(reader.robot(), request.robot, violations);
    verify_assumptions(reader.header().assumptions, request.assumptions, violations);
    return request;
  } catch (const InputError& error) {
    std::string message = error.what();
    std::ranges::replace(message, '\n', ';');
    violations.note_plan("config", message, kUnknown, kUnknown);
    return std::nullopt;
  }
}

struct NamedPlan {
  std::string path;
  Plan plan;
  std::vector<std::string> contract_faults;
};

/// Verifies a plan of a file whose request, if there is one, is comparable with its robot.
std::vector<Violation> verify_named_plan(const store::PlanReader& reader, const NamedPlan& named,
                                         const PlanRequest* request) {
  const Plan& plan = named.plan;
  std::vector<Violation> violations =
      verify_plan(reader.robot(), named.path, plan, reader.header().config, request);
  ViolationLog lacking(named.path);
  note_contract_faults(named.contract_faults, lacking);
  if (request && lacks_origins_and_kinds(plan))
    lacking.note_plan("config", "clearance_by_kind", 0, 1);
  for (Violation& violation : lacking.finish()) violations.push_back(std::move(violation));
  return violations;
}

struct VerifiedPlan {
  std::string path;
  double begin_s = 0;
  Status status = Status::infeasible;
  std::vector<Violation> violations;
  std::vector<Assumption> assumptions;  ///< of a plan with a trajectory
};

/// Returns true if a movement does not begin after the previous one of its demonstration.
bool is_doubled(const VerifiedPlan& previous, const VerifiedPlan& plan) {
  const std::string demonstration = plan.path.substr(0, plan.path.find('/') + 1);
  return previous.path.starts_with(demonstration) && !(plan.begin_s > previous.begin_s);
}

int& count_of(Status status, VerifyReport& report) {
  switch (status) {
    case Status::executable:
      return report.executable;
    case Status::approximate:
      return report.approximate;
    case Status::partial:
      return report.partial;
    default:
      return report.infeasible;
  }
}

}  // namespace

VerifyReport verify_file(const std::filesystem::path& file, const RequirementsReader& read_request,
                         int jobs) {
  const store::PlanReader reader(file);
  VerifyReport report;
  ViolationLog violations("");
  verify_plan_numbering(reader.plan_paths(), violations);
  note_contract_faults(reader.contract_faults(), violations);
  if (!is_sha256(reader.header().dataset_sha256))
    violations.note_plan("structure", "@dataset_sha256 is no hash", kUnknown, kUnknown);
  const std::optional<PlanRequest> request = verify_header(reader, read_request, violations);
  report.violations = violations.finish();
  report.assumptions = reader.header().assumptions;
  report.looked_at.inputs = request.has_value();
  const bool comparable = request && request->robot.joint_names == reader.robot().joint_names;
  parallel::OrderedParallelMap<NamedPlan, VerifiedPlan> map;
  map.next = [&, i = std::size_t{0}]() mutable {
    if (i == reader.plan_paths().size()) return std::unique_ptr<NamedPlan>();
    const std::string& path = reader.plan_paths()[i];
    auto named = std::make_unique<NamedPlan>(NamedPlan{path, reader.read(i), {}});
    named->contract_faults = reader.contract_faults(i++, named->plan);
    return named;
  };
  map.work = [&](const NamedPlan& named) {
    const Plan& plan = named.plan;
    return std::make_unique<VerifiedPlan>(
        VerifiedPlan{named.path, plan.movement.begin_s, plan.status(),
                     verify_named_plan(reader, named, comparable ? &*request : nullptr),
                     plan.has_trajectory() ? plan_assumptions(plan) : std::vector<Assumption>()});
  };
  map.write = [&, previous = VerifiedPlan()](const VerifiedPlan& verified) mutable {
    if (is_doubled(previous, verified))
      report.violations.push_back(
          {verified.path, -1, 0, "structure", "begin_s", verified.begin_s, previous.begin_s, "s"});
    previous = {verified.path, verified.begin_s, verified.status, {}, {}};
    ++count_of(verified.status, report);
    report.plan_assumptions.add(verified.assumptions);
    for (const Violation& violation : verified.violations) report.violations.push_back(violation);
  };
  parallel::run(map, jobs);
  return report;
}

}  // namespace morphe::verify
