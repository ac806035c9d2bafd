#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "pipeline/run/batch.hpp"
#include "pipeline/run/shard.hpp"

namespace morphe::run {

/// The SHA-256 hashes of all inputs on which the plans of a demonstration depend.
struct Fingerprint {
  std::string input;   ///< the demonstration as the dataset contains it
  std::string config;  ///< the effective config without file names
  std::string robot, scene;
  std::string program;  ///< the executable, because another build may produce other bytes
};

/// A finished demonstration, as the journal stores it.
struct FinishedDemonstration {
  /// A plan of the demonstration.
  struct StoredPlan {
    std::string table_rows;  ///< its rows in the printed table
    std::string bytes;       ///< bytes_of(plan)
  };
  std::string name;
  Fingerprint fingerprint;
  std::string dataset;  ///< SHA-256 of the file in which fingerprint.input was last found
  std::string error;    ///< "" unless the demonstration failed
  BatchSummary summary;
  std::vector<StoredPlan> plans;  ///< in the order of the movements
};

/// The properties of a run as a whole that its journal records.
struct RunIdentity {
  std::string software;             ///< name and version of the program: "morphe 0.1.0"
  std::string program, scene;       ///< SHA-256 of the executable and of the scene
  Shard shard;                      ///< the part of the dataset that the run plans
  std::int64_t demonstrations = 0;  ///< of the whole dataset
  PlanFileHeader header;            ///< of the run's plans.h5
  RobotModel robot;
  std::string dataset_label;  ///< the dataset as the user named it
};

/// The name of a demonstration and its position in the dataset, from 0.
struct DatasetEntry {
  std::int64_t position = 0;
  std::string name;
};

/// The file DIR/journal.sqlite, which stores every finished demonstration. Those that the last run
/// was to plan are called scheduled. Committed results survive even if the process is killed. One
/// process at a time holds a journal; its threads may all call it. Throws InputError if another run
/// holds it, another version or shard wrote it, it is damaged, or the disk is full.
class Journal {
 public:
  static constexpr const char* kFile = "journal.sqlite";

  /// Opens the journal for a run and creates it if it is missing. `fresh` empties it.
  static std::unique_ptr<Journal> write(const std::filesystem::path& folder,
                                        const std::string& software, const Shard& shard,
                                        bool fresh);
  /// Opens the journal for merging.
  static std::unique_ptr<Journal> read(const std::filesystem::path& folder);
  ~Journal();

  /// Begins a run. `config` is the effective config without file names, stored to report changes in
  /// later runs. `each_scheduled` calls its argument for each demonstration to be planned.
  void begin(
      const RunIdentity& identity, const std::string& config,
      const std::function<void(const std::function<void(const DatasetEntry&)>&)>& each_scheduled);
  /// Returns a finished demonstration without its plans; nullopt if it is not in the journal.
  std::optional<FinishedDemonstration> find(const std::string& name) const;
  /// Returns the stored config with this hash, "" if it is unknown.
  std::string config(const std::string& sha256) const;
  /// Adds a demonstration or replaces its entry. Entries are committed in batches.
  void add(const FinishedDemonstration& finished);
  /// Records the SHA-256 of the file in which the demonstration was last found.
  void set_dataset_hash(const std::string& name, const std::string& dataset);
  /// Commits all results that were added.
  void commit();
  /// Visits the names of the scheduled demonstrations with a result without an error, in order.
  void each_result(const std::function<void(const std::string&)>& visit) const;
  /// Records that the run has written its plans.h5; removes configs without results.
  void mark_complete();

  /// Returns true if the last run has written its plans.h5.
  bool is_complete() const;
  /// Returns true for the plans_fingerprint() of the last run, or of the complete run before it.
  bool owns_plans(const std::string& hash) const;
  /// Returns the identity of the last run.
  RunIdentity identity() const;
  /// Returns the number of scheduled demonstrations. Throws InputError if some are missing.
  std::int64_t scheduled_count() const;
  /// Returns the number of these without a result of the run's config and program.
  std::int64_t unfinished_count() const;
  /// Returns true if a demonstration has a result without an error.
  bool has_results() const;
  /// Returns the next scheduled demonstration, after begin() the first; nullopt after the last.
  std::optional<DatasetEntry> next();
  /// Visits the plans of a demonstration in order. Throws InputError if one is damaged or missing.
  void each_plan(const std::string& name,
                 const std::function<void(const FinishedDemonstration::StoredPlan&)>& visit) const;
  /// Throws InputError "FILE: is damaged: WHAT; plan again with --fresh".
  [[noreturn]] void fail_damaged(const std::string& what) const;
  /// Returns the sum of the summaries of the scheduled demonstrations.
  BatchSummary summary() const;
  /// Visits the table rows of all scheduled demonstrations, in order.
  void each_row(const std::function<void(const std::string&)>& visit) const;

 private:
  std::string current_plans_fingerprint() const;

  struct State;
  explicit Journal(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace morphe::run
