#include "pipeline/commands/text_table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>
#include <set>

namespace morphe::commands {
namespace {

constexpr std::size_t kColumnGap_chars = 2, kMinFirstColumn_chars = 12;

bool is_utf8_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Replaces control characters, which would move the cursor, by question marks.
std::string replace_controls(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return text;
}

std::string cell(const std::string& text, std::size_t width, bool left) {
  const std::string blank(width - std::min(width, display_width(text)), ' ');
  return left ? text + blank : blank + text;
}

/// Returns the first and the last `last` characters of a text, with … between, in `width`
/// characters; the text itself if it fits.
std::string abridge(const std::string& text, std::size_t width, std::size_t last) {
  if (display_width(text) <= width) return text;
  std::size_t front = 0, back = text.size();
  for (std::size_t count = 0; count < width - 1 - last; ++count)
    for (++front; front < text.size() && is_utf8_continuation(text[front]);) ++front;
  for (std::size_t count = 0; count < last; ++count)
    for (--back; back > 0 && is_utf8_continuation(text[back]);) --back;
  return text.substr(0, front) + "…" + text.substr(back);
}

/// The manner in which names of the first column are shortened.
struct NameShortening {
  std::size_t width = kMinFirstColumn_chars, last = (kMinFirstColumn_chars - 1) / 2;
};

/// Returns true if different names stay different.
bool keeps_apart(const std::set<std::string>& names, const NameShortening& shortening) {
  std::set<std::string> texts;
  return std::ranges::all_of(names, [&](const std::string& name) {
    return texts.insert(abridge(name, shortening.width, shortening.last)).second;
  });
}

/// Returns the characters that are kept at the end: half of them, or a number at which different
/// names stay different; no value without such a number.
std::optional<std::size_t> kept_at_end(const std::set<std::string>& names, std::size_t width) {
  const std::size_t half = (width - 1) / 2;
  if (keeps_apart(names, {width, half})) return half;
  for (std::size_t last = width - 1; last-- > 0;)
    if (keeps_apart(names, {width, last})) return last;
  return std::nullopt;
}

/// Returns the least width of the first column at which different names stay different.
std::size_t least_name_width(const std::set<std::string>& names, std::size_t natural_width) {
  std::size_t width = std::min(natural_width, kMinFirstColumn_chars);
  while (width < natural_width && !kept_at_end(names, width)) ++width;
  return width;
}

struct ColumnLayout {
  std::vector<int> columns;  ///< indices of the columns that are shown
  std::vector<std::size_t> widths;
  std::size_t kept_at_end = 0;  ///< characters of a shortened name
  std::string dropped_columns;

  std::size_t width() const {
    return std::accumulate(widths.begin(), widths.end(), kColumnGap_chars * (widths.size() - 1));
  }
};

ColumnLayout natural_layout(const TextTable& table) {
  ColumnLayout layout;
  for (int c = 0; c < std::ssize(table.columns); ++c) {
    std::size_t width =
        std::max(display_width(table.columns[c].top), display_width(table.columns[c].subhead));
    for (const TextTable::Row& row : table.rows)
      width = std::max(width, display_width(row.cells[c]));
    layout.columns.push_back(c);
    layout.widths.push_back(width);
  }
  return layout;
}

/// Drops columns, the highest drop_priority first, until the table fits with a first column of
/// least_name_width(). Then shortens the first column as necessary, down to that width.
void fit_to_width(const TextTable& table, std::size_t width, ColumnLayout& layout) {
  const std::size_t name_width = layout.widths[0];
  std::set<std::string> names;
  for (const TextTable::Row& row : table.rows) names.insert(replace_controls(row.cells[0]));
  const std::size_t least_width = least_name_width(names, name_width);
  const auto needed = [&] { return layout.width() - name_width + least_width; };
  while (needed() > width) {
    const auto dropped = std::ranges::max_element(
        layout.columns, {}, [&](int c) { return table.columns[c].drop_priority; });
    const TextTable::Column& column = table.columns[*dropped];
    if (column.drop_priority == 0) break;
    layout.dropped_columns +=
        fmt::format("{}{}{}{}", layout.dropped_columns.empty() ? "" : ", ", column.top,
                    column.top.empty() ? "" : " ", column.subhead);
    layout.widths.erase(layout.widths.begin() + (dropped - layout.columns.begin()));
    layout.columns.erase(dropped);
  }
  if (layout.width() > width) {
    const std::size_t others = layout.width() - name_width;
    layout.widths[0] = std::max(least_width, width > others ? width - others : 0);
    // A width above the least one may have no such number; then the least one is taken.
    if (!kept_at_end(names, layout.widths[0])) layout.widths[0] = least_width;
    layout.kept_at_end = kept_at_end(names, layout.widths[0]).value_or(0);
  }
}

template <class TextOf>
std::string line_of(const TextTable& table, const ColumnLayout& layout, const TextOf& text_of) {
  std::string line;
  for (int k = 0; k < std::ssize(layout.columns); ++k) {
    const int c = layout.columns[k];
    const std::string whole = replace_controls(text_of(c));
    const std::string text = k == 0 ? abridge(whole, layout.widths[k], layout.kept_at_end)
                                    : shorten(whole, layout.widths[k]);
    line += (k > 0 ? std::string(kColumnGap_chars, ' ') : "") +
            cell(text, layout.widths[k], table.columns[c].left);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string shorten(const std::string& text, std::size_t max_width) {
  return abridge(text, max_width, (max_width - 1) / 2);
}

std::string wrap_line(const std::string& text, std::size_t width, const std::string& indent) {
  const std::string further = indent + "    ";
  std::string out, line = indent;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const bool first = line == indent || line == further;
    if (width > 0 && !first && display_width(line) + 1 + display_width(word) > width) {
      out += line + "\n";
      line = further + word;
    } else {
      line += (first ? "" : " ") + word;
    }
    begin = end + 1;
  }
  return out + line + "\n";
}

std::string table_text(const TextTable& table, std::size_t width) {
  ColumnLayout layout = natural_layout(table);
  if (width > 0 && layout.width() > width) fit_to_width(table, width, layout);
  std::string text = line_of(table, layout, [&](int c) { return table.columns[c].top; });
  text += line_of(table, layout, [&](int c) { return table.columns[c].subhead; });
  for (const TextTable::Row& row : table.rows) {
    text += line_of(table, layout, [&](int c) { return row.cells[c]; });
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
  return std::ranges::count_if(text, [](char c) { return !is_utf8_continuation(c); });
}

}  // namespace morphe::commands
