#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/files/disk.hpp"
#include "pipeline/run/batch.hpp"
#include "pipeline/run/journal.hpp"
#include "pipeline/run/progress.hpp"

namespace morphe::run {

/// The inputs, outputs and callbacks of a run over a dataset.
struct RunRequest {
  /// Path of demonstrations.h5.
  std::filesystem::path dataset;
  /// Path of plans.h5, which is replaced when the new file is complete.
  std::filesystem::path plans;
  /// Identity; run_dataset() fills in the hash and the size of the dataset.
  RunIdentity identity;
  /// Effective config without the paths of files.
  std::string config;
  /// Required SHA-256 of the dataset, "" for any.
  std::string expected_dataset;
  /// The dataset as it was named by the user; for the journal only.
  std::string dataset_key;
  /// The number of threads.
  int jobs = 1;
  /// The disk to which plans.h5 is written.
  files::Disk* disk = &files::real_disk();
  /// True if the reason for planning a demonstration is printed.
  bool explain = false;
  /// Plans one demonstration.
  std::function<DemonstrationOutcome(const Demonstration&)> plan;
  /// Returns the rows of a plan in the printed table.
  std::function<std::string(const Plan&)> rows;
  /// Called after plans.h5 has been moved to its final path.
  std::function<void()> publish;
};

/// The result of run_dataset().
struct RunResult {
  /// Number of the signal that stopped the run, 0 if it is complete.
  int signal = 0;
  /// The sum over the demonstrations of this run.
  BatchSummary summary;
};

/// Plans the demonstrations of the dataset (of its shard) that the journal does not yet contain,
/// and writes plans.h5 from the journal meanwhile, in the order of the dataset. The file takes its
/// final name when the run is complete. After a signal (StopSignal) the demonstrations that are
/// running are finished and committed. A demonstration that cannot be read or planned is recorded
/// as failed and tried again by the next run. Results of demonstrations that the dataset no longer
/// contains are reported and left out of plans.h5, but stay in the journal. Throws InputError if no
/// demonstration can be read, if the dataset changes during the run, if results cannot be written,
/// or if the journal belongs to another dataset, that is, one that was named differently and shares
/// no unchanged demonstration. Finished results are in the journal in all these cases.
RunResult run_dataset(Journal& journal, RunRequest request, Progress& progress);

}  // namespace morphe::run
