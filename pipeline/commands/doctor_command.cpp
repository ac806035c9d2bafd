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

/// The result of one check. `error`: Morphe cannot work; `note`: it works, but slowly or with
/// restrictions.
struct SystemCheck {
  enum class Status { ok, warning, error } status = Status::ok;
  std::string name, detail, remedy;
};

SystemCheck check_cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const unsigned all = std::thread::hardware_concurrency();
  unsigned usable = all;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    usable = static_cast<unsigned>(CPU_COUNT(&allowed));
  SystemCheck symptom{SystemCheck::Status::ok, "cores", count_with_noun(usable, "core"), ""};
  if (usable < all) {
    symptom.status = SystemCheck::Status::warning;
    symptom.detail += fmt::format(" of {}", all);
    symptom.remedy = fmt::format("this process may use only these; give --jobs {}", usable);
  }
  return symptom;
}

SystemCheck check_memory() {
  struct sysinfo info {};
  ::sysinfo(&info);
  const double all_GB = 1e-9 * static_cast<double>(info.totalram) * info.mem_unit;
  SystemCheck symptom{SystemCheck::Status::ok, "memory", fmt::format("{:.1f} GB", all_GB), ""};
  if (all_GB < 1) {
    symptom.status = SystemCheck::Status::warning;
    symptom.remedy = "less than 1 GB: give --jobs 1";
  }
  return symptom;
}

/// Checks the shipped files and all files that a config loads.
SystemCheck check_shipped_files() {
  SystemCheck symptom{SystemCheck::Status::ok, "shipped files", "", ""};
  try {
    const fs::path file = files::resolve_data_file(kReferencePipeline);
    const planning::LoadedConfig config = planning::load_config(file);
    const fs::path configs = file.parent_path().parent_path();
    symptom.detail = fmt::format("{}; {} loads", fs::absolute(configs).lexically_normal().string(),
                                 config.robot.name);
  } catch (const std::exception& error) {
    symptom.status = SystemCheck::Status::warning;
    symptom.detail = error.what();
    symptom.remedy =
        "work in Morphe's source folder, or install Morphe (cmake --install, or its package), so "
        "that they are found from every folder";
  }
  return symptom;
}

/// Checks a folder by writing a result as a run does, with HDF5 and a journal.
SystemCheck check_folder_writable(const char* name, const fs::path& folder) {
  SystemCheck symptom{SystemCheck::Status::ok, name, folder.string(), ""};
  const fs::path tried = folder / fmt::format("morphe_doctor_{}", ::getpid());
  const files::UnfinishedPath unfinished(tried);
  try {
    if (!fs::create_directory(tried)) throw InputError(tried.string() + ": cannot be created");
    files::write_atomically(tried / "text", "text");
    store::Hdf5File::create(tried / "file.h5").close();
    run::Database(tried / "journal.sqlite", run::DatabaseUse::write).run("CREATE TABLE t(x)");
    const double free_GB = 1e-9 * static_cast<double>(fs::space(folder).available);
    symptom.detail += fmt::format(", {:.1f} GB free", free_GB);
    if (free_GB < 0.1) {
      symptom.status = SystemCheck::Status::warning;
      symptom.remedy = "free some space: 1000 plans take about 100 MB";
    }
  } catch (const std::exception& error) {
    symptom.status = SystemCheck::Status::error;
    symptom.detail = error.what();
    symptom.remedy = "work in a folder with write permission, on a disk with free space";
  }
  std::error_code ignored;
  fs::remove_all(tried, ignored);
  return symptom;
}

SystemCheck physics_engine() {
  const std::string engine = physics::engine_version();
  if (!engine.empty()) return {SystemCheck::Status::ok, "physics", engine, ""};
  return {SystemCheck::Status::warning, "physics",
          "no physics engine: morphe simulate is not available",
          "install libmujoco-dev, then configure and build again"};
}

/// Checks the locale. Numbers are read and written in the same way in every locale; file names are
/// bytes.
SystemCheck check_locale() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value ? value : "");
  };
  std::string name = variable("LC_ALL");
  if (name.empty()) name = variable("LC_CTYPE");
  if (name.empty()) name = variable("LANG");
  const bool letters =
      name.find("UTF-8") != std::string::npos || name.find("utf8") != std::string::npos;
  SystemCheck symptom{SystemCheck::Status::ok, "locale", name.empty() ? "not set" : name, ""};
  if (letters) return symptom;
  symptom.status = SystemCheck::Status::warning;
  symptom.remedy =
      "messages contain UTF-8 characters: export LANG=C.UTF-8 if they are not displayed correctly";
  return symptom;
}

std::vector<SystemCheck> run_checks() {
  std::error_code ignored;
  const char* const home = std::getenv("TMPDIR");
  const fs::path temporary = home ? fs::path(home) : fs::path("/tmp");
  std::vector<SystemCheck> symptoms = {
    {SystemCheck::Status::ok, "version", software(), ""},
    {SystemCheck::Status::ok, "built with", built_with(), ""},
#if defined(__AVX2__) && defined(__FMA__)
    {SystemCheck::Status::ok, "processor", "AVX2 and FMA, as required by this build", ""},
#else
    {SystemCheck::Status::ok, "processor", "no special instructions required", ""},
#endif
    check_cores(),
    check_memory(),
    check_shipped_files(),
    check_folder_writable("this folder", fs::current_path(ignored)),
    check_folder_writable("temporary files", temporary),
    physics_engine(),
    check_locale(),
    {SystemCheck::Status::ok, "terminal",
     ::isatty(STDERR_FILENO) == 1 ? "progress is one line, updated in place"
                                  : "no terminal: progress is one line per demonstration",
     ""}
  };
  return symptoms;
}

std::string_view status_name(SystemCheck::Status status) {
  return status == SystemCheck::Status::ok        ? "ok"
         : status == SystemCheck::Status::warning ? "warning"
                                                  : "ERROR";
}

int execute(bool json) {
  const std::vector<SystemCheck> symptoms = run_checks();
  std::size_t wrong = 0;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const SystemCheck& one : symptoms) {
    wrong += one.status == SystemCheck::Status::error ? 1U : 0U;
    all.push_back({{"name", one.name},
                   {"status", CLI::detail::to_lower(std::string(status_name(one.status)))},
                   {"detail", one.detail},
                   {"remedy", one.remedy}});
    if (json) continue;
    fmt::print("{:<7} {:<16} {}\n", status_name(one.status), one.name, one.detail);
    if (!one.remedy.empty()) fmt::print("{:<7} {:<16} -> {}\n", "", "", one.remedy);
  }
  if (json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"ok", wrong == 0}, {"checks", all}}.dump(2));
  } else if (wrong > 0) {
    fmt::print("{} failed\n", count_with_noun(wrong, "check", "checks"));
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace

Command doctor_command(CLI::App& app) {
  const auto json = std::make_shared<bool>(false);
  app.add_flag("--json", *json, "Print JSON");
  return [json] { return execute(*json); };
}

}  // namespace morphe::commands
