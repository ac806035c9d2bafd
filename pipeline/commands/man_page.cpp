#include "pipeline/commands/man_page.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <vector>

#include "core/motion/version.hpp"

namespace morphe::commands {
namespace {

constexpr const char* kExitStatus = R"(.SH EXIT STATUS
.TP
.B 0
Success. Infeasible, approximate and partial movements are results too, unless \fB\-\-strict\fR is given.
.TP
.B 1
A demonstration could not be processed, or \fBverify\fR or \fBdiff\fR found something.
.TP
.B 2
Bad usage, config or input; standard error names file, line and key.
.TP
.BR 130 ", " 143
Stopped by SIGINT or SIGTERM; the same command resumes a run.
)";
constexpr const char* kFiles = R"(.SH FILES
Configs and recordings that are shipped (\fIconfigs/\fR..., \fIdatasets/\fR...) are found from every folder.
The documents are in \fI/usr/share/doc/morphe\fR; begin with \fIREADME.md\fR.
)";

/// Returns a text in which troff reads every character as it is. A hyphen is one of an option.
std::string escaped(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    line_begins = c == '\n';
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

/// Returns the type of an option, which may be broken after the words of a list.
std::string type_text(const CLI::Option& option) {
  std::string text;
  for (const char c : escaped(option.get_type_name())) {
    text += c;
    if (c == ',') text += "\\:";
  }
  return text;
}

/// Returns the names and the type of an option, or the name of a positional argument.
std::string heading(const CLI::Option& option) {
  if (option.get_positional()) return "\\fI" + escaped(option.get_name()) + "\\fR";
  std::string names;
  for (const std::string& name : option.get_snames())
    names += (names.empty() ? "" : ", ") + escaped("-" + name);
  for (const std::string& name : option.get_lnames())
    names += (names.empty() ? "" : ", ") + escaped("--" + name);
  const std::string type = option.get_expected_max() == 0 ? "" : type_text(option);
  return "\\fB" + names + "\\fR" + (type.empty() ? "" : " \\fI" + type + "\\fR");
}

std::string synopsis(const CLI::App& command, const std::string& name) {
  std::string line = "\\fB" + escaped(name) + "\\fR [\\fIOPTIONS\\fR]";
  for (const CLI::Option* const option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string argument =
        heading(*option) + (option->get_items_expected_max() > 1 ? "..." : "");
    line += option->get_required() ? " " + argument : " [" + argument + "]";
  }
  return line + "\n";
}

std::string options_text(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* const option : command.get_options()) {
    text += fmt::format(".TP\n{}\n{}{}\n", heading(*option), escaped(option->get_description()),
                        option->get_required() ? " (required)" : "");
  }
  return text;
}

/// Returns the examples of a command's --help, each on its own line.
std::string examples_text(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text, line;
  while (std::getline(lines, line)) {
    if (!line.starts_with("  ")) continue;
    text += escaped(line) + "\n";
  }
  return text.empty() ? "" : ".PP\nExamples:\n.PP\n.nf\n" + text + ".fi\n";
}

std::string command_text(const CLI::App& command, const std::string& above) {
  const std::string name = above + " " + command.get_name();
  std::string text = fmt::format(".SS {}\n{}.PP\n{}.\n{}{}", escaped(name), synopsis(command, name),
                                 escaped(command.get_description()), options_text(command),
                                 examples_text(command.get_footer()));
  for (const CLI::App* const inner : command.get_subcommands({}))
    text += command_text(*inner, name);
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH MORPHE 1 \"\" \"{}\" \"User Commands\"\n.ad l\n"
      ".SH NAME\nmorphe \\- turn recorded human reaches and grasps into robot trajectories\n"
      ".SH SYNOPSIS\n.B morphe\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]...\n"
      ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH COMMANDS\n",
      software(), escaped(app.get_description()), options_text(app));
  for (const CLI::App* const command : app.get_subcommands({}))
    text += command_text(*command, app.get_name());
  return text + kExitStatus + kFiles;
}

}  // namespace morphe::commands
