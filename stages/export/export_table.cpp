#include <fstream>

#include "core/motion/input_error.hpp"
#include "stages/export/export_run.hpp"
#include "stages/export/table/plan_table.hpp"

namespace morphe::exports {

void export_table(ExportRun& run) {
  files::AtomicFile& csv = run.files.add("plans.csv");
  files::AtomicFile& parquet = run.files.add("plans.parquet");
  std::ofstream text(csv.part(), std::ios::binary);
  PlanTableWriter table(parquet.part(), parquet.target().string());
  text << table_csv_head();
  for (const ChosenPlan& chosen : run.selection.plans) {
    const Plan plan = run.reader.read(chosen.index);
    const PlanEntry entry{run.reader.robot(), plan, chosen.side};
    text << table_csv_row(entry);
    table.add(entry);
    run.selection.counts.add_chosen(plan, chosen.side);
  }
  table.finish();
  text.close();
  if (!text) throw InputError(csv.target().string() + ": cannot be written");
  run.files.add("README.md",
                card_of(run, "Table of quality", "",
                        "One row per plan in `plans.csv` and `plans.parquet`, also for plans that "
                        "are infeasible. Numbers are in SI units; an empty cell, or null, is "
                        "unknown or does not apply.\n\n" +
                            columns_markdown()));
}

}  // namespace morphe::exports
