#pragma once

#include <string>

#include "pipeline/run/database.hpp"

namespace morphe::run {

/// Drops the tables of a journal and creates them anew: `metadata` (values by key), `configs` (by
/// hash), `scheduled` (names of the run's demonstrations by position in the dataset), `results` (a
/// row for each finished demonstration) and `plans` (a row for each plan).
void make_journal_tables(Database& database);
/// Returns true if the database has no tables.
bool is_empty(const Database& database);
/// Throws InputError unless the tables are those that this version creates.
void check_journal(const Database& database);

/// Returns the value of a row of `metadata`, "" if there is no such row.
std::string metadata(const Database& database, const std::string& key);
/// Writes a row of `metadata`.
void set_metadata(const Database& database, const std::string& key, const std::string& value);

}  // namespace morphe::run
