#include "pipeline/run/journal.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <exception>
#include <mutex>
#include <system_error>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "pipeline/run/journal_tables.hpp"
#include "pipeline/run/plans_fingerprint.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// A batch ends at the first of these limits. An unfinished batch is lost if the process is killed.
constexpr int kMaxBatchRecords = 64;
constexpr std::size_t kMaxBatchBytes = std::size_t{32} << 20;
constexpr std::chrono::seconds kMaxBatchDuration{1};

std::int64_t whole_number(const std::string& text) {
  std::int64_t number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0)
    throw InputError("is not a number");
  return number;
}

/// Returns the plans_fingerprint() of a stored header, "" if it is damaged.
std::string header_fingerprint(const std::string& header) {
  try {
    return plans_fingerprint(store::header_from_bytes(header));
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace

// Statements are destroyed before the database is closed.
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
    if (batch >= kMaxBatchRecords || batch_bytes >= kMaxBatchBytes ||
        Clock::now() - batch_begin >= kMaxBatchDuration)
      close_batch();
  }
  [[noreturn]] void fail_damaged(const std::string& what) const {
    database.fail(fmt::format("is damaged: {}; plan again with --fresh", what));
  }
  BatchSummary summary(const std::string& name, const std::string& text) const {
    try {
      return deserialize_summary(text);
    } catch (const InputError&) {
      fail_damaged(fmt::format("{}: its summary cannot be read", name));
    }
  }
  /// Passes the value of a key of `metadata` to `parse`, which throws if it cannot be read.
  template <class Parse>
  void read(const char* key, const Parse& parse) const {
    try {
      parse(metadata(database, key));
    } catch (const std::exception&) {
      fail_damaged(fmt::format("its {} cannot be read", key));
    }
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
    // A file that is not a database cannot be locked by another run.
    if (!fresh) throw InputError(fmt::format("{}; plan again with --fresh", error.what()));
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(file.string() + "-wal", ignored);
    state = std::make_unique<State>(file, DatabaseUse::write);
  }
  Database& database = state->database;
  if (fresh || is_empty(database)) {
    database.run("BEGIN");
    make_journal_tables(database);
    set_metadata(database, "software", software);
    set_metadata(database, "shard", shard_text(shard));
    database.run("COMMIT");
  }
  if (const std::string writer = metadata(database, "software"); writer != software)
    database.fail(
        fmt::format("was written by {}, this is {}; plan again with --fresh", writer, software));
  if (const std::string stored = metadata(database, "shard"); stored != shard_text(shard))
    database.fail(fmt::format("contains shard {}, not {}; plan again with --fresh", stored,
                              shard_text(shard)));
  return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

std::unique_ptr<Journal> Journal::read(const fs::path& folder) {
  const fs::path file = folder / kFile;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError(
        fmt::format("{}: does not exist: this is not the folder of a run", file.string()));
  auto state = std::make_unique<State>(file, DatabaseUse::read);
  check_journal(state->database);
  return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

void Journal::begin(
    const RunIdentity& identity, const std::string& config,
    const std::function<void(const std::function<void(const DatasetEntry&)>&)>& each_scheduled) {
  const std::lock_guard lock(state_->mutex);
  Database& database = state_->database;
  const std::string plans = current_plans_fingerprint();
  state_->open_batch();
  set_metadata(database, "complete", "0");
  set_metadata(database, "plans", plans);
  set_metadata(database, "program", identity.program);
  set_metadata(database, "scene", identity.scene);
  set_metadata(database, "config", files::sha256(config));
  set_metadata(database, "demonstrations", std::to_string(identity.demonstrations));
  set_metadata(database, "header", store::bytes_of(identity.header));
  set_metadata(database, "robot", store::bytes_of(identity.robot));
  set_metadata(database, "dataset_key", identity.dataset_label);
  Statement keep(database, "INSERT OR IGNORE INTO configs VALUES(?, ?)");
  keep.bind(1, files::sha256(config)).bind(2, config).run();
  database.run("DELETE FROM scheduled");
  Statement insert(database, "INSERT INTO scheduled VALUES(?, ?)");
  std::int64_t scheduled = 0;
  each_scheduled([&](const DatasetEntry& entry) {
    insert.bind(1, entry.position).bind(2, entry.name).run();
    ++scheduled;
  });
  set_metadata(database, "scheduled", std::to_string(scheduled));
  state_->close_batch();
  state_->position = -1;
}

std::optional<FinishedDemonstration> Journal::find(const std::string& name) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(
      state_->database,
      "SELECT input, config, robot, scene, program, dataset, error, summary FROM results "
      "WHERE name = ?");
  if (!select.bind(1, name).step()) return std::nullopt;
  FinishedDemonstration found;
  found.name = name;
  found.fingerprint = {select.text(0), select.text(1), select.text(2), select.text(3),
                       select.text(4)};
  found.dataset = select.text(5);
  found.error = select.text(6);
  found.summary = state_->summary(name, select.text(7));
  return found;
}

std::string Journal::config(const std::string& hash) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database, "SELECT text FROM configs WHERE sha256 = ?");
  return select.bind(1, hash).step() ? select.text(0) : "";
}

void Journal::add(const FinishedDemonstration& finished) {
  const std::lock_guard lock(state_->mutex);
  const Database& database = state_->database;
  state_->open_batch();
  Statement forget(database, "DELETE FROM plans WHERE demonstration = ?");
  forget.bind(1, finished.name).run();
  Statement insert(database, "INSERT INTO plans VALUES(?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const FinishedDemonstration::StoredPlan& plan : finished.plans) {
    insert.bind(1, finished.name).bind(2, number++).bind(3, files::sha256(plan.bytes));
    insert.bind(4, plan.table_rows).bind_bytes(5, plan.bytes).run();
    state_->batch_bytes += plan.bytes.size();
  }
  Statement result(database, "INSERT OR REPLACE INTO results VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
  const Fingerprint& print = finished.fingerprint;
  result.bind(1, finished.name).bind(2, print.input).bind(3, print.config).bind(4, print.robot);
  result.bind(5, print.scene).bind(6, print.program).bind(7, finished.dataset);
  result.bind(8, finished.error).bind(9, serialize_summary(finished.summary)).run();
  ++state_->batch;
  state_->close_batch_if_full();
}

void Journal::set_dataset_hash(const std::string& name, const std::string& dataset) {
  const std::lock_guard lock(state_->mutex);
  state_->open_batch();
  Statement update(state_->database, "UPDATE results SET dataset = ? WHERE name = ?");
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
                   "SELECT s.name FROM scheduled s CROSS JOIN results r ON r.name = s.name "
                   "WHERE r.error = '' ORDER BY s.position");
  while (select.step()) visit(select.text(0));
}

void Journal::mark_complete() {
  const std::lock_guard lock(state_->mutex);
  state_->open_batch();
  state_->database.run(
      "DELETE FROM configs WHERE sha256 NOT IN (SELECT config FROM results)"
      "  AND sha256 <> (SELECT CAST(value AS TEXT) FROM metadata WHERE key = 'config');");
  set_metadata(state_->database, "complete", "1");
  state_->close_batch();
  state_->database.checkpoint();
}

bool Journal::is_complete() const {
  const std::lock_guard lock(state_->mutex);
  return metadata(state_->database, "complete") == "1";
}

RunIdentity Journal::identity() const {
  const std::lock_guard lock(state_->mutex);
  const Database& database = state_->database;
  RunIdentity identity;
  identity.software = metadata(database, "software");
  identity.dataset_label = metadata(database, "dataset_key");
  identity.program = metadata(database, "program");
  identity.scene = metadata(database, "scene");
  state_->read("shard", [&](const std::string& text) { identity.shard = parse_shard(text); });
  const std::string header = metadata(database, "header");
  if (header.empty()) return identity;  // the run was killed before it began
  state_->read("demonstrations",
               [&](const std::string& text) { identity.demonstrations = whole_number(text); });
  state_->read("header", [&](const std::string& bytes) {
    identity.header = store::header_from_bytes(bytes);
  });
  state_->read("robot",
               [&](const std::string& bytes) { identity.robot = store::robot_from_bytes(bytes); });
  return identity;
}

/// Returns the fingerprint of the plans in the folder: those of the last run that was completed.
std::string Journal::current_plans_fingerprint() const {
  const std::string stored = metadata(state_->database, "plans");
  const std::string header = metadata(state_->database, "header");
  if (header.empty() || metadata(state_->database, "complete") != "1") return stored;
  return header_fingerprint(header);
}

bool Journal::owns_plans(const std::string& hash) const {
  const std::lock_guard lock(state_->mutex);
  const std::string header = metadata(state_->database, "header");
  if (hash.empty() || header.empty()) return false;
  return hash == header_fingerprint(header) || hash == metadata(state_->database, "plans");
}

std::int64_t Journal::scheduled_count() const {
  const std::lock_guard lock(state_->mutex);
  const std::int64_t found = state_->count("SELECT count(*) FROM scheduled");
  // Absent in journals of earlier versions.
  const std::string expected = metadata(state_->database, "scheduled");
  if (!expected.empty() && expected != std::to_string(found))
    state_->fail_damaged(fmt::format("only {} of {} demonstrations found", found, expected));
  return found;
}

std::int64_t Journal::unfinished_count() const {
  const std::lock_guard lock(state_->mutex);
  return state_->count(
      "SELECT count(*) FROM scheduled WHERE name NOT IN (SELECT name FROM results WHERE"
      " config = (SELECT CAST(value AS TEXT) FROM metadata WHERE key = 'config') AND"
      " program = (SELECT CAST(value AS TEXT) FROM metadata WHERE key = 'program'))");
}

bool Journal::has_results() const {
  const std::lock_guard lock(state_->mutex);
  return state_->count("SELECT EXISTS(SELECT 1 FROM results WHERE error = '')") != 0;
}

std::optional<DatasetEntry> Journal::next() {
  // A new query is made each time because an open one would prevent SQLite from truncating its log.
  const std::lock_guard lock(state_->mutex);
  Statement select(
      state_->database,
      "SELECT position, name FROM scheduled WHERE position > ? ORDER BY position LIMIT 1");
  if (!select.bind(1, state_->position).step()) return std::nullopt;
  state_->position = select.number(0);
  return DatasetEntry{state_->position, select.text(1)};
}

void Journal::each_plan(
    const std::string& name,
    const std::function<void(const FinishedDemonstration::StoredPlan&)>& visit) const {
  const std::lock_guard lock(state_->mutex);
  Statement result(state_->database, "SELECT summary FROM results WHERE name = ?");
  const std::int64_t expected =
      result.bind(1, name).step() ? state_->summary(name, result.text(0)).movements : 0;
  Statement select(
      state_->database,
      "SELECT rows, bytes, sha256, number FROM plans WHERE demonstration = ? ORDER BY number");
  select.bind(1, name);
  std::int64_t found = 0;
  for (; select.step(); ++found) {
    const FinishedDemonstration::StoredPlan plan{select.text(0), select.text(1)};
    if (select.number(3) != found || files::sha256(plan.bytes) != select.text(2))
      state_->fail_damaged(fmt::format("{}: a plan is damaged", name));
    visit(plan);
  }
  if (found != expected)
    state_->fail_damaged(fmt::format("{}: only {} of {} plans found", name, found, expected));
}

void Journal::fail_damaged(const std::string& what) const { state_->fail_damaged(what); }

BatchSummary Journal::summary() const {
  const std::lock_guard lock(state_->mutex);
  Statement select(
      state_->database,
      "SELECT r.summary, r.name FROM scheduled s CROSS JOIN results r ON r.name = s.name "
      "ORDER BY s.position");
  BatchSummary sum;
  while (select.step()) run::add(state_->summary(select.text(1), select.text(0)), sum);
  return sum;
}

void Journal::each_row(const std::function<void(const std::string&)>& visit) const {
  const std::lock_guard lock(state_->mutex);
  Statement select(state_->database,
                   "SELECT p.rows FROM scheduled s CROSS JOIN plans p ON p.demonstration = s.name "
                   "ORDER BY s.position, p.number");
  while (select.step()) visit(select.text(0));
}

}  // namespace morphe::run
