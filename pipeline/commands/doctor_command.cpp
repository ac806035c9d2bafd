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
  enum class Kind { fine, note, error } kind = Kind::fine;
  std::string what, found, to_do;
};

SystemCheck check_cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const unsigned all = std::thread::hardware_concurrency();
  unsigned usable = all;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    usable = static_cast<unsigned>(CPU_COUNT(&allowed));
  SystemCheck symptom{SystemCheck::Kind::fine, "cores", count_with_noun(usable, "core"), ""};
  if (usable < all) {
    symptom.kind = SystemCheck::Kind::note;
    symptom.found += fmt::format(" of {}", all);
    symptom.to_do = fmt::format("this process may use no more; give --jobs {}", usable);
  }
  return symptom;
}

SystemCheck check_memory() {
  struct sysinfo info {};
  ::sysinfo(&info);
  const double all_GB = 1e-9 * static_cast<double>(info.totalram) * info.mem_unit;
  SystemCheck symptom{SystemCheck::Kind::fine, "memory", fmt::format("{:.1f} GB", all_GB), ""};
  if (all_GB < 1) {
    symptom.kind = SystemCheck::Kind::note;
    symptom.to_do = "little: give --jobs 1";
  }
  return symptom;
}

/// Checks the shipped files and all files that a config loads.
SystemCheck check_shipped_files() {
  SystemCheck symptom{SystemCheck::Kind::fine, "shipped files", "", ""};
  try {
    const fs::path file = files::resolve_data_file(kReferencePipeline);
    const planning::LoadedConfig config = planning::load_config(file);
    const fs::path configs = file.parent_path().parent_path();
    symptom.found = fmt::format("{}; {} loads", fs::absolute(configs).lexically_normal().string(),
                                config.robot.name);
  } catch (const std::exception& error) {
    symptom.kind = SystemCheck::Kind::note;
    symptom.found = error.what();
    symptom.to_do =
        "work in Morphe's source folder, or install it (cmake --install, or its package): then "
        "they "
        "are found from everywhere";
  }
  return symptom;
}

/// Checks a folder by writing a result as a run does, with HDF5 and a journal.
SystemCheck check_folder_writable(const char* what, const fs::path& folder) {
  SystemCheck symptom{SystemCheck::Kind::fine, what, folder.string(), ""};
  const fs::path tried = folder / fmt::format("morphe_doctor_{}", ::getpid());
  const files::UnfinishedPath unfinished(tried);
  try {
    if (!fs::create_directory(tried)) throw InputError(tried.string() + ": cannot be made");
    files::write_atomically(tried / "text", "text");
    store::Hdf5File::create(tried / "file.h5").close();
    run::Database(tried / "journal.sqlite", run::DatabaseUse::write).run("CREATE TABLE t(x)");
    const double free_GB = 1e-9 * static_cast<double>(fs::space(folder).available);
    symptom.found += fmt::format(", {:.1f} GB free", free_GB);
    if (free_GB < 0.1) {
      symptom.kind = SystemCheck::Kind::note;
      symptom.to_do = "make room: a thousand plans take about 100 MB";
    }
  } catch (const std::exception& error) {
    symptom.kind = SystemCheck::Kind::error;
    symptom.found = error.what();
    symptom.to_do = "work in a folder in which you may write, on a disk that is not full";
  }
  std::error_code ignored;
  fs::remove_all(tried, ignored);
  return symptom;
}

SystemCheck physics_engine() {
  const std::string engine = physics::engine_version();
  if (!engine.empty()) return {SystemCheck::Kind::fine, "physics", engine, ""};
  return {SystemCheck::Kind::note, "physics", "none: morphe simulate is not there",
          "install libmujoco-dev, configure and build again"};
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
  SystemCheck symptom{SystemCheck::Kind::fine, "locale", name.empty() ? "none is set" : name, ""};
  if (letters) return symptom;
  symptom.kind = SystemCheck::Kind::note;
  symptom.to_do = "messages hold letters of UTF-8: export LANG=C.UTF-8 if they look odd";
  return symptom;
}

std::vector<SystemCheck> run_checks() {
  std::error_code ignored;
  const char* const home = std::getenv("TMPDIR");
  const fs::path temporary = home ? fs::path(home) : fs::path("/tmp");
  std::vector<SystemCheck> symptoms = {
    {SystemCheck::Kind::fine, "version", software(), ""},
    {SystemCheck::Kind::fine, "built with", built_with(), ""},
#if defined(__AVX2__) && defined(__FMA__)
    {SystemCheck::Kind::fine, "processor", "has AVX2 and FMA, for which this was built", ""},
#else
    {Symptom::Kind::fine, "processor", "any of its kind will do", ""},
#endif
    check_cores(),
    check_memory(),
    check_shipped_files(),
    check_folder_writable("this folder", fs::current_path(ignored)),
    check_folder_writable("temporary files", temporary),
    physics_engine(),
    check_locale(),
    {SystemCheck::Kind::fine, "terminal",
     ::isatty(STDERR_FILENO) == 1 ? "progress is a line that changes"
                                  : "none: progress is a line for each demonstration",
     ""}
  };
  return symptoms;
}

std::string_view kind_name(SystemCheck::Kind kind) {
  return kind == SystemCheck::Kind::fine   ? "fine"
         : kind == SystemCheck::Kind::note ? "note"
                                           : "WRONG";
}

int execute(bool json) {
  const std::vector<SystemCheck> symptoms = run_checks();
  std::size_t wrong = 0;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const SystemCheck& one : symptoms) {
    wrong += one.kind == SystemCheck::Kind::error ? 1U : 0U;
    all.push_back({{"what", one.what},
                   {"state", CLI::detail::to_lower(std::string(kind_name(one.kind)))},
                   {"found", one.found},
                   {"to_do", one.to_do}});
    if (json) continue;
    fmt::print("{:<6} {:<16} {}\n", kind_name(one.kind), one.what, one.found);
    if (!one.to_do.empty()) fmt::print("{:<6} {:<16} -> {}\n", "", "", one.to_do);
  }
  if (json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"fit", wrong == 0}, {"findings", all}}.dump(2));
  } else if (wrong > 0) {
    fmt::print("{} wrong\n", count_with_noun(wrong, "thing is", "things are"));
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
