#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/files/csv.hpp"

namespace morphe::files {

/// Reads a table as programs and spreadsheets of any country write it. The separator is found in
/// the last rows: semicolon, tab or comma, otherwise runs of blanks, which become tabs. Decimal
/// commas are found there too. Quotes around cells are removed; a separator between quotes becomes
/// a blank. A last line without a line end that has fewer cells than the row above, or whose last
/// number has fewer decimals than in all rows above, is cut off: it is left out, with a note.
CsvText read_table(const std::filesystem::path& file);

/// Returns the table in a text in the same way; the last line is kept.
CsvText table_from_text(const std::string& file, std::string text);

/// Returns the first line of a text that is not blank, without quotes, its cells joined by commas
/// whatever their separator, for a reader that recognises its format.
std::string first_line_with_commas(std::string_view text);

}  // namespace morphe::files
