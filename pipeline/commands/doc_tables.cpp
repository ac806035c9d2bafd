#include "pipeline/commands/doc_tables.hpp"

#include <cstddef>
#include <vector>

#include "core/files/embedded.hpp"

extern "C" {
// defined in morphe_doc_pages.S
extern const morphe::files::EmbeddedFile morphe_doc_pages[];
extern const std::size_t morphe_doc_pages_count;
}

namespace morphe::commands {
namespace {

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Removes links and code marks: "see [the page](scene.md) of `scene`" -> "see the page of scene".
std::string strip_markdown(std::string_view markdown) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const std::size_t close = markdown.find("](", i);
    if (markdown[i] == '[' && close != std::string_view::npos &&
        markdown.find('[', i + 1) > close) {
      text += strip_markdown(markdown.substr(i + 1, close - i - 1));
      i = markdown.find(')', close);
      if (i == std::string_view::npos) break;
    } else if (markdown[i] != '`') {
      text += markdown[i];
    }
  }
  return text;
}

/// Adds the key of a row "| `key` | default | meaning |".
void add_row(const std::string& type, std::string_view line, DocTables& tables) {
  std::vector<std::size_t> bars;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '|') bars.push_back(i);
  if (bars.size() < 4) return;
  const std::string_view key = trim(line.substr(bars[0] + 1, bars[1] - bars[0] - 1));
  const std::string_view meaning = line.substr(bars[2] + 1, bars.back() - bars[2] - 1);
  if (key.starts_with('`')) tables[{type, strip_markdown(key)}] = strip_markdown(trim(meaning));
}

}  // namespace

void add_doc_tables(std::string_view page, DocTables& tables) {
  constexpr std::string_view kBegin = "<!-- keys: ", kEnd = " -->";
  std::string type;
  for (std::size_t begin = 0; begin < page.size();) {
    const std::size_t end = std::min(page.find('\n', begin), page.size());
    const std::string_view line = page.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with(kBegin) && line.ends_with(kEnd)) {
      const std::string_view names = line.substr(0, line.size() - kEnd.size());
      type = names.substr(names.rfind(' ') + 1);
    } else if (!line.starts_with('|')) {
      type.clear();
    } else if (!type.empty()) {
      add_row(type, line, tables);
    }
  }
}

DocTables doc_tables() {
  DocTables tables;
  for (std::size_t i = 0; i < morphe_doc_pages_count; ++i)
    add_doc_tables(morphe_doc_pages[i].text(), tables);
  return tables;
}

}  // namespace morphe::commands
