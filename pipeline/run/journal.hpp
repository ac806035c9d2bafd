#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "pipeline/run/batch.hpp"
#include "pipeline/run/shard.hpp"

namespace morphe::run {

/// What a demonstration's plans depend on, as SHA-256.
struct Fingerprint {
  std::string input;  ///< what the dataset holds of it
  std::string config, robot, scene;
  std::string program;  ///< the executable itself: another build may give other bytes
};

/// A finished demonstration, as it is kept.
struct Finished {
  struct StoredPlan {
    std::string rows;   ///< of the table for people
    std::string bytes;  ///< bytes_of(plan)
  };
  std::string name;
  Fingerprint print;
  std::string dataset;  ///< SHA-256 of the file in which `input` was last seen
  std::string error;    ///< "" unless it failed
  BatchSummary summary;
  std::vector<StoredPlan> plans;
};

/// What a journal says of its run as a whole.
struct RunIdentity {
  std::string software;  ///< "morphe 0.1.0"
  std::string program, scene;
  Shard shard;
  std::int64_t demonstrations = 0;  ///< of the whole dataset
  PlanFileHeader header;
  RobotTable robot;
  std::string dataset_key;  ///< how the dataset was named
};

/// A place in the dataset.
struct DatasetEntry {
  std::int64_t position = 0;
  std::string name;
};

/// DIR/journal.sqlite: every finished demonstration of a run. What was committed survives the
/// process, whenever it is killed; the rest is lost. One process at a time holds a journal, until
/// it ends. Safe to call from several threads. InputError: another run holds it, another version or
/// shard wrote it, it is damaged, the disk is full.
class Journal {
 public:
  static constexpr const char* kFile = "journal.sqlite";

  /// For a run, made where it is missing. `fresh` empties it, whoever wrote it.
  static std::unique_ptr<Journal> write(const std::filesystem::path& folder,
                                        const std::string& software, const Shard& shard,
                                        bool fresh);
  /// For merging.
  static std::unique_ptr<Journal> read(const std::filesystem::path& folder);
  ~Journal();

  /// A run begins: what it is, and which demonstrations belong to it. `config` is the effective
  /// config without paths, kept so that a later run can say what changed.
  void begin(
      const RunIdentity& identity, const std::string& config,
      const std::function<void(const std::function<void(const DatasetEntry&)>&)>& each_wanted);
  std::optional<Finished> find(const std::string& name) const;  ///< without its plans
  std::string config(const std::string& sha256) const;          ///< "" if it is not known
  void add(const Finished& finished);  ///< replaces what is there; committed in batches
  void seen_in(const std::string& name, const std::string& dataset);
  void commit();
  /// Demonstrations that the last run wanted and finished without fault, in its order.
  void each_result(const std::function<void(const std::string&)>& visit) const;
  /// The run's results are written.
  void complete();

  bool is_complete() const;
  /// Whether plans of that plans_print() are those that this journal's runs left in its folder.
  bool wrote(const std::string& print) const;
  RunIdentity identity() const;
  std::int64_t wanted() const;
  std::int64_t unfinished() const;
  bool has_results() const;            ///< of a demonstration that did not fail
  std::optional<DatasetEntry> next();  ///< of the wanted ones, in order, from begin() or read() on
  /// In order; InputError if they are not those that were written, or not all of them.
  void each_plan(const std::string& name,
                 const std::function<void(const Finished::StoredPlan&)>& visit) const;
  /// "FILE: is damaged: what; --fresh begins anew".
  [[noreturn]] void damaged(const std::string& what) const;
  BatchSummary summary() const;  ///< over the wanted ones
  void each_row(const std::function<void(const std::string&)>& visit) const;

 private:
  std::string plans_in_place() const;

  struct State;
  explicit Journal(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace morphe::run
