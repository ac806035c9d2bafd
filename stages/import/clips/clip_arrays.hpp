#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/files/npz_file.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The arrays of a clip. Each is requested by its key with its required shape; arrays that were not
/// requested can be listed afterwards. Throws InputError "FILE: KEY: …" for another shape or type.
class ClipArrays {
 public:
  /// Any length, for a requested shape.
  static constexpr std::size_t kAnyLength = -1;

  /// Takes the arrays of a file.
  explicit ClipArrays(files::NpzFile npz) : npz_(std::move(npz)) {}

  /// Returns the file's name.
  const std::string& file() const { return npz_.file; }
  /// Returns true if there is an array with that key.
  bool has(const std::string& key) const { return npz_.find(key) != nullptr; }
  /// Returns the array with that key, null if absent.
  const files::NpyArray* numbers(const std::string& key, std::initializer_list<std::size_t> shape);
  std::vector<std::string> texts(const std::string& key);  ///< one-dimensional; empty if absent
  /// Returns a single text, no value if absent.
  std::optional<std::string> text(const std::string& key);
  /// Returns a single number, no value if absent.
  std::optional<double> number(const std::string& key);
  /// [rows, 3]; empty if absent.
  std::vector<Vec3> points(const std::string& key, std::size_t rows);
  /// Returns the parts of keys between `before` and `after`, in the order of the file.
  std::vector<std::string> names_between(const std::string& before, const std::string& after) const;
  /// Returns the keys that were not requested.
  std::vector<std::string> unread() const;
  /// Throws InputError "FILE: KEY: …".
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    npz_.fail(key, what);
  }

 private:
  const files::NpyArray* find(const std::string& key);
  files::NpzFile npz_;
  std::set<std::string> read_;
};

/// Returns the k-th of an array's 3×3 or 4×4 matrices as rotation or rigid motion; NaN if one of
/// its numbers is NaN. Throws "FILE: KEY: …" if it is not rigid within 1 %.
Quat clip_rotation(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);
Pose clip_pose(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);

}  // namespace morphe::imports
