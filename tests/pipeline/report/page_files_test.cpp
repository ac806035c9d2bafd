#include "pipeline/report/page_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace morphe::report {
namespace {

namespace fs = std::filesystem;

const fs::path kPage = fs::path(MORPHE_SOURCE_DIR) / "pipeline/report/page";

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST(PageFile, HoldsEveryFileByteByByte) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kPage)) {
    if (entry.path().extension() == ".md") continue;
    EXPECT_EQ(page_file(entry.path().filename().string()), text_of(entry.path())) << entry.path();
  }
  EXPECT_NE(page_file("three.min.js").find("THREE"), std::string_view::npos);
}

TEST(Bundled, LeavesOutImportsAndTheWordExport) {
  EXPECT_EQ(
      bundle_modules({"import { a } from \"./a.js\";\nexport const b = a;\n", "  export = 1;\n"}),
      "(() => {\n\"use strict\";\nconst b = a;\n  export = 1;\n})();\n");
}

TEST(BundledModules, HasEveryModuleOnceAndEveryNameOnce) {
  std::map<std::string, std::string> defined;
  const std::regex definition(
      R"(^(?:export )?(?:async )?(?:function\*?|const|let|class) ([A-Za-z_$][\w$]*))");
  std::istringstream names(text_of(kPage / "modules.txt"));
  std::string listed;
  for (std::string name; std::getline(names, name);) {
    listed += name + "\n";
    std::istringstream module(text_of(kPage / name));
    for (std::string line; std::getline(module, line);) {
      std::smatch found;
      if (!std::regex_search(line, found, definition)) continue;
      EXPECT_TRUE(defined.emplace(found[1], name).second)
          << found[1] << " in " << name << " and " << defined[found[1]];
    }
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(kPage)) {
    if (entry.path().extension() != ".js") continue;
    EXPECT_NE(listed.find(entry.path().filename().string() + "\n"), std::string::npos) << entry;
  }
  EXPECT_EQ(bundle_page_modules().find("\nimport "), std::string::npos);
}

/// A module's imports name what its sources define, so that it could be loaded by itself.
TEST(BundledModules, ImportWhatIsThere) {
  const std::regex import_line(R"~(^import \{ ([^}]*) \} from "\./([\w.]+)";$)~");
  for (const fs::directory_entry& entry : fs::directory_iterator(kPage)) {
    if (entry.path().extension() != ".js") continue;
    std::istringstream module(text_of(entry.path()));
    for (std::string line; std::getline(module, line);) {
      if (!line.starts_with("import")) continue;
      std::smatch found;
      ASSERT_TRUE(std::regex_match(line, found, import_line)) << entry << ": " << line;
      const std::string source = text_of(kPage / found[2].str());
      std::istringstream wanted(found[1]);
      for (std::string name; wanted >> name;) {
        std::erase(name, ',');
        const std::regex exported("(^|\n)export (async )?(function\\*?|const|let|class) " + name +
                                  "\\b");
        EXPECT_TRUE(std::regex_search(source, exported)) << entry << ": " << line << ": " << name;
      }
    }
  }
}

}  // namespace
}  // namespace morphe::report
