#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/motion/input_error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace morphe::run {

/// An error thrown for a file that is not a database or cannot be read as one.
struct DamagedDatabase : InputError {
  using InputError::InputError;
};

/// The access to a database.
enum class DatabaseUse { read, write };

/// A SQLite file that this process holds exclusively until it is closed; the lock is released as
/// well if the process is killed. Throws InputError "FILE: message" if another process holds the
/// file, if it is not a database, if it is damaged, or if the disk is full.
class Database {
 public:
  /// Opens the file for reading or writing.
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
  /// Throws InputError with SQLite's own message.
  [[noreturn]] void fail() const;
  /// Throws InputError with the given message.
  [[noreturn]] void fail(const std::string& message) const;
  /// Returns the SQLite connection.
  sqlite3* handle() const { return handle_; }

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. Parameters of bind() are counted from 1, columns from 0.
class Statement {
 public:
  /// Prepares the statement.
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Binds a text or an integer to a parameter.
  Statement& bind(int place, std::string_view text);
  Statement& bind(int place, std::int64_t number);
  /// Binds bytes that must remain valid until the statement has run.
  Statement& bind_bytes(int place, std::string_view bytes);
  /// Steps to the next row. Returns true if a row is available.
  bool step();
  /// Steps to the end and resets the statement, so that it can be bound again.
  void run();
  /// Resets the statement and clears its bindings.
  void reset();
  /// Returns a text or bytes.
  std::string text(int column) const;
  /// Returns an integer.
  std::int64_t number(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace morphe::run
