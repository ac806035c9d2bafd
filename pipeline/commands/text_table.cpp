#include "pipeline/commands/text_table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace morphe::commands {
namespace {

constexpr std::size_t kGap = 2, kLeastName = 12;

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Control characters would move the cursor.
std::string shown(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

/// The first and the last of a text's code points, … between them.
std::string shortened(const std::string& text, std::size_t most) {
  if (width_of(text) <= most) return text;
  const std::size_t last = (most - 1) / 2;
  std::size_t front = 0, back = text.size();
  for (std::size_t count = 0; count < most - 1 - last; ++count)
    for (++front; front < text.size() && continues(text[front]);) ++front;
  for (std::size_t count = 0; count < last; ++count)
    for (--back; back > 0 && continues(text[back]);) --back;
  return text.substr(0, front) + "…" + text.substr(back);
}

std::string cell(const std::string& text, std::size_t width, bool left) {
  const std::string blank(width - std::min(width, width_of(text)), ' ');
  return left ? text + blank : blank + text;
}

struct Layout {
  std::vector<std::size_t> columns, widths;  ///< those that are shown
  std::string left_out;

  std::size_t width() const {
    return std::accumulate(widths.begin(), widths.end(), kGap * (widths.size() - 1));
  }
};

Layout natural_layout(const TextTable& table) {
  Layout layout;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t width = std::max(width_of(table.columns[c].top), width_of(table.columns[c].below));
    for (const TextTable::Row& row : table.rows) width = std::max(width, width_of(row.cells[c]));
    layout.columns.push_back(c);
    layout.widths.push_back(width);
  }
  return layout;
}

/// Leaves columns out, the most spare first, then shortens the first.
void fit(const TextTable& table, std::size_t width, Layout& layout) {
  const std::size_t name = layout.widths[0];
  const auto needed = [&] { return layout.width() - name + std::min(name, kLeastName); };
  while (needed() > width) {
    std::size_t most = 0;
    for (std::size_t k = 1; k < layout.columns.size(); ++k) {
      if (table.columns[layout.columns[k]].spare > table.columns[layout.columns[most]].spare)
        most = k;
    }
    if (table.columns[layout.columns[most]].spare == 0) break;
    const TextTable::Column& column = table.columns[layout.columns[most]];
    layout.left_out += fmt::format("{}{}{}{}", layout.left_out.empty() ? "" : ", ", column.top,
                                   column.top.empty() ? "" : " ", column.below);
    layout.columns.erase(layout.columns.begin() + static_cast<std::ptrdiff_t>(most));
    layout.widths.erase(layout.widths.begin() + static_cast<std::ptrdiff_t>(most));
  }
  if (layout.width() > width) {
    const std::size_t others = layout.width() - name;
    layout.widths[0] = std::max(std::min(name, kLeastName), width > others ? width - others : 0);
  }
}

template <class TextOf>
std::string line_of(const TextTable& table, const Layout& layout, const TextOf& text_of) {
  std::string line;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const std::size_t c = layout.columns[k];
    const std::string text = shortened(shown(text_of(c)), layout.widths[k]);
    line +=
        (k > 0 ? std::string(kGap, ' ') : "") + cell(text, layout.widths[k], table.columns[c].left);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string folded(const std::string& text, std::size_t width, const std::string& indent) {
  const std::string further = indent + "    ";
  std::string out, line = indent;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const bool first = line == indent || line == further;
    if (width > 0 && !first && width_of(line) + 1 + width_of(word) > width) {
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
  Layout layout = natural_layout(table);
  if (width > 0 && layout.width() > width) fit(table, width, layout);
  std::string text = line_of(table, layout, [&](std::size_t c) { return table.columns[c].top; });
  text += line_of(table, layout, [&](std::size_t c) { return table.columns[c].below; });
  for (const TextTable::Row& row : table.rows) {
    text += line_of(table, layout, [&](std::size_t c) { return row.cells[c]; });
    for (const std::string& line : row.lines) text += folded(shown(line), width, "  ");
  }
  if (!layout.left_out.empty())
    text += folded(fmt::format("(too narrow for: {})", layout.left_out), width, "");
  return text;
}

std::size_t terminal_width() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 0 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return !continues(c); }));
}

}  // namespace morphe::commands
