#include "pipeline/report/page_files.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "core/files/embedded.hpp"

extern "C" {
// morphe_page_files.S
extern const morphe::files::EmbeddedFile morphe_page_files[];
extern const std::size_t morphe_page_files_count;
}

namespace morphe::report {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

}  // namespace

std::string_view page_file(std::string_view name) {
  for (std::size_t i = 0; i < morphe_page_files_count; ++i) {
    if (name == morphe_page_files[i].name) return morphe_page_files[i].text();
  }
  assert(false && "no such file of the page");
  return {};
}

std::string bundle_modules(const std::vector<std::string_view>& modules) {
  constexpr std::string_view kExport = "export ";
  std::string script = "(() => {\n\"use strict\";\n";
  for (const std::string_view module : modules) {
    for (std::string_view line : lines_of(module)) {
      if (line.starts_with("import ")) continue;
      if (line.starts_with(kExport)) line.remove_prefix(kExport.size());
      script += line;
    }
  }
  return script + "})();\n";
}

std::string bundle_page_modules() {
  std::vector<std::string_view> modules;
  for (std::string_view name : lines_of(page_file("modules.txt")))
    modules.push_back(page_file(name.substr(0, name.find('\n'))));
  return bundle_modules(modules);
}

}  // namespace morphe::report
