#include "core/files/npz_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/files/atomic_file.hpp"
#include "core/files/little_endian.hpp"
#include "core/files/zip_archive.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

constexpr std::string_view kNpyExtension = ".npy";
constexpr std::uintmax_t kMaxFile_bytes = std::uintmax_t{1} << 30;

std::string bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > kMaxFile_bytes) throw InputError(file.string() + ": is larger than 1 GiB");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (error || !stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return bytes;
}

}  // namespace

const NpyArray* NpzFile::find(std::string_view key) const {
  const auto found = std::ranges::find(arrays, key, &NpyArray::name);
  return found == arrays.end() ? nullptr : &*found;
}

void NpzFile::fail(std::string_view key, std::string_view what) const {
  throw InputError(fmt::format("{}: {}: {}", file, key, what));
}

NpzFile read_npz(const std::filesystem::path& file) {
  NpzFile npz{file.string(), {}};
  for (const ZipMember& member : unzip(bytes_of(file), npz.file)) {
    if (!member.name.ends_with(kNpyExtension))
      npz.fail(member.name, "is not an array: its name does not end in .npy");
    const std::string key = member.name.substr(0, member.name.size() - kNpyExtension.size());
    npz.arrays.push_back(read_npy(member.bytes, npz.file, key));
  }
  return npz;
}

std::vector<std::string> npz_keys(const std::filesystem::path& file) {
  std::vector<std::string> keys = zip_names(bytes_of(file), file.string());
  for (std::string& key : keys)
    if (key.ends_with(kNpyExtension)) key.resize(key.size() - kNpyExtension.size());
  return keys;
}

bool is_npz(std::string_view head) {
  constexpr std::size_t kNameLengthOffset = 26, kNameOffset = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() < kNameOffset) return false;
  return head.substr(kNameOffset, read_little_endian(head, kNameLengthOffset, 2))
      .ends_with(kNpyExtension);
}

void write_npz(const std::filesystem::path& file, const std::vector<NpyArray>& arrays) {
  std::vector<ZipMember> members;
  for (const NpyArray& array : arrays)
    members.push_back({array.name + std::string(kNpyExtension), npy_bytes(array)});
  write_atomically(file, zip(members, file.string()));
}

}  // namespace morphe::files
