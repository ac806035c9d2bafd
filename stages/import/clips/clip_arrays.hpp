#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/files/npz_file.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The arrays of a clip. Each is requested by its key; those that were not requested can be listed
/// afterwards. A request throws InputError "FILE: KEY: …" for an array of another shape or type.
class ClipArrays {
 public:
  static constexpr std::size_t kAnyLength = -1;  ///< in a requested shape

  /// Takes the arrays of a file.
  explicit ClipArrays(files::NpzFile npz) : npz_(std::move(npz)) {}

  /// Returns the file's name.
  const std::string& file() const { return npz_.file; }
  /// Returns true if there is an array with that key.
  bool has(const std::string& key) const { return npz_.find(key) != nullptr; }
  /// Returns the array of numbers with that key, which must have this shape; null if absent.
  const files::NpyArray* numbers(const std::string& key, std::initializer_list<std::size_t> shape);
  std::vector<std::string> texts(const std::string& key);   ///< one-dimensional; empty if absent
  std::optional<std::string> text(const std::string& key);  ///< a single text; no value if absent
  std::optional<double> number(const std::string& key);     ///< a single number; no value if absent
  std::vector<Vec3> points(const std::string& key, std::size_t rows);  ///< [rows]; empty if absent
  /// Throws InputError with this key unless the times are finite and increase.
  void expect_increasing(const std::string& key, const std::vector<double>& time) const;
  /// Returns the parts of keys between `before` and `after`, in the order of the file.
  std::vector<std::string> names_between(const std::string& before, const std::string& after) const;
  /// Returns the keys that were not requested.
  std::vector<std::string> unread() const;
  /// Throws InputError "FILE: KEY: …".
  [[noreturn]] void fail(const std::string& key, const std::string& message) const {
    npz_.fail(key, message);
  }

 private:
  const files::NpyArray* find(const std::string& key);
  files::NpzFile npz_;
  std::set<std::string> read_;
};

/// Returns matrix k of an array of 3×3 matrices as a rotation, which is unknown if it has a NaN or
/// only zeros.
/// Throws InputError "FILE: KEY: …" if it is not orthonormal within 1 %.
Quat clip_rotation(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);
/// Returns matrix k of an array of 4×4 matrices as a pose, with a rotation as above.
Pose clip_pose(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);

}  // namespace morphe::imports
