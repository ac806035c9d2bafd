#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/files/disk.hpp"
#include "pipeline/run/batch.hpp"
#include "pipeline/run/journal.hpp"
#include "pipeline/run/progress.hpp"

namespace morphe::run {

/// What to run, and what becomes of it.
struct RunRequest {
  std::filesystem::path dataset;  ///< demonstrations.h5
  std::filesystem::path plans;    ///< plans.h5, replaced when the new one is complete
  RunIdentity identity;  ///< run_dataset() fills in the dataset's hash and its demonstrations
  std::string config;    ///< effective config, but for the paths of files
  std::string expected_dataset;  ///< SHA-256 that the dataset must have, "" = any
  std::string dataset_key;       ///< how the dataset was named; for the journal alone
  int jobs = 1;
  files::Disk* disk = &files::real_disk();  ///< for plans.h5
  bool explain = false;
  std::function<DemonstrationOutcome(const Demonstration&)> plan;
  std::function<std::string(const Plan&)> rows;  ///< of the table for people
  std::function<void()> publish;                 ///< called when plans.h5 is in its place
};

struct RunResult {
  int signal = 0;  ///< that stopped it before the end; 0: it is complete
  BatchSummary summary;
};

/// Plans what the journal does not hold yet of the dataset (of its shard), and writes plans.h5 from
/// the journal meanwhile, in the order of the dataset; it takes its name when all is done. A
/// signal (StopSignal): what is in hand is finished and committed. A demonstration that cannot be
/// read or planned is a failed one, and tried again the next time. What was finished of
/// demonstrations that the dataset no longer has is told, leaves plans.h5 and stays in the journal.
/// InputError: none at all can be read; the dataset changes under the run; results cannot be
/// written; or the journal is another dataset's: one that was named otherwise, and no demonstration
/// is the same. What was finished is in the journal.
RunResult run_dataset(Journal& journal, RunRequest request, Progress& progress);

}  // namespace morphe::run
