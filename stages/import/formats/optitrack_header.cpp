#include "stages/import/formats/optitrack_header.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::imports {
namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kFirstColumn = 2;  ///< after frame and time
constexpr std::size_t kMaxHeaderLines = 12;

Cells texts_of(const files::CsvText& csv, std::size_t line) {
  const auto cells = csv.cells(line);
  return {cells.begin(), cells.end()};
}

std::string cell(const Cells& cells, std::size_t column) {
  return column < cells.size() ? cells[column] : "";
}

void read_first_line(const files::CsvText& csv, OptitrackHeader& header) {
  const std::size_t line = csv.filled_line(1);
  const Cells cells = texts_of(csv, line);
  if (cell(cells, 0) != "Format Version")
    csv.fail(line, "", "must begin with 'Format Version'; export the take with its header");
  for (std::size_t k = 0; k + 1 < cells.size(); k += 2) header.settings[cells[k]] = cells[k + 1];
  if (header.value("Coordinate Space") == "Local")
    csv.fail(line, "Coordinate Space", "is Local; export in Global coordinates");
}

/// Returns the lines from the second to "Frame,Time…": types, names, IDs, (parents,) quantities.
std::vector<std::size_t> lines_above(const files::CsvText& csv, OptitrackHeader& header) {
  std::vector<std::size_t> lines;
  const std::size_t last = std::min(csv.lines.size(), kMaxHeaderLines);
  for (std::size_t line = csv.filled_line(1) + 1; line <= last; ++line) {
    if (cell(texts_of(csv, line), 0) == "Frame") {
      header.line = line;
      return lines;
    }
    if (!csv.is_blank(line)) lines.push_back(line);
  }
  csv.fail(last, "Frame", "the line 'Frame,Time' is missing; export the take with its header");
}

/// Returns the columns of one quantity of an item in the order X, Y, Z, W.
std::vector<std::size_t> ordered_columns(const files::CsvText& csv, std::size_t line,
                                         const std::string& item, const std::string& quantity,
                                         const std::map<std::string, std::size_t>& by_axis) {
  std::vector<std::size_t> columns;
  if (by_axis.empty()) return columns;
  for (const char* axis : {"X", "Y", "Z", "W"}) {
    const auto entry = by_axis.find(axis);
    if (entry != by_axis.end()) {
      columns.push_back(entry->second);
    } else if (*axis != 'W') {
      csv.fail(line, fmt::format("{}.{}", item, quantity), fmt::format("lacks {}", axis));
    }
  }
  return columns;
}

}  // namespace

std::string OptitrackHeader::value(const std::string& key) const {
  const auto found = settings.find(key);
  return found == settings.end() ? "" : found->second;
}

OptitrackHeader read_optitrack_header(const files::CsvText& csv) {
  OptitrackHeader header;
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  read_first_line(csv, header);
  const std::vector<std::size_t> lines = lines_above(csv, header);
  if (lines.size() < 3) {
    csv.fail(header.line, "",
             "the lines of types, names and quantities are missing above this line");
  }
  const Cells types = texts_of(csv, lines[0]), names = texts_of(csv, lines[1]),
              quantities = texts_of(csv, lines.back()), axes = texts_of(csv, header.line);
  header.cells = axes.size();
  while (header.cells > kFirstColumn && cell(quantities, header.cells - 1).empty() &&
         axes[header.cells - 1].empty() && cell(types, header.cells - 1).empty()) {
    --header.cells;
  }
  for (std::size_t c = kFirstColumn; c < header.cells;) {
    OptitrackItem item{cell(types, c), cell(names, c), {}, {}};
    std::map<std::string, std::map<std::string, std::size_t>> columns;  // by quantity and axis
    for (; c < header.cells && cell(types, c) == item.type && cell(names, c) == item.name; ++c) {
      if (cell(axes, c).empty()) continue;  // a column of errors or quality
      if (!columns[cell(quantities, c)].emplace(cell(axes, c), c).second) break;  // another item
    }
    item.position = ordered_columns(csv, header.line, item.name, "Position", columns["Position"]);
    item.rotation = ordered_columns(csv, header.line, item.name, "Rotation", columns["Rotation"]);
    if (item.position.size() > 3) csv.fail(header.line, item.name, "has four columns of position");
    header.items.push_back(std::move(item));
  }
  return header;
}

}  // namespace morphe::imports
