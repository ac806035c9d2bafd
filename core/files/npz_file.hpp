#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// The type of a numpy array's elements: integers (and booleans, 0 or 1), floating-point numbers,
/// text.
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

/// Reads a .npz file. Throws InputError "FILE: KEY: message" for incomplete files, and for arrays
/// of Python objects, structures, complex numbers and dates. No content of the file is executed. At
/// most 1 GiB is read.
NpzFile read_npz(const std::filesystem::path& file);

/// Returns the keys of a .npz file from its directory alone, whatever the arrays contain. Throws
/// InputError if the directory is incomplete.
std::vector<std::string> npz_keys(const std::filesystem::path& file);

/// Returns true if the beginning of a file is that of a .npz, judging by the name of its first
/// member.
bool is_npz(std::string_view head);

/// Writes the arrays uncompressed as <f8, <i8 and <U, in order; equal arrays give equal bytes. The
/// file is written atomically. Throws InputError if it cannot be written.
void write_npz(const std::filesystem::path& file, const std::vector<NpyArray>& arrays);

/// Parses a .npy file in memory; `file` and `key` begin the error messages, and `key` becomes its
/// name.
NpyArray read_npy(std::string_view bytes, const std::string& file, const std::string& key);
/// Returns an array as the content of a .npy file.
std::string npy_bytes(const NpyArray& array);

}  // namespace morphe::files
