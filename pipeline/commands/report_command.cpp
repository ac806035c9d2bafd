#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "core/config/spelling_hint.hpp"
#include "core/files/atomic_file.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/report/report.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/run/output_folder.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> files, worst;
  std::string out, svg;
  bool unverified = false;
  report::ReportRequest request;
};

std::string stem_or_folder(const fs::path& file) {
  return file.filename() == "plans.h5" && file.has_parent_path()
             ? fs::absolute(file).parent_path().filename().string()
             : file.stem().string();
}

std::vector<report::ReportRequest::Run> runs_of(const std::vector<std::string>& files) {
  std::vector<report::ReportRequest::Run> runs;
  std::set<std::string> names;
  for (const std::string& named : files) {
    for (const fs::path& file : find_plans_files(named)) {
      std::string name = stem_or_folder(file);
      for (int k = 2; !names.insert(name).second; ++k)
        name = fmt::format("{} ({})", stem_or_folder(file), k);
      runs.push_back({file, name, ""});
    }
  }
  return runs;
}

void parse_worst_option(const std::vector<std::string>& worst, report::Selection& selection) {
  if (worst.empty()) return;
  const std::vector<std::string> names = report::ranking_measure_names();
  try {
    std::size_t used = 0;
    selection.worst_count = std::stoi(worst[0], &used);
    if (used != worst[0].size()) selection.worst_count = 0;
  } catch (const std::exception&) {
    selection.worst_count = 0;
  }
  if (selection.worst_count < 1)
    throw InputError(fmt::format("--worst: '{}' is not a number of plans", worst[0]));
  if (std::ranges::find(names, worst[1]) == names.end())
    throw InputError(fmt::format("--worst: '{}' is not one of {}{}", worst[1],
                                 fmt::join(names, ", "), config::spelling_hint(worst[1], names)));
  selection.ranking_measure = worst[1];
}

int execute(ReportArguments& arguments) {
  if (arguments.out.empty() && arguments.svg.empty())
    throw InputError("report: needs --out PAGE.html, --svg FOLDER or both");
  report::ReportRequest& request = arguments.request;
  for (const auto& [given, option] : {std::pair(!request.meshes.empty(), "--meshes"),
                                      std::pair(!request.physics.empty(), "--simulation")})
    expect_effect(!given || !arguments.out.empty(), option, "on filmstrips; give --out PAGE.html");
  parse_worst_option(arguments.worst, request.selection);
  request.runs = runs_of(arguments.files);
  request.jobs = threads_of(0);
  for (auto& run : request.runs) {
    files::expect_not_input(arguments.out, run.plans);
    run.not_verified = expect_verified(run.plans, arguments.unverified, request.jobs);
  }
  const run::OutputFiles page({arguments.out});
  std::optional<run::OutputFolder> pictures;
  if (!arguments.svg.empty()) pictures.emplace(arguments.svg);
  if (!arguments.out.empty()) {
    const report::ReportSummary summary = report::write_report(request, arguments.out);
    for (const std::string& note : summary.notes) fmt::print("{}\n", note);
    fmt::print("{}: {}, {:.1f} MB\n", arguments.out, count_with_noun(summary.shown, "plan"),
               1e-6 * static_cast<double>(fs::file_size(arguments.out)));
  }
  if (pictures) {
    for (const std::string& file : report::write_filmstrips(request, pictures->path()))
      fmt::print("{}\n", (pictures->path() / file).string());
    pictures->keep();
  }
  return 0;
}

CommandAction add_report_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<ReportArguments>();
  app.add_option("FILE", arguments->files,
                 "plans.h5 or folders of runs; several are compared side by side")
      ->required();
  app.add_option("--out", arguments->out, "Page to write (HTML)");
  app.add_option("--svg", arguments->svg, "Folder for one filmstrip per plan (SVG)");
  app.add_option("--plans", arguments->request.selection.pattern,
                 "Only plans whose name matches: DEMONSTRATION/000, with * and ?")
      ->type_name("PLAN");
  app.add_flag("--infeasible", arguments->request.selection.infeasible_only,
               "Only infeasible plans");
  app.add_option("--worst", arguments->worst,
                 fmt::format("N BY: only the N worst plans by {}",
                             fmt::join(report::ranking_measure_names(), ", ")))
      ->expected(2)
      ->type_name("N BY");
  app.add_option("--meshes", arguments->request.meshes,
                 "Folder with the robot's meshes: URDFs and their mesh files, or FRAME.stl");
  app.add_option("--simulation", arguments->request.physics,
                 "Folders written by morphe simulate (default: physics in the folder of the plans)")
      ->type_name("DIR")
      ->allow_extra_args(false);
  add_unverified_option(app, arguments->unverified, "show them marked as not verified");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command report_command() {
  return {"report", "Write a page that plays every plan of a plans.h5 in a browser",
          "  morphe report outputs/first --out outputs/first.html\n"
          "  morphe report outputs/first outputs/again --out outputs/both.html --svg "
          "outputs/pictures\n",
          add_report_arguments};
}

}  // namespace morphe::commands
