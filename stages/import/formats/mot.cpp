// OpenSim storage (.mot, .sto) of joint coordinates: header lines up to "endheader", a line of
// column names that begins with "time", then a row per sample; cells are separated by commas, or
// otherwise by blanks and tabs. AngleStream contains angles only: columns named …_tx, …_ty, …_tz or
// …trans… are translations and left out (reported).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/files/csv.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/column_label.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {
namespace {

/// Returns the cells of a line without empty ones at its end, which are padding.
std::vector<std::string_view> cells_of(const files::CsvText& text, std::size_t line) {
  std::vector<std::string_view> cells;
  if (text.separator == ',') {
    cells = text.cells(line);
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
  }
  const std::string_view here = text.lines[line - 1];
  for (std::size_t at = here.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(here.find_first_of(" \t", at), here.size());
    cells.push_back(here.substr(at, end - at));
    at = here.find_first_not_of(" \t", end);
  }
  return cells;
}

struct MotHeader {
  std::size_t end = 0;                       ///< line of "endheader"
  std::map<std::string, std::string> value;  ///< by key in lower case
};

/// Reads lines "key=value" up to "endheader"; other lines are free text.
MotHeader read_mot_header(const files::CsvText& text) {
  MotHeader header;
  for (std::size_t line = 1; line <= text.lines.size(); ++line) {
    std::string here = to_lower(text.lines[line - 1]);
    here.erase(std::find(here.begin(), here.end(), ','), here.end());
    std::erase_if(here, [](char c) { return c == ' ' || c == '\t'; });
    if (here == "endheader") {
      header.end = line;
      return header;
    }
    if (const std::size_t sign = here.find('='); sign != std::string::npos) {
      header.value[here.substr(0, sign)] = here.substr(sign + 1);
    }
  }
  text.fail(std::max<std::size_t>(1, text.lines.size()), "endheader", "the line is missing");
}

bool is_translation(const std::string& column) {
  const std::string name = to_lower(column);
  return name.ends_with("_tx") || name.ends_with("_ty") || name.ends_with("_tz") ||
         name.find("trans") != std::string::npos;
}

/// Returns radians in the file's unit of angle.
double radians_of(const files::CsvText& text, const MotHeader& header,
                  const Conventions& conventions) {
  if (const auto said = header.value.find("indegrees"); said != header.value.end()) {
    if (said->second == "yes" || said->second == "true") return kRadPerDegree;
    if (said->second == "no" || said->second == "false") return 1;
    text.fail(header.end, "inDegrees", fmt::format("must be yes or no, not '{}'", said->second));
  }
  if (conventions.unit == "deg") return kRadPerDegree;
  if (conventions.unit == "rad") return 1;
  text.fail(
      header.end, "inDegrees",
      "the header does not state whether angles are in degrees; give --unit or `unit:` deg or rad");
}

/// Reports a count in the header that differs from the contents.
void compare_count(const files::CsvText& text, const MotHeader& header, const std::string& key,
                   std::size_t found, const char* what, std::vector<std::string>& reports) {
  const auto said = header.value.find(to_lower(key));
  if (said == header.value.end()) return;
  if (text.number(header.end, key, said->second) == static_cast<double>(found)) return;
  reports.push_back(fmt::format("{} is {}, but the file has {} {}; all are used", key, said->second,
                                found, what));
}

/// Returns a number, or NaN if the cell contains "nan".
double number_or_nan(const files::CsvText& text, std::size_t line, const std::string& column,
                     std::string_view cell) {
  return to_lower(cell) == "nan" ? kUnknown : text.number(line, column, cell);
}

std::vector<std::string> read_columns(const files::CsvText& text, std::size_t line) {
  std::vector<std::string> columns;
  std::set<std::string> known;
  for (const std::string_view cell : cells_of(text, line)) {
    if (cell.empty()) text.fail(line, "", fmt::format("column {} has no name", columns.size() + 1));
    if (!known.emplace(cell).second) text.fail(line, cell, "the column appears twice");
    columns.emplace_back(cell);
  }
  if (columns.empty() || to_lower(columns[0]) != "time") {
    text.fail(line, "time", "the first column must have this name");
  }
  return columns;
}

}  // namespace

bool recognises_mot(std::string_view head) {
  const std::string text = to_lower(head);
  return text.find("endheader") != std::string::npos &&
         (text.find("nrows") != std::string::npos || text.find("indegrees") != std::string::npos ||
          text.find("datatype") != std::string::npos);
}

Demonstration read_mot(const RecordingFiles& files) {
  files::CsvText text = files::read_csv(files.file);
  if (!files.static_trial.empty()) text.fail(1, "static_trial", "this format has no static trial");
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = text.notes;
  const MotHeader header = read_mot_header(text);
  std::size_t line = header.end + 1;
  while (line <= text.lines.size() && text.is_blank(line)) ++line;
  if (line > text.lines.size()) text.fail(header.end, "", "the file ends after its header");
  if (text.lines[line - 1].find(',') == std::string::npos) text.separator = '\t';
  const std::vector<std::string> columns = read_columns(text, line);
  const double radians = radians_of(text, header, files.conventions);

  AngleStream stream;
  std::vector<std::size_t> kept;
  std::vector<std::string> left_out;
  for (std::size_t c = 1; c < columns.size(); ++c) {
    if (is_translation(columns[c])) {
      left_out.push_back(columns[c]);
    } else {
      kept.push_back(c);
      stream.joints.push_back(columns[c]);
    }
  }
  if (kept.empty()) text.fail(line, "", "has no column of a joint angle");
  std::vector<double> values;
  std::size_t unseen = 0;
  for (++line; line <= text.lines.size(); ++line) {
    if (text.is_blank(line)) continue;
    const auto cells = cells_of(text, line);
    if (cells.size() != columns.size()) {
      text.fail(
          line, cells.size() < columns.size() ? columns[cells.size()] : "",
          fmt::format("the row has {} cells, the header has {}", cells.size(), columns.size()));
    }
    const double time_s = text.number(line, "time", cells[0]);
    if (!stream.time.empty() && !(time_s > stream.time.back())) {
      text.fail(line, "time", "must be greater than in the previous row");
    }
    stream.time.push_back(time_s);
    for (const std::size_t c : kept) {
      values.push_back(radians * number_or_nan(text, line, columns[c], cells[c]));
      if (std::isnan(values.back())) ++unseen;
    }
  }
  if (stream.time.empty()) text.fail(text.lines.size(), "", "the file has no rows");
  stream.angles = Eigen::Map<const JointRows>(values.data(), stream.time.size(), kept.size());
  compare_count(text, header, "nRows", stream.time.size(), "rows", reports);
  compare_count(text, header, "nColumns", columns.size(), "columns", reports);
  if (!left_out.empty()) {
    reports.push_back(fmt::format("translations skipped: {}", fmt::join(left_out, ", ")));
  }
  if (unseen > 0) {
    reports.push_back(fmt::format("{} of {} angles are missing (NaN)", unseen, values.size()));
  }
  apply_name_map(text.file, files.name_map, stream.joints);
  demonstration.streams.arm_angles = std::move(stream);
  return demonstration;
}

}  // namespace morphe::imports
