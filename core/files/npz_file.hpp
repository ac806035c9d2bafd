#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// The type of a numpy array's elements; booleans are the integers 0 and 1.
enum class NpyKind { integer, floating, text };

/// A numpy array, with the last index fastest. Shape {} is a scalar.
struct NpyArray {
  std::string name;  ///< its key in a .npz
  NpyKind kind = NpyKind::floating;
  std::vector<std::size_t> shape;
  std::vector<double> values = {};     ///< [product of shape]; integers beyond 2^53 are rounded
  std::vector<std::string> text = {};  ///< likewise for NpyKind::text, in UTF-8
};

/// Returns a shape as numpy prints it: "(120, 20, 3)", "(3,)", "()".
std::string shape_text(const std::vector<std::size_t>& shape);

/// The arrays of a .npz file: a zip archive (zip_archive.hpp) of .npy files.
struct NpzFile {
  std::string file;
  std::vector<NpyArray> arrays;  ///< in the order of the archive

  /// Returns the array with that key, null if there is no such array.
  const NpyArray* find(std::string_view key) const;
  /// Throws InputError "FILE: KEY: message".
  [[noreturn]] void fail(std::string_view key, std::string_view what) const;
};

/// Reads a .npz file of at most 1 GiB and never executes its content. Throws InputError "FILE: KEY:
/// message" if it is damaged, and for arrays of objects, structures, complex numbers and dates.
NpzFile read_npz(const std::filesystem::path& file);

/// Returns the keys in a .npz file's directory; throws InputError if the directory is damaged.
std::vector<std::string> npz_keys(const std::filesystem::path& file);

/// Returns true if the file that begins with `head` is a zip archive whose first member is a .npy.
bool is_npz(std::string_view head);

/// Writes the arrays uncompressed as <f8, <i8 and <U, in order; equal arrays give equal bytes. The
/// file is written atomically. Throws InputError if it cannot be written.
void write_npz(const std::filesystem::path& file, const std::vector<NpyArray>& arrays);

/// Parses a .npy file in memory. `key` is the name of the array; `file` and `key` begin the errors.
NpyArray read_npy(std::string_view bytes, const std::string& file, const std::string& key);
/// Returns an array as the content of a .npy file.
std::string npy_bytes(const NpyArray& array);

}  // namespace morphe::files
