#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/config/schema.hpp"
#include "core/files/atomic_file.hpp"
#include "core/robot/files/robot_schema.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/doc_tables.hpp"
#include "pipeline/commands/value_checks.hpp"
#include "pipeline/planning/config_schema.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/run/output_folder.hpp"
#include "pipeline/study/study.hpp"
#include "pipeline/synthesize/synthesize.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/scene/scene_schema.hpp"

namespace morphe::commands {
namespace {

struct FileKind {
  const char *name, *title;
  config::Schema (*schema)(const config::KeyDescriptions&);
};

constexpr FileKind kFileKinds[] = {
    {"config", "Pipeline config of Morphe", planning::config_schema},
    {"manifest", "Manifest of recordings for Morphe", imports::manifest_schema},
    {"robot", "Robot description of Morphe",
     [](const config::KeyDescriptions&) { return robot::robot_schema(); }},
    {"scene", "Scene objects of Morphe", scene::scene_schema},
    {"study", "Study config of Morphe", study::study_schema},
    {"synthetic", "Config for synthetic recordings of Morphe",
     [](const config::KeyDescriptions& meanings) {
       return config::schema_of<synthesize::SynthesizeOptions>(meanings);
     }},
};

std::string text_of(const FileKind& kind) {
  const DocTables tables = doc_tables();
  const config::KeyDescriptions meanings = [&](const std::string& type, const std::string& key) {
    const auto found = tables.find({type, key});
    return found == tables.end() ? std::string() : found->second;
  };
  return config::schema_document(kind.title, kind.schema(meanings)).dump(1) + "\n";
}

/// Returns the kind of that name, which exists.
const FileKind& find_file_kind(const std::string& name) {
  return *std::ranges::find_if(kFileKinds, [&](const FileKind& kind) { return kind.name == name; });
}

int write_all(const std::filesystem::path& folder) {
  run::OutputFolder out(folder);
  for (const FileKind& kind : kFileKinds) {
    const std::filesystem::path file = folder / fmt::format("{}.json", kind.name);
    files::write_atomically(file, text_of(kind));
    out.keep();
    fmt::print("{}\n", file.string());
  }
  return 0;
}

CommandAction add_schema_arguments(CLI::App& app) {
  struct Arguments {
    std::string kind, out;
  };
  const auto arguments = std::make_shared<Arguments>();
  std::vector<std::string> kinds;
  for (const FileKind& kind : kFileKinds) kinds.emplace_back(kind.name);
  app.add_option("KIND", arguments->kind, "Kind of file (default: all)")->check(one_of(kinds));
  app.add_option("--out", arguments->out, "File to write, or folder if KIND is not given");
  return [arguments] {
    if (arguments->kind.empty() && arguments->out.empty())
      throw InputError("schema: needs KIND, or --out FOLDER for all kinds");
    if (arguments->kind.empty()) return write_all(arguments->out);
    const std::string text = text_of(find_file_kind(arguments->kind));
    if (arguments->out.empty()) {
      fmt::print("{}", text);
    } else {
      const run::OutputFiles lock({arguments->out});
      files::write_atomically(arguments->out, text);
      fmt::print("{}\n", arguments->out);
    }
    return 0;
  };
}

}  // namespace

Command schema_command() {
  return {"schema", "Print the JSON schema of a kind of YAML file, for editors",
          "  morphe schema config\n"
          "  morphe schema robot --out outputs/robot.schema.json\n",
          add_schema_arguments};
}

}  // namespace morphe::commands
