#include "pipeline/run/journal.hpp"

#include <fmt/format.h>

#include <chrono>
#include <mutex>
#include <system_error>

#include "pipeline/files/sha256.hpp"
#include "pipeline/motion/input_error.hpp"
#include "pipeline/run/journal_tables.hpp"
#include "pipeline/run/summary_text.hpp"
#include "pipeline/store/bytes.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// A batch ends with whichever of these comes first. When it ends changes no result, only how much
// is lost if the process is killed.
constexpr int kMostInBatch = 64;
constexpr std::size_t kMostBatchBytes = std::size_t{32} << 20;
constexpr std::chrono::seconds kLongestBatch{1};

}  // namespace

// Statements close before the database does.
struct Journal::State {
  State(const fs::path& file, DatabaseUse use) : database(file, use) {}

  Database database;
  mutable std::mutex mutex;
  std::int64_t position = -1;
  int batch = 0;
  std::size_t batch_bytes = 0;
  Clock::time_point batch_begin;

  void open_batch() {
    if (database.in_transaction()) return;
    database.run("BEGIN");
    batch = 0;
    batch_bytes = 0;
    batch_begin = Clock::now();
  }
  void close_batch() {
    if (database.in_transaction()) database.run("COMMIT");
  }
  void close_batch_if_full() {
    if (batch >= kMostInBatch || batch_bytes >= kMostBatchBytes ||
        Clock::now() - batch_begin >= kLongestBatch)
      close_batch();
  }
  std::int64_t count(const std::string& sql) const {
    Statement select(database, sql);
    select.step();
    return select.number(0);
  }
};

Journal::Journal(std::unique_ptr<State> state) : state_(std::move(state)) {}
Journal::~Journal() = default;

std::unique_ptr<Journal> Journal::write(const fs::path& folder, const std::string& software,
                                        const Shard& shard, bool fresh) {
  const fs::path file = folder / kFile;
  std::unique_ptr<State> state;
  try {
    state = std::make_unique<State>(file, DatabaseUse::write);
    if (!is_empty(state->database) && !fresh) check_journal(state->database);
  } catch (const DamagedDatabase& error) {
    // Nobody can hold what is no database.
    if (!fresh) throw InputError(fmt::format("{}; --fresh begins anew", error.what()));
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(file.string() + "-wal", ignored);
    state = std::make_unique<State>(file, DatabaseUse::write);
  }
  Database& database = state->database;
  if (fresh || is_empty(database)) {
    database.run("BEGIN");
    make_journal_tables(database);
    set_about(database, "software", software);
    set_about(database, "shard", shard_text(shard));
    database.run("COMMIT");
  }
  if (const std::string by = about(database, "software"); by != software)
    database.fail(fmt::format("was written by {}, this is {}; --fresh begins anew", by, software));
  if (const std::string of = about(database, "shard"); of != shard_text(shard))
    database.fail(
        fmt::format("holds shard {}, not {}; --fresh begins anew", of, shard_text(shard)));
  return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

std::unique_ptr<Journal> Journal::read(const fs::path& folder) {
  const fs::path file = folder / kFile;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError(fmt::format("{}: is missing: not the folder of a run", file.string()));
  auto state = std::make_unique<State>(file, DatabaseUse::read);
  check_journal(state->database);
  return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

void Journal::begin(
    const RunIdentity& identity, const std::string& config,
    const std::function<void(const std::function<void(const DatasetEntry&)>&)>& each_wanted) {
  const std::lock_guard lock(state_->mutex);
  Database& database = state_->database;
  state_->open_batch();
  set_about(database, "complete", "0");
  set_about(database, "program", identity.program);
  set_about(database, "scene", identity.scene);
  set_about(database, "config", files::sha256(config));
  set_about(database, "demonstrations", std::to_string(identity.demonstrations));
  set_about(database, "header", store::bytes_of(identity.header));
  set_about(database, "robot", store::bytes_of(identity.robot));
  set_about(database, "dataset_key", identity.dataset_key);
  Statement keep(database, "INSERT OR IGNORE INTO configs VALUES(?, ?)");
  keep.bind(1, files::sha256(config)).bind(2, config).run();
  database.run("DELETE FROM wanted");
  Statement insert(database, "INSERT INTO wanted VALUES(?, ?)");
  each_wanted(
      [&](const DatasetEntry& place) { insert.bind(1, place.position).bind(2, place.name).run(); });
  state_->close_batch();
  state_->position = -1;
}

std::optional<Finished> Journal::find(const std::string& name) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT input, config, robot, scene, program, dataset, error, summary FROM done "
                   "WHERE name = ?");
  if (!select.bind(1, name).step()) return std::nullopt;
  Finished found;
  found.name = name;
  found.print = {select.text(0), select.text(1), select.text(2), select.text(3), select.text(4)};
  found.dataset = select.text(5);
  found.error = select.text(6);
  found.summary = summary_from_text(select.text(7));
  return found;
}

std::string Journal::config(const std::string& hash) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database, "SELECT text FROM configs WHERE sha256 = ?");
  return select.bind(1, hash).step() ? select.text(0) : "";
}

void Journal::add(const Finished& finished) {
  const std::lock_guard lock(state_->mutex);
  const Database& database = state_->database;
  state_->open_batch();
  Statement forget(database, "DELETE FROM plans WHERE demonstration = ?");
  forget.bind(1, finished.name).run();
  Statement insert(database, "INSERT INTO plans VALUES(?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const Finished::StoredPlan& plan : finished.plans) {
    insert.bind(1, finished.name).bind(2, number++).bind(3, files::sha256(plan.bytes));
    insert.bind(4, plan.rows).bind_bytes(5, plan.bytes).run();
    state_->batch_bytes += plan.bytes.size();
  }
  Statement done(database, "INSERT OR REPLACE INTO done VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
  const Fingerprint& print = finished.print;
  done.bind(1, finished.name).bind(2, print.input).bind(3, print.config).bind(4, print.robot);
  done.bind(5, print.scene).bind(6, print.program).bind(7, finished.dataset);
  done.bind(8, finished.error).bind(9, summary_text(finished.summary)).run();
  ++state_->batch;
  state_->close_batch_if_full();
}

void Journal::seen_in(const std::string& name, const std::string& dataset) {
  const std::lock_guard lock(state_->mutex);
  state_->open_batch();
  Statement update(state_->database, "UPDATE done SET dataset = ? WHERE name = ?");
  update.bind(1, dataset).bind(2, name).run();
  ++state_->batch;
  state_->close_batch_if_full();
}

void Journal::commit() {
  const std::lock_guard lock(state_->mutex);
  state_->close_batch();
}

void Journal::each_result(const std::function<void(const std::string&)>& visit) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT w.name FROM wanted w CROSS JOIN done d ON d.name = w.name "
                   "WHERE d.error = '' ORDER BY w.position");
  while (select.step()) visit(select.text(0));
}

void Journal::complete() {
  const std::lock_guard lock(state_->mutex);
  state_->open_batch();
  state_->database.run(
      "DELETE FROM configs WHERE sha256 NOT IN (SELECT config FROM done)"
      "  AND sha256 <> (SELECT CAST(value AS TEXT) FROM about WHERE key = 'config');");
  set_about(state_->database, "complete", "1");
  state_->close_batch();
  state_->database.settle();
}

bool Journal::is_complete() const {
  const std::lock_guard lock(state_->mutex);
  return about(state_->database, "complete") == "1";
}

RunIdentity Journal::identity() const {
  const std::lock_guard lock(state_->mutex);
  const Database& database = state_->database;
  RunIdentity identity;
  identity.software = about(database, "software");
  identity.dataset_key = about(database, "dataset_key");
  identity.program = about(database, "program");
  identity.scene = about(database, "scene");
  identity.shard = parse_shard(about(database, "shard"));
  const std::string header = about(database, "header");
  if (header.empty()) return identity;  // killed before it began
  identity.demonstrations = std::stoll(about(database, "demonstrations"));
  identity.header = store::header_from_bytes(header);
  identity.robot = store::robot_from_bytes(about(database, "robot"));
  return identity;
}

std::int64_t Journal::wanted() const {
  const std::lock_guard lock(state_->mutex);
  return state_->count("SELECT count(*) FROM wanted");
}

std::int64_t Journal::unfinished() const {
  const std::lock_guard lock(state_->mutex);
  return state_->count(
      "SELECT count(*) FROM wanted WHERE name NOT IN (SELECT name FROM done WHERE"
      " config = (SELECT CAST(value AS TEXT) FROM about WHERE key = 'config') AND"
      " program = (SELECT CAST(value AS TEXT) FROM about WHERE key = 'program'))");
}

bool Journal::has_results() const {
  const std::lock_guard lock(state_->mutex);
  return state_->count("SELECT EXISTS(SELECT 1 FROM done WHERE error = '')") != 0;
}

std::optional<DatasetEntry> Journal::next() {
  // A query of its own each time: an open one would keep SQLite from emptying its log.
  const std::lock_guard lock(state_->mutex);
  Statement select(
      state_->database,
      "SELECT position, name FROM wanted WHERE position > ? ORDER BY position LIMIT 1");
  if (!select.bind(1, state_->position).step()) return std::nullopt;
  state_->position = select.number(0);
  return DatasetEntry{state_->position, select.text(1)};
}

void Journal::each_plan(const std::string& name,
                        const std::function<void(const Finished::StoredPlan&)>& visit) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT rows, bytes, sha256 FROM plans WHERE demonstration = ? ORDER BY number");
  select.bind(1, name);
  while (select.step()) {
    const Finished::StoredPlan plan{select.text(0), select.text(1)};
    if (files::sha256(plan.bytes) != select.text(2))
      state_->database.fail(fmt::format("{}: a plan is damaged; --fresh begins anew", name));
    visit(plan);
  }
}

BatchSummary Journal::summary() const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT d.summary FROM wanted w CROSS JOIN done d ON d.name = w.name "
                   "ORDER BY w.position");
  BatchSummary sum;
  while (select.step()) run::add(summary_from_text(select.text(0)), sum);
  return sum;
}

void Journal::each_row(const std::function<void(const std::string&)>& visit) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT p.rows FROM wanted w CROSS JOIN plans p ON p.demonstration = w.name "
                   "ORDER BY w.position, p.number");
  while (select.step()) visit(select.text(0));
}

}  // namespace morphe::run
