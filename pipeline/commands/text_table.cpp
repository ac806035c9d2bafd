#include "pipeline/commands/text_table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace morphe::commands {
namespace {

constexpr std::size_t kColumnGap_chars = 2, kMinFirstColumn_chars = 12;

bool is_utf8_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Replaces control characters, which would move the cursor.
std::string replace_controls(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

/// Shortens a text to its first and last code points with … between them.
std::string shorten(const std::string& text, std::size_t most) {
  if (display_width(text) <= most) return text;
  const std::size_t last = (most - 1) / 2;
  std::size_t front = 0, back = text.size();
  for (std::size_t count = 0; count < most - 1 - last; ++count)
    for (++front; front < text.size() && is_utf8_continuation(text[front]);) ++front;
  for (std::size_t count = 0; count < last; ++count)
    for (--back; back > 0 && is_utf8_continuation(text[back]);) --back;
  return text.substr(0, front) + "…" + text.substr(back);
}

std::string cell(const std::string& text, std::size_t width, bool left) {
  const std::string blank(width - std::min(width, display_width(text)), ' ');
  return left ? text + blank : blank + text;
}

struct ColumnLayout {
  std::vector<std::size_t> columns, widths;  ///< columns that are shown
  std::string dropped_columns;

  std::size_t width() const {
    return std::accumulate(widths.begin(), widths.end(), kColumnGap_chars * (widths.size() - 1));
  }
};

ColumnLayout natural_layout(const TextTable& table) {
  ColumnLayout layout;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t width =
        std::max(display_width(table.columns[c].top), display_width(table.columns[c].subhead));
    for (const TextTable::Row& row : table.rows)
      width = std::max(width, display_width(row.cells[c]));
    layout.columns.push_back(c);
    layout.widths.push_back(width);
  }
  return layout;
}

/// Drops columns in order of priority, then shortens the first column.
void fit_to_width(const TextTable& table, std::size_t width, ColumnLayout& layout) {
  const std::size_t name = layout.widths[0];
  const auto needed = [&] { return layout.width() - name + std::min(name, kMinFirstColumn_chars); };
  while (needed() > width) {
    std::size_t most = 0;
    for (std::size_t k = 1; k < layout.columns.size(); ++k) {
      if (table.columns[layout.columns[k]].drop_priority >
          table.columns[layout.columns[most]].drop_priority)
        most = k;
    }
    if (table.columns[layout.columns[most]].drop_priority == 0) break;
    const TextTable::Column& column = table.columns[layout.columns[most]];
    layout.dropped_columns +=
        fmt::format("{}{}{}{}", layout.dropped_columns.empty() ? "" : ", ", column.top,
                    column.top.empty() ? "" : " ", column.subhead);
    layout.columns.erase(layout.columns.begin() + static_cast<std::ptrdiff_t>(most));
    layout.widths.erase(layout.widths.begin() + static_cast<std::ptrdiff_t>(most));
  }
  if (layout.width() > width) {
    const std::size_t others = layout.width() - name;
    layout.widths[0] =
        std::max(std::min(name, kMinFirstColumn_chars), width > others ? width - others : 0);
  }
}

template <class TextOf>
std::string line_of(const TextTable& table, const ColumnLayout& layout, const TextOf& text_of) {
  std::string line;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const std::size_t c = layout.columns[k];
    const std::string text = shorten(escape_controls(text_of(c)), layout.widths[k]);
    line += (k > 0 ? std::string(kColumnGap_chars, ' ') : "") +
            cell(text, layout.widths[k], table.columns[c].left);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string wrap_line(const std::string& text, std::size_t width, const std::string& indent) {
  const std::string further = indent + "    ";
  std::string out, line = indent;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const bool first = line == indent || line == further;
    if (width > 0 && !first && display_width(line) + 1 + display_width(word) > width) {
      out += line + "\n";
      line = further + word;
    } else {
      line += (first ? "" : " ") + word;
    }
    at = end + 1;
  }
  return out + line + "\n";
}

std::string table_text(const TextTable& table, std::size_t width) {
  ColumnLayout layout = natural_layout(table);
  if (width > 0 && layout.width() > width) fit_to_width(table, width, layout);
  std::string text = line_of(table, layout, [&](std::size_t c) { return table.columns[c].top; });
  text += line_of(table, layout, [&](std::size_t c) { return table.columns[c].subhead; });
  for (const TextTable::Row& row : table.rows) {
    text += line_of(table, layout, [&](std::size_t c) { return row.cells[c]; });
    for (const std::string& line : row.lines)
      text += wrap_line(replace_controls(line), width, "  ");
  }
  if (!layout.dropped_columns.empty())
    text += wrap_line(fmt::format("(hidden columns: {})", layout.dropped_columns), width, "");
  return text;
}

std::size_t terminal_width() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 0 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

std::size_t display_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return !is_utf8_continuation(c); }));
}

}  // namespace morphe::commands
