#include <fmt/format.h>
#include <sched.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/files/atomic_file.hpp"
#include "core/files/data_files.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/version.hpp"
#include "core/physics/model.hpp"
#include "core/store/hdf5_file.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/run/database.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReferencePipeline = "configs/pipelines/pa10_dlr_hit2.yaml";

/// The result of a check: with an error Morphe cannot work, with a warning only slowly or in part.
enum class CheckStatus { ok, warning, error };

struct SystemCheck {
  CheckStatus status = CheckStatus::ok;
  std::string name, detail, remedy = {};
};

SystemCheck check_cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const unsigned all = std::thread::hardware_concurrency();
  unsigned usable = all;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    usable = static_cast<unsigned>(CPU_COUNT(&allowed));
  SystemCheck check{CheckStatus::ok, "cores", count_with_noun(usable, "core")};
  if (usable < all) {
    check.status = CheckStatus::warning;
    check.detail += fmt::format(" of {}", all);
    check.remedy = fmt::format("this process may use only these; give --jobs {}", usable);
  }
  return check;
}

SystemCheck check_memory() {
  struct sysinfo info {};
  ::sysinfo(&info);
  const double all_GB = 1e-9 * static_cast<double>(info.totalram) * info.mem_unit;
  SystemCheck check{CheckStatus::ok, "memory", fmt::format("{:.1f} GB", all_GB)};
  if (all_GB < 1) {
    check.status = CheckStatus::warning;
    check.remedy = "less than 1 GB: give --jobs 1";
  }
  return check;
}

/// Checks that the shipped files are found and that the reference pipeline and its robot load.
SystemCheck check_shipped_files() {
  SystemCheck check{CheckStatus::ok, "shipped files", ""};
  try {
    const fs::path file = files::resolve_data_file(kReferencePipeline);
    const planning::LoadedConfig config = planning::load_config(file);
    const fs::path configs = file.parent_path().parent_path();
    check.detail = fmt::format("{}; {} loads", fs::absolute(configs).lexically_normal().string(),
                               config.robot.name);
  } catch (const std::exception& error) {
    check.status = CheckStatus::warning;
    check.detail = error.what();
    check.remedy =
        "work in Morphe's source folder, or install Morphe (cmake --install, or its package), so "
        "that they are found from every folder";
  }
  return check;
}

/// Checks a folder by writing a result as a run does, with HDF5 and a journal.
SystemCheck check_folder_writable(const char* name, const fs::path& folder) {
  SystemCheck check{CheckStatus::ok, name, folder.string()};
  const fs::path trial = folder / fmt::format("morphe_doctor_{}", ::getpid());
  const files::UnfinishedPath unfinished(trial);
  try {
    if (!fs::create_directory(trial)) throw InputError(trial.string() + ": cannot be created");
    files::write_atomically(trial / "text", "text");
    store::Hdf5File::create(trial / "file.h5").close();
    run::Database(trial / "journal.sqlite", run::DatabaseUse::write).run("CREATE TABLE t(x)");
    const double free_GB = 1e-9 * static_cast<double>(fs::space(folder).available);
    check.detail += fmt::format(", {:.1f} GB free", free_GB);
    if (free_GB < 0.1) {
      check.status = CheckStatus::warning;
      check.remedy = "free some space: 1000 plans take about 100 MB";
    }
  } catch (const std::exception& error) {
    check.status = CheckStatus::error;
    check.detail = error.what();
    check.remedy = "work in a folder with write permission, on a disk with free space";
  }
  std::error_code ignored;
  fs::remove_all(trial, ignored);
  return check;
}

SystemCheck check_physics_engine() {
  const std::string engine = physics::engine_version();
  if (!engine.empty()) return {CheckStatus::ok, "physics", engine};
  return {CheckStatus::warning, "physics", "no physics engine: morphe simulate is not available",
          "install libmujoco-dev, then configure and build again"};
}

/// Checks whether the locale displays UTF-8. It changes neither numbers nor file names.
SystemCheck check_locale() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value ? value : "");
  };
  std::string name = variable("LC_ALL");
  if (name.empty()) name = variable("LC_CTYPE");
  if (name.empty()) name = variable("LANG");
  const bool utf8 =
      name.find("UTF-8") != std::string::npos || name.find("utf8") != std::string::npos;
  SystemCheck check{CheckStatus::ok, "locale", name.empty() ? "not set" : name};
  if (utf8) return check;
  check.status = CheckStatus::warning;
  check.remedy =
      "messages contain UTF-8 characters: export LANG=C.UTF-8 if they are not displayed correctly";
  return check;
}

std::vector<SystemCheck> run_checks() {
  std::error_code ignored;
  const char* const temporary = std::getenv("TMPDIR");
  return {
    {CheckStatus::ok, "version", software()}, {CheckStatus::ok, "built with", built_with()},
#if defined(__AVX2__) && defined(__FMA__)
        {CheckStatus::ok, "processor", "AVX2 and FMA, as required by this build"},
#else
        {CheckStatus::ok, "processor", "no special instructions required"},
#endif
        check_cores(), check_memory(), check_shipped_files(),
        check_folder_writable("this folder", fs::current_path(ignored)),
        check_folder_writable("temporary files", temporary ? temporary : "/tmp"),
        check_physics_engine(), check_locale(), {
      CheckStatus::ok, "terminal",
          ::isatty(STDERR_FILENO) == 1 ? "progress is one line, updated in place"
                                       : "no terminal: progress is one line per demonstration"
    }
  };
}

std::string_view status_name(CheckStatus status) {
  return status == CheckStatus::ok ? "ok" : status == CheckStatus::warning ? "warning" : "ERROR";
}

int execute(bool json) {
  int failed = 0;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const SystemCheck& check : run_checks()) {
    failed += check.status == CheckStatus::error ? 1 : 0;
    all.push_back({{"name", check.name},
                   {"status", CLI::detail::to_lower(std::string(status_name(check.status)))},
                   {"detail", check.detail},
                   {"remedy", check.remedy}});
    if (json) continue;
    fmt::print("{:<7} {:<16} {}\n", status_name(check.status), check.name, check.detail);
    if (!check.remedy.empty()) fmt::print("{:<7} {:<16} -> {}\n", "", "", check.remedy);
  }
  if (json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"ok", failed == 0}, {"checks", all}}.dump(2));
  } else if (failed > 0) {
    fmt::print("{} failed\n", count_with_noun(failed, "check"));
  }
  return failed == 0 ? 0 : 1;
}

CommandAction add_doctor_arguments(CLI::App& app) {
  const auto json = std::make_shared<bool>(false);
  app.add_flag("--json", *json, "Print JSON");
  return [json] { return execute(*json); };
}

}  // namespace

Command doctor_command() {
  return {"doctor", "Check whether this system has everything that Morphe needs",
          "  morphe doctor\n", add_doctor_arguments};
}

}  // namespace morphe::commands
