#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"

namespace morphe::run {

/// What became of one demonstration: a plan for each of its movements, or why it could not be
/// processed at all.
struct DemonstrationOutcome {
  std::string demonstration;
  std::vector<Plan> plans;
  std::string error;  ///< "" unless it failed
  /// Of processor time, by stage, for the summary alone.
  std::map<std::string, double> stage_seconds;
};

/// Counts over a run, as `morphe run --json` prints them.
struct BatchSummary {
  int demonstrations = 0, movements = 0, executable = 0, approximate = 0, infeasible = 0;
  int repaired = 0, failed = 0;
  std::map<std::string, int> reasons;  ///< of infeasible movements
  std::map<std::string, double> stage_seconds;
  std::int64_t mapped = 0, frames = 0;       ///< movements that were mapped; frames of theirs
  std::int64_t goals = 0, out_of_reach = 0;  ///< of fingertips, over all frames that were mapped
  int reused = 0;                            ///< demonstrations that an earlier run had finished
};

/// Of one demonstration; sums add up.
BatchSummary summary_of(const DemonstrationOutcome& outcome);
void add(const BatchSummary& more, BatchSummary& sum);

struct Batch {
  std::function<std::unique_ptr<Demonstration>()> next;  ///< null at the end
  std::function<DemonstrationOutcome(const Demonstration&)> plan;
  std::function<void(const DemonstrationOutcome&)> write;  ///< in the order of the dataset
};

/// `plan` without exceptions: one makes the demonstration a failed one.
DemonstrationOutcome attempt(const std::function<DemonstrationOutcome(const Demonstration&)>& plan,
                             const Demonstration& demonstration);

/// Plans every demonstration on up to `jobs` threads. An exception thrown by `plan` makes that
/// demonstration a failed one; the run goes on.
BatchSummary run_batch(const Batch& batch, int jobs);

/// "5 demonstrations, 5 movements: 4 executable (1 repaired), 1 infeasible (no_goal 1)"; those that
/// are approximate, if any, stand between the two.
std::string summary_text_for_people(const BatchSummary& summary);
/// Frames of mapped movements for each second of processor time of all steps; 0 if there are none.
double frames_per_second(const BatchSummary& summary);
/// Processor time of each step, milliseconds for each movement that was mapped.
std::map<std::string, double> movement_ms(const BatchSummary& summary);
/// "569 frames planned, 323 for each second of a core; 352 ms a movement: map 298, certify 34", ""
/// if nothing was mapped. The longest steps first; what rounds to nothing is left out.
std::string speed_text(const BatchSummary& summary);
/// As docs/formats.md says: what `--json` prints.
std::string summary_json(const BatchSummary& summary);

}  // namespace morphe::run
