#include "pipeline/store/plan_file.hpp"
#include "pipeline/verify/verify.hpp"

namespace morphe::verify {

VerifyReport verify_file(const std::filesystem::path& file) {
  const store::PlanReader reader(file);
  VerifyReport report;
  for (std::size_t i = 0; i < reader.plan_paths().size(); ++i) {
    const Plan plan = reader.read(i);
    const Status status = plan.status();
    ++(status == Status::executable    ? report.executable
       : status == Status::approximate ? report.approximate
                                       : report.infeasible);
    const std::vector<Violation> found =
        verify_plan(reader.robot(), reader.plan_paths()[i], plan, reader.header().config);
    report.violations.insert(report.violations.end(), found.begin(), found.end());
  }
  return report;
}

}  // namespace morphe::verify
