#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace morphe::commands {

/// (options struct, key) -> what it means, in plain words.
using DocTables = std::map<std::pair<std::string, std::string>, std::string>;

/// Adds the tables of keys of a page: rows "| `key` | default | meaning |" below a line
/// "<!-- keys: FILE… STRUCT -->". Links and marks of Markdown are taken out of the meaning.
void add_doc_tables(std::string_view page, DocTables& tables);

/// Those of docs/formats.md and docs/steps, as they were when the program was built.
DocTables doc_tables();

}  // namespace morphe::commands
