#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"

namespace morphe::run {

/// The outcome of one demonstration: a plan for each of its movements, or the reason for which it
/// could not be processed at all.
struct DemonstrationOutcome {
  /// The name of the demonstration.
  std::string demonstration;
  /// The plans, one for each movement.
  std::vector<Plan> plans;
  /// The error, "" unless the demonstration failed.
  std::string error;
  /// The processor time of each stage [s]. It is used for the summary only.
  std::map<std::string, double> stage_cpu_s;
};

/// The counts over a run, as `morphe run --json` prints them.
struct BatchSummary {
  /// The number of demonstrations, of their movements, and of the movements of each status.
  int demonstrations = 0, movements = 0, executable = 0, approximate = 0, infeasible = 0;
  /// The number of movements that were repaired and of demonstrations that failed.
  int repaired = 0, failed = 0;
  /// Number of infeasible movements for each reason.
  std::map<std::string, int> reasons;
  /// The processor time of each stage [s].
  std::map<std::string, double> stage_cpu_s;
  std::int64_t mapped = 0,
               frames = 0;  ///< number of movements that were mapped, and of their frames
  /// Number of fingertip goals over all mapped frames.
  std::int64_t goals = 0, out_of_reach = 0;
  /// Number of demonstrations that an earlier run had finished.
  int reused = 0;
};

/// Returns the summary of one demonstration. Summaries of several demonstrations can be added.
BatchSummary summary_of(const DemonstrationOutcome& outcome);
/// Adds the counts and times of `more` to `sum`.
void add(const BatchSummary& more, BatchSummary& sum);

/// The callbacks by which a batch of demonstrations is read, planned and written.
struct Batch {
  /// Returns the next demonstration, null at the end.
  std::function<std::unique_ptr<Demonstration>()> next;
  /// Plans one demonstration.
  std::function<DemonstrationOutcome(const Demonstration&)> plan;
  /// Writes an outcome; called in the order of the dataset.
  std::function<void(const DemonstrationOutcome&)> write;
};

/// Calls `plan` and turns an exception into a failed demonstration.
DemonstrationOutcome attempt(const std::function<DemonstrationOutcome(const Demonstration&)>& plan,
                             const Demonstration& demonstration);

/// Plans every demonstration on up to `jobs` threads. An exception thrown by `plan` makes that
/// demonstration a failed one, and the run continues.
BatchSummary run_batch(const Batch& batch, int jobs);

/// Returns "5 demonstrations, 5 movements: 4 executable (1 repaired), 1 infeasible (no_goal 1)".
/// The number of approximate movements, if there are any, is given between the two.
std::string summary_sentence(const BatchSummary& summary);
/// Returns the number of frames of mapped movements per second of processor time of all stages, 0
/// if there are no such frames.
double frames_per_cpu_second(const BatchSummary& summary);
/// Returns the processor time of each stage per mapped movement [ms].
std::map<std::string, double> stage_ms_per_movement(const BatchSummary& summary);
/// Returns "569 frames; 323 frames/s per core; 352 ms per movement: map 298, certify
/// 34", or "" if no movement was mapped. The longest stages come first; stages that round to 0 ms
/// are left out.
std::string speed_text(const BatchSummary& summary);
/// Returns the JSON that `--json` prints, as docs/formats.md defines it.
std::string summary_json(const BatchSummary& summary);

}  // namespace morphe::run
