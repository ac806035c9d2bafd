#include "pipeline/commands/kept_import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/files/atomic_file.hpp"
#include "core/files/sha256.hpp"
#include "stages/import/folders/import_inputs.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

/// Returns a line that differs after any change of the file: its name, size, and the times of the
/// last changes of its content and of its inode.
std::string state_of(const fs::path& file) {
  struct stat now {};
  const bool exists = ::stat(file.c_str(), &now) == 0;
  return exists ? fmt::format("{} {} {}.{} {}.{}\n", file.string(), now.st_size, now.st_mtim.tv_sec,
                              now.st_mtim.tv_nsec, now.st_ctim.tv_sec, now.st_ctim.tv_nsec)
                : fmt::format("{} is missing\n", file.string());
}

std::string text_of(const imports::ImportRequest& request) {
  const imports::Conventions& given = request.conventions;
  std::string text;
  for (const fs::path& path : request.paths) text += fs::absolute(path).string() + "\n";
  return text + fmt::format(
                    "{}\n{}\n{}\n{}\n{}\n{}\n{}\n{} {}\n{}\n", request.static_trial.string(),
                    request.format, request.name_map.string(), given.axes, given.unit,
                    given.rate_hz.value_or(0), given.joint_order, name_of(given.forward),
                    request.forward_given, request.hand ? std::string(name_of(*request.hand)) : "");
}

}  // namespace

std::string import_key(const imports::ImportRequest& request) {
  std::string text = files::sha256_of_file("/proc/self/exe") + "\n" + text_of(request);
  for (const fs::path& file : imports::import_inputs(request)) text += state_of(file);
  return files::sha256(text);
}

std::optional<KeptImport> read_kept_import(const fs::path& file, const std::string& key) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded() || json.value("key", "") != key) return std::nullopt;
  return KeptImport{key, json.value("failed", 0), json.value("text", ""),
                    json.value("manifest", "")};
}

void write_kept_import(const fs::path& file, const KeptImport& kept) {
  const nlohmann::json json{
      {"key", kept.key}, {"failed", kept.failed}, {"text", kept.text}, {"manifest", kept.manifest}};
  const std::string text =
      json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  files::write_atomically(file, text);
}

}  // namespace morphe::commands
