#include "pipeline/run/write_plans.hpp"

#include <fmt/format.h>

#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"

namespace morphe::run {
namespace {

Plan plan_of(const Journal& journal, const std::string& demonstration, const std::string& bytes) {
  try {
    Plan plan = store::plan_from_bytes(bytes);
    if (plan.demonstration == demonstration) return plan;
  } catch (const InputError&) {
  }
  journal.fail_damaged(fmt::format("{}: a plan cannot be read", demonstration));
}

}  // namespace

void write_plans(const Journal& journal, const std::string& demonstration,
                 store::PlanWriter& writer) {
  journal.each_plan(demonstration, [&](const FinishedDemonstration::StoredPlan& plan) {
    writer.add(plan_of(journal, demonstration, plan.bytes));
  });
}

}  // namespace morphe::run
