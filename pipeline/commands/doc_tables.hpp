#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace morphe::commands {

/// The descriptions of keys, by (options struct, key).
using DocTables = std::map<std::pair<std::string, std::string>, std::string>;

/// Adds the tables of keys of a page: rows "| `key` | default | meaning |" below a line "<!-- keys:
/// FILE… STRUCT -->". Links and markup of Markdown are removed from the meaning.
void add_doc_tables(std::string_view page, DocTables& tables);

/// Returns the tables of docs/formats.md and docs/steps as embedded at build time.
DocTables doc_tables();

}  // namespace morphe::commands
