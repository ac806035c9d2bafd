#include "pipeline/run/write_plans.hpp"

#include "pipeline/store/bytes.hpp"

namespace morphe::run {

void write_plans(const Journal& journal, const std::string& demonstration,
                 store::PlanWriter& writer) {
  journal.each_plan(demonstration, [&](const Finished::StoredPlan& plan) {
    writer.add(store::plan_from_bytes(plan.bytes));
  });
}

}  // namespace morphe::run
