// OpenSim storage (.mot, .sto) of joint coordinates: header lines up to "endheader", a line of
// column names that begins with "time", then a row per instant. Cells are separated by commas,
// semicolons or, if the line of names has none, by blanks and tabs. AngleStream contains angles
// only: translations, and columns of other quantities (mot_columns.hpp), are left out and reported.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/files/table_text.hpp"
#include "stages/import/formats/mot_columns.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/column_label.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/repeated_names.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

/// Returns the cells of a line, without empty ones at its end.
std::vector<std::string_view> cells_of(const files::CsvText& text, std::size_t line) {
  std::vector<std::string_view> cells;
  if (text.separator != '\t') {
    cells = text.cells(line);
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
  }
  const std::string_view row = text.lines[line - 1];
  for (std::size_t begin = row.find_first_not_of(" \t"); begin != std::string_view::npos;) {
    const std::size_t end = std::min(row.find_first_of(" \t", begin), row.size());
    cells.push_back(row.substr(begin, end - begin));
    begin = row.find_first_not_of(" \t", end);
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
    std::string entry = to_lower(text.lines[line - 1]);
    entry.erase(std::ranges::find(entry, ','), entry.end());
    std::erase_if(entry, [](char c) { return c == ' ' || c == '\t'; });
    if (entry == "endheader") {
      header.end = line;
      return header;
    }
    if (const std::size_t equals = entry.find('='); equals != std::string::npos)
      header.value[entry.substr(0, equals)] = entry.substr(equals + 1);
  }
  text.fail(std::max<std::size_t>(1, text.lines.size()), "endheader", "the line is missing");
}

double radians_per_unit(const files::CsvText& text, const MotHeader& header,
                        const Conventions& conventions) {
  if (const auto entry = header.value.find("indegrees"); entry != header.value.end()) {
    const std::string& answer = entry->second;
    if (answer == "yes" || answer == "true") return kRadPerDegree;
    if (answer == "no" || answer == "false") return 1;
    text.fail(header.end, "inDegrees", fmt::format("must be yes or no, not '{}'", answer));
  }
  if (conventions.unit == "deg") return kRadPerDegree;
  if (conventions.unit == "rad") return 1;
  text.fail(
      header.end, "inDegrees",
      "the header does not state whether angles are in degrees; give --unit or `unit:` deg or rad");
}

void compare_count(const files::CsvText& text, const MotHeader& header, const std::string& key,
                   std::size_t count, const char* noun, std::vector<std::string>& reports) {
  const auto entry = header.value.find(to_lower(key));
  if (entry == header.value.end()) return;
  if (text.number(header.end, key, entry->second) == static_cast<double>(count)) return;
  add_note(reports, "{} is {}, but the file has {} {}; all are used", key, entry->second, count,
           noun);
}

std::vector<std::string> read_columns(const files::CsvText& text, std::size_t line,
                                      std::vector<std::string>& reports) {
  std::vector<std::string> columns;
  for (const std::string_view cell : cells_of(text, line)) {
    if (cell.empty()) text.fail(line, "", fmt::format("column {} has no name", columns.size() + 1));
    columns.emplace_back(cell);
  }
  if (columns.empty() || to_lower(columns[0]) != "time")
    text.fail(line, "time", "the first column must have this name");
  number_repeated_names(columns, reports);
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
  files::CsvText text = files::read_table(files.file);
  if (!files.static_trial.empty()) text.fail(1, "static_trial", "this format has no static trial");
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = text.notes;
  const MotHeader header = read_mot_header(text);
  std::size_t line = text.filled_line(header.end + 1);
  if (line > text.lines.size()) text.fail(header.end, "", "the file ends after its header");
  if (text.lines[line - 1].find(text.separator) == std::string::npos) text.separator = '\t';
  const std::vector<std::string> columns = read_columns(text, line, reports);
  const double radians = radians_per_unit(text, header, files.conventions);

  AngleStream stream;
  const std::string contents = mot_contents(text.lines[0]);
  if (!contents.empty()) text.fail(1, "", fmt::format("has {}, no joint angles", contents));
  std::vector<std::size_t> kept;
  std::map<std::string, std::vector<std::string>> left_out;  // by quantity
  for (std::size_t c = 1; c < columns.size(); ++c) {
    const std::string quantity = mot_quantity(columns[c]);
    if (!quantity.empty()) {
      left_out[quantity].push_back(columns[c]);
    } else {
      kept.push_back(c);
      stream.joints.push_back(mot_joint(columns[c]));
    }
  }
  if (kept.empty()) {
    std::vector<std::string> quantities;
    for (const auto& [quantity, names] : left_out) quantities.push_back(quantity);
    text.fail(line, "",
              fmt::format("has no column of a joint angle, only {}", fmt::join(quantities, ", ")));
  }
  std::vector<double> values;
  int missing = 0;
  for (++line; line <= text.lines.size(); ++line) {
    if (text.is_blank(line)) continue;
    const auto cells = cells_of(text, line);
    if (cells.size() != columns.size()) {
      text.fail(
          line, cells.size() < columns.size() ? columns[cells.size()] : "",
          fmt::format("the row has {} cells, the header has {}", cells.size(), columns.size()));
    }
    add_time(text.number(line, "time", cells[0]), text.file, line, "time", stream.time);
    for (const std::size_t c : kept) {
      values.push_back(radians * text.number_or_unknown(line, columns[c], cells[c]));
      if (std::isnan(values.back())) ++missing;
    }
  }
  if (stream.time.empty()) text.fail(text.lines.size(), "", "the file has no rows");
  stream.angles = Eigen::Map<const JointRows>(values.data(), stream.time.size(), kept.size());
  compare_count(text, header, "nRows", stream.time.size(), "rows", reports);
  compare_count(text, header, "nColumns", columns.size(), "columns", reports);
  for (const auto& [quantity, names] : left_out)
    add_note(reports, "{} skipped: {}", quantity, fmt::join(names, ", "));
  if (missing > 0) add_note(reports, "{} of {} angles are missing (NaN)", missing, values.size());
  apply_name_map(text.file, files.name_map, stream.joints);
  demonstration.streams.arm_angles = std::move(stream);
  return demonstration;
}

}  // namespace morphe::imports
