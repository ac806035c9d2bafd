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
  /// The demonstration as the dataset contains it.
  std::string input;
  /// The effective config, the robot and the scene.
  std::string config, robot, scene;
  /// The executable itself, because another build may produce other bytes.
  std::string program;
};

/// A finished demonstration, as the journal stores it.
struct FinishedDemonstration {
  /// A plan, as the journal stores it.
  struct StoredPlan {
    std::string table_rows;  ///< its rows in the printed table
    std::string bytes;       ///< bytes_of(plan)
  };
  /// The name of the demonstration.
  std::string name;
  /// The inputs on which its plans depend.
  Fingerprint fingerprint;
  /// SHA-256 of the file in which `input` was last found.
  std::string dataset;
  /// The error, "" unless the demonstration failed.
  std::string error;
  /// The counts and times of this demonstration.
  BatchSummary summary;
  /// The plans, in the order of the movements.
  std::vector<StoredPlan> plans;
};

/// The properties of a run as a whole that its journal records.
struct RunIdentity {
  /// The name and version of the program: "morphe 0.1.0".
  std::string software;
  /// The hashes of the executable and of the scene.
  std::string program, scene;
  /// The part of the dataset that the run plans.
  Shard shard;
  /// Number of demonstrations of the whole dataset.
  std::int64_t demonstrations = 0;
  /// The header of the run's plans.h5.
  PlanFileHeader header;
  /// The robot for which the run plans.
  RobotModel robot;
  /// The dataset as it was named by the user.
  std::string dataset_label;
};

/// A demonstration and its position in the dataset.
struct DatasetEntry {
  /// The index in the dataset, from 0.
  std::int64_t position = 0;
  /// The name of the demonstration.
  std::string name;
};

/// The file DIR/journal.sqlite, which stores every finished demonstration of a run. Committed
/// results survive the process even if it is killed at any time; other results are lost. A journal
/// is held by one process at a time, until that process ends. It is safe to call from several
/// threads. Throws InputError if another run holds it, if another version or shard wrote it, if it
/// is damaged, or if the disk is full.
class Journal {
 public:
  /// The name of the file in the run's folder.
  static constexpr const char* kFile = "journal.sqlite";

  /// Opens the journal for a run and creates it if it is missing. `fresh` empties it, whatever
  /// wrote it.
  static std::unique_ptr<Journal> write(const std::filesystem::path& folder,
                                        const std::string& software, const Shard& shard,
                                        bool fresh);
  /// Opens the journal for merging.
  static std::unique_ptr<Journal> read(const std::filesystem::path& folder);
  ~Journal();

  /// Begins a run with the given identity and the demonstrations that belong to it. `config` is the
  /// effective config without paths; it is stored so that a later run can report the changes.
  void begin(
      const RunIdentity& identity, const std::string& config,
      const std::function<void(const std::function<void(const DatasetEntry&)>&)>& each_wanted);
  /// Returns a finished demonstration without its plans.
  std::optional<FinishedDemonstration> find(const std::string& name) const;
  /// Returns the stored config, "" if the hash is unknown.
  std::string config(const std::string& sha256) const;
  /// Adds a demonstration or replaces its entry. Entries are committed in batches.
  void add(const FinishedDemonstration& finished);
  /// Records the file in which the demonstration was last found.
  void set_dataset_hash(const std::string& name, const std::string& dataset);
  /// Commits all results that were added.
  void commit();
  /// Visits the demonstrations that the last run scheduled and finished without an error, in its
  /// order.
  void each_result(const std::function<void(const std::string&)>& visit) const;
  /// Records that the results of the run are written.
  void mark_complete();

  /// Returns true if the results of the last run are written.
  bool is_complete() const;
  /// Returns true if plans with the given plans_fingerprint() are those that the runs of this
  /// journal left in its folder.
  bool owns_plans(const std::string& print) const;
  /// Returns the identity of the last run.
  RunIdentity identity() const;
  /// Returns the number of demonstrations that the run scheduled.
  std::int64_t scheduled_count() const;
  /// Returns the number of scheduled demonstrations without a result of the run's config and
  /// program.
  std::int64_t unfinished_count() const;
  /// Returns true if there is a demonstration that did not fail.
  bool has_results() const;
  /// Returns the next scheduled demonstration, in order, from begin() or read() on.
  std::optional<DatasetEntry> next();
  /// Visits the plans of a demonstration in order. Throws InputError if a plan is damaged or if
  /// plans are missing.
  void each_plan(const std::string& name,
                 const std::function<void(const FinishedDemonstration::StoredPlan&)>& visit) const;
  /// Throws InputError "FILE: is damaged: DETAIL; --fresh begins anew".
  [[noreturn]] void fail_damaged(const std::string& what) const;
  /// Returns the sum over the scheduled demonstrations.
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
