#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// What numpy counts by: whole numbers (and truth values, 0 or 1), numbers, text.
enum class NpyKind { whole, number, text };

/// One array of numpy, the last index fastest. Shape {} is one value.
struct NpyArray {
  std::string name;  ///< its key in a .npz
  NpyKind kind = NpyKind::number;
  std::vector<std::size_t> shape;
  std::vector<double> values = {};  ///< [product of shape]; whole numbers beyond 2^53 are rounded
  std::vector<std::string> text = {};  ///< the same of NpyKind::text, UTF-8
};

/// "(120, 20, 3)", "(3,)", "()": as numpy writes a shape.
std::string shape_text(const std::vector<std::size_t>& shape);

/// The arrays of a .npz: a zip archive (zip_archive.hpp) of .npy files.
struct NpzFile {
  std::string file;
  std::vector<NpyArray> arrays;  ///< in the order of the archive

  /// Null if there is none of that key.
  const NpyArray* find(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, std::string_view what) const;  ///< "FILE: KEY: what"
};

/// InputError "FILE: KEY: what" for what is no whole .npz, and for arrays of Python objects,
/// structures, complex numbers and dates. Nothing of a file is executed. At most 1 GiB.
NpzFile read_npz(const std::filesystem::path& file);

/// The keys of a .npz, from its directory alone: what the arrays hold may be anything. InputError
/// if it has no whole directory.
std::vector<std::string> npz_keys(const std::filesystem::path& file);

/// Whether a file that begins so is a .npz, by the name of its first member.
bool begins_as_npz(std::string_view head);

/// Uncompressed: <f8, <i8 and <U, in order; the same arrays give the same bytes. The file appears
/// whole or not at all. InputError if it cannot be written.
void write_npz(const std::filesystem::path& file, const std::vector<NpyArray>& arrays);

/// One .npy in memory; `file` and `key` are what errors begin with, `key` becomes its name.
NpyArray read_npy(std::string_view bytes, const std::string& file, const std::string& key);
std::string npy_bytes(const NpyArray& array);

}  // namespace morphe::files
