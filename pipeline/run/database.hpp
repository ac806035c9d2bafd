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

/// The file is no database, or one that cannot be read.
struct DamagedDatabase : InputError {
  using InputError::InputError;
};

enum class DatabaseUse { read, write };

/// One SQLite file, held by this process alone until it is closed, also when the process is killed.
/// InputError "FILE: message": held by another process, no database, damaged, a full disk.
class Database {
 public:
  Database(const std::filesystem::path& file, DatabaseUse use);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql);  ///< one or several statements without results
  bool in_transaction() const;
  /// Writes what is committed into the file itself, without a log beside it.
  void settle();
  [[noreturn]] void fail() const;  ///< with SQLite's own words
  [[noreturn]] void fail(const std::string& message) const;
  sqlite3* handle() const { return handle_; }

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. bind() counts from 1, columns from 0.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int place, std::string_view text);
  Statement& bind(int place, std::int64_t number);
  /// Bytes that stay where they are until the statement has run.
  Statement& bind_bytes(int place, std::string_view bytes);
  bool step();  ///< true: a row is there
  void run();   ///< steps to the end and makes it ready to be bound again
  void reset();
  std::string text(int column) const;  ///< bytes too
  std::int64_t number(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace morphe::run
