#include "pipeline/run/journal_tables.hpp"

namespace morphe::run {
namespace {

constexpr const char* kFormat = "morphe-journal 2";
constexpr const char* kTables = R"(
CREATE TABLE metadata(key TEXT PRIMARY KEY, value BLOB);
CREATE TABLE configs(sha256 TEXT PRIMARY KEY, text TEXT);
CREATE TABLE scheduled(position INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE results(name TEXT PRIMARY KEY, input TEXT, config TEXT, robot TEXT, scene TEXT,
                     program TEXT, dataset TEXT, error TEXT, summary TEXT);
CREATE TABLE plans(demonstration TEXT, number INTEGER, sha256 TEXT, rows TEXT, bytes BLOB,
                   PRIMARY KEY(demonstration, number));
)";
constexpr const char* kDrop = R"(
DROP TABLE IF EXISTS metadata; DROP TABLE IF EXISTS configs; DROP TABLE IF EXISTS scheduled;
DROP TABLE IF EXISTS results; DROP TABLE IF EXISTS plans;
DROP TABLE IF EXISTS about; DROP TABLE IF EXISTS wanted; DROP TABLE IF EXISTS done;
)";  // the last three: of version 1

}  // namespace

void make_journal_tables(Database& database) {
  database.run(kDrop);
  database.run(kTables);
  set_metadata(database, "format", kFormat);
}

std::string metadata(const Database& database, const std::string& key) {
  Statement select(database, "SELECT value FROM metadata WHERE key = ?");
  return select.bind(1, key).step() ? select.text(0) : "";
}

void set_metadata(const Database& database, const std::string& key, const std::string& value) {
  Statement insert(database, "INSERT OR REPLACE INTO metadata VALUES(?, ?)");
  insert.bind(1, key).bind_bytes(2, value).run();
}

bool is_empty(const Database& database) {
  Statement count(database, "SELECT count(*) FROM sqlite_master");
  count.step();
  return count.number(0) == 0;
}

void check_journal(const Database& database) {
  Statement table(database, "SELECT count(*) FROM sqlite_master WHERE name = 'metadata'");
  table.step();
  if (table.number(0) == 0 || metadata(database, "format") != kFormat)
    database.fail("is not a journal of a run that this version can read");
}

}  // namespace morphe::run
