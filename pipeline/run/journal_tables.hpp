#pragma once

#include <string>

#include "pipeline/run/database.hpp"

namespace morphe::run {

/// The tables of a journal: `about` (key, value), `configs` by hash, `wanted` (the run's places in
/// the dataset), `done` (a row a finished demonstration) and `plans` (a row each). Makes them anew.
void make_journal_tables(Database& database);
bool is_empty(const Database& database);
/// InputError unless these are the tables that this version makes.
void check_journal(const Database& database);

/// A row of `about`, "" if it is not there.
std::string about(const Database& database, const std::string& key);
void set_about(const Database& database, const std::string& key, const std::string& value);

}  // namespace morphe::run
