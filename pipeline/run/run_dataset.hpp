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
  std::filesystem::path dataset;  ///< demonstrations.h5
  std::filesystem::path plans;    ///< plans.h5, which is replaced when the new file is complete
  RunIdentity identity;           ///< without hash, size and label of the dataset
  std::string config;             ///< effective config without file names
  std::string expected_dataset;   ///< required SHA-256 of the dataset, "" for any
  std::string dataset_key;        ///< the dataset as the user named it
  int jobs = 1;                   ///< number of threads
  files::Disk* disk = &files::real_disk();  ///< to which plans.h5 is written
  bool explain = false;                     ///< print why a demonstration is planned
  std::function<DemonstrationOutcome(const Demonstration&)> plan;  ///< plans one demonstration
  std::function<std::string(const Plan&)> rows;  ///< returns a plan's rows in the printed table
  std::function<void()> publish;  ///< called after plans.h5 has been moved to its final path
};

/// The result of run_dataset().
struct RunResult {
  int signal = 0;  ///< signal that stopped the run, 0 if it is complete
  BatchSummary summary;
};

/// Plans the demonstrations of the dataset, or of its shard, without a result of equal fingerprint
/// in the journal. Meanwhile writes plans.h5 from the journal, in the order of the dataset. After a
/// signal (StopSignal) the running demonstrations are finished and committed. A demonstration that
/// cannot be read or planned is recorded as failed and tried again by the next run. Demonstrations
/// that the dataset no longer contains are reported; their results stay in the journal, but not in
/// plans.h5. Throws InputError if
///   - no demonstration can be read
///   - the dataset has another hash than `expected_dataset`, or changes during the run
///   - results cannot be written
///   - the journal belongs to another dataset, which was named differently and shares no unchanged
///     demonstration
/// Results that were finished before an error are kept.
RunResult run_dataset(Journal& journal, RunRequest request, Progress& progress);

}  // namespace morphe::run
