#pragma once

#include <string>

namespace morphe::exports {

/// Returns the text as a cell of a CSV table, quoted if it contains a comma, a quote or a line end
/// (RFC 4180).
inline std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace morphe::exports
