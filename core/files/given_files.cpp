#include "core/files/given_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <ranges>

#include "core/files/printable.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

namespace fs = std::filesystem;

/// Returns the number of names at the end of two paths that agree.
std::ptrdiff_t agreeing_names(const fs::path& a, const fs::path& b) {
  const std::vector<fs::path> own(a.begin(), a.end()), other(b.begin(), b.end());
  const auto [end, ignored] = std::mismatch(own.rbegin(), own.rend(), other.rbegin(), other.rend());
  return end - own.rbegin();
}

}  // namespace

void GivenFiles::add(const std::string& relative_path, std::string bytes) {
  const fs::path file = (folder_ / relative_path).lexically_normal();
  const std::string inside = file.lexically_relative(folder_).string();
  if (fs::path(relative_path).is_absolute() || inside.starts_with("..") || inside == ".")
    throw InputError(fmt::format("{}/{}: is outside of {}", folder_.string(),
                                 make_printable(relative_path), folder_.string()));
  if (!files_.emplace(file, std::move(bytes)).second)
    throw InputError(fmt::format("{}: appears twice", make_printable(file.string())));
  order_.push_back(file);
}

fs::path GivenFiles::find(const fs::path& named) const {
  const fs::path wanted = (folder_ / named).lexically_normal();
  if (files_.contains(wanted)) return wanted;
  fs::path best;
  std::ptrdiff_t most = 0;
  for (const fs::path& file : order_) {
    const std::ptrdiff_t agreeing = agreeing_names(file, wanted);
    if (agreeing <= most) continue;
    most = agreeing;
    best = file;
  }
  return best;
}

fs::path GivenFiles::locate(const fs::path& named) const {
  fs::path file = find(named);
  if (!file.empty()) return file;
  const fs::path wanted = (folder_ / named).lexically_normal();
  const std::string inside = wanted.lexically_relative(folder_).string();
  throw InputError(fmt::format("{}: does not contain {}", folder_.string(),
                               make_printable(inside.starts_with("..") ? named.string() : inside)));
}

const std::string& GivenFiles::bytes(const fs::path& named) const {
  return files_.at(locate(named));
}

fs::path located(const fs::path& file, const GivenFiles* given) {
  return given ? given->locate(file) : file;
}

bool is_readable_file(const fs::path& file, const GivenFiles* given) {
  return given ? !given->find(file).empty() : fs::is_regular_file(file);
}

std::string read_bytes(const fs::path& file, const GivenFiles* given) {
  if (given) return given->bytes(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file))
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return bytes;
}

}  // namespace morphe::files
