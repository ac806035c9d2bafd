#include "pipeline/run/run_dataset.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/ordered_map.hpp"
#include "core/store/bytes.hpp"
#include "core/store/consistency.hpp"
#include "core/store/demonstration_file.hpp"
#include "pipeline/run/config_changes.hpp"
#include "pipeline/run/stop_signal.hpp"
#include "pipeline/run/write_plans.hpp"

namespace morphe::run {
namespace {

/// A demonstration to be planned, or why it could not be read; or one that was finished before.
struct Task {
  Demonstration demonstration;
  std::string input;  ///< SHA-256
  std::string error;
  std::string why;  ///< it is planned
  std::optional<Finished> before;
};

/// Nothing, if the run was stopped before this one began.
struct Done {
  Finished finished;  ///< in the journal; here without its plans
  std::string why;    ///< it was planned, "" if it was finished before
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
          fmt::format("{}: is not the dataset of these plans: its SHA-256 is {}, not {}",
                      request_.dataset.string(), dataset, request_.expected_dataset));
    print_.config = files::sha256(request_.config);
    print_.robot = files::sha256(store::bytes_of(identity.robot));
    print_.scene = identity.scene;
    print_.program = identity.program;
  }

  RunResult run() {
    begin();
    writer_.emplace(request_.plans, request_.identity.header, request_.identity.robot,
                    *request_.disk);
    parallel::OrderedMap<Task, Done> map;
    map.next = [&] { return next(); };
    map.work = [&](const Task& task) { return work(task); };
    map.write = [&](const Done& done) { write(done); };
    try {
      morphe::parallel::run(map, request_.jobs);
    } catch (...) {
      writer_.reset();  // first, as it makes room
      keep_what_is_done();
      throw;
    }
    journal_.commit();
    const int stopped_by = stop_.seen();
    if (stopped_by == 0) finish();
    return {stopped_by, progress_.so_far()};
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
    const std::vector<std::uint32_t> shard_of = share_out(frames, shard.count);
    look_at_results_before();
    request_.identity.dataset_key = request_.dataset_key;
    journal_.begin(request_.identity, request_.config, [&](const auto& want) {
      std::int64_t position = 0;
      reader_.each_name([&](const std::string& name) {
        const auto index = static_cast<std::size_t>(position);
        if (shard.count == 1 || static_cast<int>(shard_of[index]) == shard.index)
          want(DatasetEntry{position, name});
        ++position;
      });
    });
    progress_.begin(journal_.wanted(), request_.jobs);
  }

  /// Whether those of another dataset would be replaced, and which demonstrations went.
  void look_at_results_before() {
    std::vector<std::string> before, gone;
    journal_.each_result([&](const std::string& name) { before.push_back(name); });
    if (before.empty()) return;
    std::set<std::string> here;
    reader_.each_name([&](const std::string& name) { here.insert(name); });
    bool same = journal_.identity().dataset_key == request_.dataset_key;
    for (const std::string& name : before) {
      if (!here.contains(name)) {
        gone.push_back(name);
      } else {
        same = same || is_unchanged(name);
      }
    }
    const std::string folder = request_.plans.parent_path().string();
    if (!same)
      throw InputError(fmt::format(
          "{}: holds plans of another dataset ({}), which would be replaced: give another --out, "
          "or --fresh to replace them",
          folder, some_of(before)));
    if (gone.empty()) return;
    progress_.line(fmt::format(
        "{}: {} demonstration{} no longer in the dataset ({}): the plans leave plans.h5 and are "
        "kept for when they come back",
        folder, gone.size(), gone.size() == 1 ? " is" : "s are", some_of(gone)));
  }

  bool is_unchanged(const std::string& name) {
    const std::optional<Finished> found = journal_.find(name);
    if (found->dataset == dataset()) return true;
    try {
      return files::sha256(store::bytes_of(reader_.read(name))) == found->print.input;
    } catch (const InputError&) {
      return false;
    }
  }

  static std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 3;
    const std::vector<std::string> first(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(kMost, names.size())));
    return fmt::format(
        "{}{}", fmt::join(first, ", "),
        names.size() > kMost ? fmt::format(" and {} more", names.size() - kMost) : "");
  }

  /// One that is damaged has none, in every shard alike.
  std::size_t frames_of(const std::string& name) const {
    try {
      return reader_.frames(name);
    } catch (const InputError&) {
      return 0;
    }
  }

  std::unique_ptr<Task> next() {
    const std::optional<DatasetEntry> place = stop_.seen() == 0 ? journal_.next() : std::nullopt;
    if (!place) return nullptr;
    const std::optional<Finished> found = journal_.find(place->name);
    std::vector<std::string> why = reasons_of_run(found);
    std::unique_ptr<Task> task;
    if (!found || !why.empty() || found->dataset != dataset()) task = read(place->name);
    if (found && task && found->print.input != task->input) why.push_back("its recording changed");
    if (found && why.empty()) {
      if (task) journal_.seen_in(place->name, dataset());
      ++readable_;
      task = std::make_unique<Task>();
      task->before = found;
      return task;
    }
    if (!found) why.push_back("not done before");
    task->why = fmt::format("{}", fmt::join(why, "; "));
    return task;
  }

  /// Why a finished demonstration is done again, but for its recording.
  std::vector<std::string> reasons_of_run(const std::optional<Finished>& found) {
    std::vector<std::string> why;
    if (!found) return why;
    if (!found->error.empty()) why.push_back("it failed: " + found->error);
    if (found->print.config != print_.config)
      why.push_back("the config changed: " + changes_since(found->print.config));
    if (found->print.robot != print_.robot) why.push_back("the robot changed");
    if (found->print.scene != print_.scene) why.push_back("the scene changed");
    if (found->print.program != print_.program) why.push_back("morphe was built anew");
    return why;
  }

  const std::string& changes_since(const std::string& config) {
    if (config != explained_) {
      explained_ = config;
      changes_ = fmt::format(
          "{}", fmt::join(config_changes(journal_.config(config), request_.config), ", "));
    }
    return changes_;
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

  std::unique_ptr<Done> work(const Task& task) {
    auto done = std::make_unique<Done>();
    if (stop_.seen() != 0) return done;
    done->why = task.why;
    if (task.before) {
      done->finished = *task.before;
      return done;
    }
    progress_.takes_in_hand(task.demonstration.name);
    done->finished = plan(task);
    progress_.has_finished(task.demonstration.name);
    keep(done->finished);
    return done;
  }

  /// At once, not when its turn comes to be written: one before it may take long, and be stopped.
  void keep(Finished& finished) {
    journal_.add(finished);
    finished.plans.clear();
    if (stop_.seen() != 0) journal_.commit();
  }

  /// What could be written, or why not.
  Finished plan(const Task& task) {
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
    Finished finished;
    finished.name = task.demonstration.name;
    finished.print = print_;
    finished.print.input = task.input;
    finished.dataset = dataset();
    finished.error = outcome.error;
    finished.summary = summary_of(outcome);
    for (const Plan& plan : outcome.plans)
      finished.plans.push_back({request_.rows(plan), store::bytes_of(plan)});
    return finished;
  }

  void write(const Done& done) {
    const Finished& finished = done.finished;
    if (finished.name.empty()) return;
    if (done.why.empty()) {
      progress_.reused(finished.summary);
    } else {
      if (request_.explain) progress_.line(fmt::format("{}: {}", finished.name, done.why));
      progress_.done(finished.name, finished.summary, finished.error);
    }
    write_plans(journal_, finished.name, *writer_);
  }

  void finish() {
    if (readable_ == 0 && !first_unreadable_.empty()) throw InputError(first_unreadable_);
    writer_->finish();
    request_.publish();
    journal_.complete();
  }

  void keep_what_is_done() {
    try {
      journal_.commit();
    } catch (const InputError&) {  // the disk is full: the batch is lost, what came before is not
    }
  }

  /// A signal came: it is said at once, and what is finished is safe from the next one.
  void stop() {
    progress_.stopping();
    keep_what_is_done();
  }

  const std::string& dataset() const { return request_.identity.header.dataset_sha256; }

  Journal& journal_;
  RunRequest request_;
  Progress& progress_;
  store::DemonstrationReader reader_;
  std::optional<store::PlanWriter> writer_;
  Fingerprint print_;  ///< of this run; the input is each demonstration's own
  std::int64_t readable_ = 0;
  std::string first_unreadable_, explained_, changes_;
  StopSignal stop_{[this] { stop(); }};  // the last: it calls what stands above
};

}  // namespace

RunResult run_dataset(Journal& journal, RunRequest request, Progress& progress) {
  return Run(journal, std::move(request), progress).run();
}

}  // namespace morphe::run
