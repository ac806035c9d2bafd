#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"

namespace morphe::run {

/// The outcome of a demonstration: a plan for each movement, or why it could not be processed.
struct DemonstrationOutcome {
  std::string demonstration;                  ///< its name
  std::vector<Plan> plans;                    ///< one for each movement
  std::string error;                          ///< "" unless the demonstration failed
  std::map<std::string, double> stage_cpu_s;  ///< processor time, for the summary only
};

/// The counts over a run or a part of it.
struct BatchSummary {
  int demonstrations = 0, movements = 0;
  int executable = 0, approximate = 0, partial = 0, infeasible = 0;  ///< movements
  int repaired = 0;                                                  ///< movements
  int failed = 0;                                                    ///< demonstrations
  std::map<std::string, int> reasons;         ///< of infeasible movements, with their number
  std::map<std::string, double> stage_cpu_s;  ///< processor time by stage
  std::int64_t mapped = 0, frames = 0;        ///< mapped movements, and their frames
  std::int64_t goals = 0, out_of_reach = 0;   ///< fingertip goals in all mapped frames
  std::map<std::string, int> branches;        ///< words of branches, with the number of their plans
  int reused = 0;                             ///< demonstrations that an earlier run had finished
};

/// Returns the summary of one demonstration.
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

/// Returns plan(demonstration); an exception becomes the error of a failed demonstration. A want of
/// memory is thrown on, because it says nothing about the demonstration.
DemonstrationOutcome attempt(const std::function<DemonstrationOutcome(const Demonstration&)>& plan,
                             const Demonstration& demonstration);

/// Plans every demonstration on up to `jobs` threads, with attempt(). Returns the sum of summaries.
BatchSummary run_batch(const Batch& batch, int jobs);

/// Returns "5 demonstrations, 5 movements: 3 executable (1 repaired), 1 approximate, 1 partial, 1
/// infeasible (no_goal 1), 1 failed; 2 reused from an earlier run", the last two, approximate and
/// partial only if any.
std::string summary_sentence(const BatchSummary& summary);
/// Returns the frames of mapped movements per second of processor time; 0 if no time was measured.
double frames_per_cpu_second(const BatchSummary& summary);
/// Returns the processor time of each stage per mapped movement [ms]; empty without one.
std::map<std::string, double> stage_ms_per_movement(const BatchSummary& summary);
/// Returns "569 frames; 323 frames/s per core; 352 ms per movement: map 298, certify 34", or "" if
/// no movement was mapped. The longest stages come first; those that round to 0 ms are left out.
std::string speed_text(const BatchSummary& summary);
/// Converts a summary, except `reused`, to the JSON that the journal stores.
std::string serialize_summary(const BatchSummary& summary);
/// Converts this JSON back to a summary. Throws InputError for any other text.
BatchSummary deserialize_summary(const std::string& text);
/// Returns the JSON that `--json` prints, as docs/formats.md defines it.
std::string summary_json(const BatchSummary& summary);

}  // namespace morphe::run
