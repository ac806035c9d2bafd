#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/run/output_folder.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/plans_file.hpp"
#include "stages/export/export_plans.hpp"

namespace morphe::commands {

Command export_command(CLI::App& app) {
  struct Arguments {
    std::string plans, format, out;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->plans, "plans.h5, or a run's folder")->required();
  app.add_option("--format", arguments->format, "File format")
      ->required()
      ->check(CLI::IsMember(exports::export_format_names()));
  app.add_option("--out", arguments->out, "Folder to write the files to")->required();
  return [arguments] {
    const std::filesystem::path plans = plans_file(arguments->plans);
    run::OutputFolder folder(arguments->out);
    const exports::ExportReport report =
        exports::export_plans(plans, arguments->format, folder.path());
    folder.keep();
    for (const exports::ExportReport::Left& left : report.left_out) {
      fmt::print("{} left out: {}\n", left.plan, left.why);
    }
    for (const std::string& file : report.files) {
      fmt::print("{}\n", (folder.path() / file).string());
    }
    fmt::print("{} written, {} plans left out\n", report.files.size(), report.left_out.size());
    return 0;
  };
}

}  // namespace morphe::commands
