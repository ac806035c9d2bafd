#include "pipeline/run/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

namespace morphe::run {

Database::Database(const std::filesystem::path& file, DatabaseUse use) : file_(file) {
  const int flags =
      use == DatabaseUse::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  try {
    if (sqlite3_open_v2(file.c_str(), &handle_, flags, nullptr) != SQLITE_OK) fail();
    sqlite3_extended_result_codes(handle_, 1);
    // The file is locked from the first access until it is closed, without shared memory, which
    // network folders lack. A committed log survives the process, but not always a power failure.
    run("PRAGMA locking_mode=EXCLUSIVE; PRAGMA cache_size=-1024; PRAGMA synchronous=NORMAL;");
    if (use == DatabaseUse::write) {
      run("PRAGMA page_size=16384; PRAGMA journal_mode=WAL; BEGIN EXCLUSIVE; COMMIT;");
    } else {
      run("SELECT count(*) FROM sqlite_master;");
    }
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

Database::~Database() { sqlite3_close_v2(handle_); }  // rolls back an open transaction

void Database::run(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

bool Database::in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }

void Database::checkpoint() { run("PRAGMA journal_mode=DELETE;"); }

void Database::fail() const {
  const int code = sqlite3_errcode(handle_) & 0xff;
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
    throw InputError(fmt::format("{}: another command is writing to it",
                                 file_.has_parent_path() ? file_.parent_path().string() : "."));
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
    throw DamagedDatabase(
        fmt::format("{}: is damaged or is not a journal of a run", file_.string()));
  fail(fmt::format("cannot be {}: {}", code == SQLITE_CANTOPEN ? "opened" : "read or written",
                   sqlite3_errmsg(handle_)));
}

void Database::fail(const std::string& message) const {
  throw InputError(fmt::format("{}: {}", file_.string(), message));
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &handle_, nullptr) != SQLITE_OK)
    database.fail();
}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement& Statement::bind(int index, std::string_view text) {
  if (sqlite3_bind_text64(handle_, index, text.data(), text.size(), SQLITE_TRANSIENT,
                          SQLITE_UTF8) != SQLITE_OK)
    database_.fail();
  return *this;
}

Statement& Statement::bind(int index, std::int64_t number) {
  if (sqlite3_bind_int64(handle_, index, number) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind_bytes(int index, std::string_view bytes) {
  if (sqlite3_bind_blob64(handle_, index, bytes.data(), bytes.size(), SQLITE_STATIC) != SQLITE_OK)
    database_.fail();
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (step()) continue;
  reset();
}

void Statement::reset() {
  sqlite3_reset(handle_);
  sqlite3_clear_bindings(handle_);
}

std::string Statement::text(int column) const {
  const auto* const bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  const int count = sqlite3_column_bytes(handle_, column);
  return count > 0 ? std::string(bytes, count) : std::string();
}

std::int64_t Statement::number(int column) const { return sqlite3_column_int64(handle_, column); }

}  // namespace morphe::run
