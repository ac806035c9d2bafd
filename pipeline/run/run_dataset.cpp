#include "pipeline/run/run_dataset.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/store/bytes.hpp"
#include "core/store/consistency.hpp"
#include "core/store/demonstration_file.hpp"
#include "pipeline/run/config_changes.hpp"
#include "pipeline/run/stop_signal.hpp"
#include "pipeline/run/write_plans.hpp"

namespace morphe::run {
namespace {

/// A demonstration to be planned, or its earlier result.
struct Task {
  Demonstration demonstration;
  std::string input;        ///< SHA-256 of the demonstration
  std::string error;        ///< why it could not be read
  std::string plan_reason;  ///< why it is planned
  std::optional<FinishedDemonstration> previous_result;
};

/// The result of a task; its name is empty if the run was stopped before the task began.
struct TaskResult {
  FinishedDemonstration finished;  ///< without its plans
  std::string plan_reason;         ///< why it was planned, "" if it was reused
};

class Run {
 public:
  Run(Journal& journal, RunRequest request, Progress& progress)
      : journal_(journal),
        request_(std::move(request)),
        progress_(progress),
        reader_(request_.dataset) {
    RunIdentity& identity = request_.identity;
    std::string& dataset = identity.header.dataset_sha256;
    dataset = files::sha256_of_file(request_.dataset);
    if (!request_.expected_dataset.empty() && request_.expected_dataset != dataset)
      throw InputError(
          fmt::format("{}: is not the dataset of these plans: SHA-256 is {}, expected {}",
                      request_.dataset.string(), dataset, request_.expected_dataset));
    fingerprint_.config = files::sha256(request_.config);
    fingerprint_.robot = files::sha256(store::bytes_of(identity.robot));
    fingerprint_.scene = identity.scene;
    fingerprint_.program = identity.program;
  }

  RunResult run() {
    begin();
    writer_.emplace(request_.plans, request_.identity.header, request_.identity.robot,
                    *request_.disk);
    parallel::OrderedParallelMap<Task, TaskResult> map;
    map.next = [&] { return next(); };
    map.work = [&](const Task& task) { return work(task); };
    map.write = [&](const TaskResult& result) { write(result); };
    try {
      morphe::parallel::run(map, request_.jobs);
    } catch (...) {
      writer_.reset();  // first, because this frees disk space
      commit_finished();
      throw;
    }
    journal_.commit();
    const int stopped_by = stop_.received_signal();
    if (stopped_by == 0) finish();
    return {stopped_by, progress_.current_summary()};
  }

 private:
  void begin() {
    std::vector<std::size_t> frames;
    const Shard& shard = request_.identity.shard;
    std::int64_t& count = request_.identity.demonstrations;
    reader_.each_name([&](const std::string& name) {
      ++count;
      if (shard.count > 1) frames.push_back(frames_of(name));
    });
    const std::vector<int> shard_of = assign_shards(frames, shard.count);
    check_previous_results();
    request_.identity.dataset_label = request_.dataset_key;
    journal_.begin(request_.identity, request_.config, [&](const auto& schedule) {
      std::int64_t position = 0;
      reader_.each_name([&](const std::string& name) {
        if (shard.count == 1 || shard_of[position] == shard.index)
          schedule(DatasetEntry{position, name});
        ++position;
      });
    });
    progress_.begin(journal_.scheduled_count(), request_.jobs);
  }

  /// Throws if plans of another dataset would be replaced. Reports missing demonstrations.
  void check_previous_results() {
    std::vector<std::string> before, gone;
    journal_.each_result([&](const std::string& name) { before.push_back(name); });
    if (before.empty()) return;
    std::set<std::string> present;
    reader_.each_name([&](const std::string& name) { present.insert(name); });
    bool same_dataset = journal_.identity().dataset_label == request_.dataset_key;
    for (const std::string& name : before) {
      if (!present.contains(name)) {
        gone.push_back(name);
      } else {
        same_dataset = same_dataset || is_unchanged(name);
      }
    }
    const std::string folder = request_.plans.parent_path().string();
    if (!same_dataset)
      throw InputError(
          fmt::format("{}: contains plans of another dataset ({}) that would be replaced: give "
                      "another --out, or --fresh to replace them",
                      folder, sample_names(before)));
    if (gone.empty()) return;
    progress_.line(
        fmt::format("{}: {} demonstration{} no longer in the dataset ({}): their plans are removed "
                    "from plans.h5, but kept in the journal in case they return",
                    folder, gone.size(), gone.size() == 1 ? " is" : "s are", sample_names(gone)));
  }

  bool is_unchanged(const std::string& name) {
    const std::optional<FinishedDemonstration> found = journal_.find(name);
    if (found->dataset == dataset()) return true;
    try {
      return files::sha256(store::bytes_of(reader_.read(name))) == found->fingerprint.input;
    } catch (const InputError&) {
      return false;
    }
  }

  static std::string sample_names(const std::vector<std::string>& names) {
    constexpr std::size_t kMaxListedNames = 3;
    const std::vector<std::string> first(names.begin(),
                                         names.begin() + std::min(kMaxListedNames, names.size()));
    return fmt::format("{}{}", fmt::join(first, ", "),
                       names.size() > kMaxListedNames
                           ? fmt::format(" and {} more", names.size() - kMaxListedNames)
                           : "");
  }

  /// Returns the longest stream's samples; 0 for a damaged demonstration, so that all shards agree.
  std::size_t frames_of(const std::string& name) const {
    try {
      return reader_.longest_stream_samples(name);
    } catch (const InputError&) {
      return 0;
    }
  }

  std::unique_ptr<Task> next() {
    const std::optional<DatasetEntry> entry =
        stop_.received_signal() == 0 ? journal_.next() : std::nullopt;
    if (!entry) return nullptr;
    const std::optional<FinishedDemonstration> found = journal_.find(entry->name);
    std::vector<std::string> reasons = replan_reasons(found);
    std::unique_ptr<Task> task;
    if (!found || !reasons.empty() || found->dataset != dataset()) task = read(entry->name);
    if (found && task && found->fingerprint.input != task->input)
      reasons.push_back("the recording changed");
    if (found && reasons.empty()) {
      if (task) journal_.set_dataset_hash(entry->name, dataset());
      ++readable_;
      task = std::make_unique<Task>();
      task->previous_result = found;
      return task;
    }
    if (!found) reasons.push_back("not planned before");
    task->plan_reason = fmt::format("{}", fmt::join(reasons, "; "));
    return task;
  }

  /// Returns why a finished demonstration is planned again, except because its recording changed.
  std::vector<std::string> replan_reasons(const std::optional<FinishedDemonstration>& found) {
    std::vector<std::string> reasons;
    if (!found) return reasons;
    const Fingerprint& old = found->fingerprint;
    if (!found->error.empty()) reasons.push_back("it failed before: " + found->error);
    if (old.config != fingerprint_.config)
      reasons.push_back("the config changed: " + changes_since(old.config));
    if (old.robot != fingerprint_.robot) reasons.push_back("the robot changed");
    if (old.scene != fingerprint_.scene) reasons.push_back("the scene changed");
    if (old.program != fingerprint_.program) reasons.push_back("morphe was rebuilt");
    return reasons;
  }

  const std::string& changes_since(const std::string& config) {
    if (config != compared_config_) {
      compared_config_ = config;
      config_changes_ = fmt::format(
          "{}", fmt::join(config_changes(journal_.config(config), request_.config), ", "));
    }
    return config_changes_;
  }

  std::unique_ptr<Task> read(const std::string& name) {
    auto task = std::make_unique<Task>();
    try {
      task->demonstration = reader_.read(name);
      ++readable_;
    } catch (const InputError& error) {
      reader_.expect_unchanged();
      task->demonstration = {};
      task->demonstration.name = name;
      task->error = error.what();
      if (first_unreadable_.empty()) first_unreadable_ = error.what();
    }
    task->input = files::sha256(store::bytes_of(task->demonstration));
    return task;
  }

  std::unique_ptr<TaskResult> work(const Task& task) {
    auto result = std::make_unique<TaskResult>();
    if (stop_.received_signal() != 0) return result;
    result->plan_reason = task.plan_reason;
    if (task.previous_result) {
      result->finished = *task.previous_result;
      return result;
    }
    progress_.start_demonstration(task.demonstration.name);
    result->finished = plan(task);
    progress_.finish_demonstration(task.demonstration.name);
    store_result(result->finished);
    return result;
  }

  /// Stores a result at once, because an earlier demonstration may take long and be interrupted.
  void store_result(FinishedDemonstration& finished) {
    journal_.add(finished);
    finished.plans.clear();
    if (stop_.received_signal() != 0) journal_.commit();
  }

  /// Plans a demonstration; returns its plans as they are stored, or the error.
  FinishedDemonstration plan(const Task& task) {
    DemonstrationOutcome outcome;
    outcome.error = task.error;
    if (task.error.empty()) outcome = attempt(request_.plan, task.demonstration);
    for (const Plan& plan : outcome.plans) {
      const std::string fault = store::inconsistency(plan, request_.identity.robot);
      if (fault.empty()) continue;
      outcome = {};
      outcome.error = fault;
      break;
    }
    FinishedDemonstration finished;
    finished.name = task.demonstration.name;
    finished.fingerprint = fingerprint_;
    finished.fingerprint.input = task.input;
    finished.dataset = dataset();
    finished.error = outcome.error;
    finished.summary = summary_of(outcome);
    for (const Plan& plan : outcome.plans)
      finished.plans.push_back({request_.rows(plan), store::bytes_of(plan)});
    return finished;
  }

  void write(const TaskResult& result) {
    const FinishedDemonstration& finished = result.finished;
    if (finished.name.empty()) return;
    if (result.plan_reason.empty()) {
      progress_.add_reused(finished.summary);
    } else {
      if (request_.explain)
        progress_.line(fmt::format("{}: {}", finished.name, result.plan_reason));
      progress_.add_result(finished.name, finished.summary, finished.error);
    }
    write_plans(journal_, finished.name, *writer_);
  }

  void finish() {
    if (readable_ == 0 && !first_unreadable_.empty()) throw InputError(first_unreadable_);
    writer_->finish();
    request_.publish();
    journal_.mark_complete();
  }

  void commit_finished() {
    try {
      journal_.commit();
    } catch (const InputError&) {
      // The disk is full: the batch is lost, but earlier results are not.
    }
  }

  const std::string& dataset() const { return request_.identity.header.dataset_sha256; }

  Journal& journal_;
  RunRequest request_;
  Progress& progress_;
  store::DemonstrationReader reader_;
  std::optional<store::PlanWriter> writer_;
  Fingerprint fingerprint_;  ///< of this run, without `input`
  std::int64_t readable_ = 0;
  std::string first_unreadable_, compared_config_, config_changes_;
  // The last member, because its callback uses those above.
  StopSignal stop_{[this] {
    progress_.announce_stop();
    commit_finished();
  }};
};

}  // namespace

RunResult run_dataset(Journal& journal, RunRequest request, Progress& progress) {
  return Run(journal, std::move(request), progress).run();
}

}  // namespace morphe::run
