#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/motion/input_error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace morphe::run {

/// The error for a file that is damaged or not a database.
struct DamagedDatabase : InputError {
  using InputError::InputError;
};

/// The access to a database; `write` creates a missing file.
enum class DatabaseUse { read, write };

/// A SQLite file that this process alone holds until it is closed or the process is killed. All
/// functions, also those of Statement, throw InputError if another process holds the file, if it is
/// damaged (DamagedDatabase), or if it cannot be read or written.
class Database {
 public:
  Database(const std::filesystem::path& file, DatabaseUse use);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Runs one or several statements without results.
  void run(const std::string& sql);
  /// Returns true if a transaction is open.
  bool in_transaction() const;
  /// Writes all committed data into the file itself, so that no log remains beside it.
  void checkpoint();
  /// Throws the error of the last call of SQLite.
  [[noreturn]] void fail() const;
  /// Throws InputError "FILE: message".
  [[noreturn]] void fail(const std::string& message) const;
  sqlite3* handle() const { return handle_; }

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. Parameters are counted from 1, columns from 0.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Binds a text, which is copied, or an integer to a parameter.
  Statement& bind(int index, std::string_view text);
  Statement& bind(int index, std::int64_t number);
  /// Binds bytes that must remain valid until the statement has run.
  Statement& bind_bytes(int index, std::string_view bytes);
  /// Steps to the next row. Returns true if a row is available.
  bool step();
  /// Steps to the end and resets the statement, so that it can be bound again.
  void run();
  /// Resets the statement and clears its bindings.
  void reset();
  /// Returns a text or bytes of the current row.
  std::string text(int column) const;
  /// Returns an integer of the current row.
  std::int64_t number(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace morphe::run
