#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/files/npz_file.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The arrays of a clip. Each is asked for by its key with the shape that it must have; what was
/// not asked for can be told afterwards. InputError "FILE: KEY: …" for another shape or kind.
class ClipArrays {
 public:
  /// Of a shape that is asked for: any length.
  static constexpr std::size_t kAny = static_cast<std::size_t>(-1);

  explicit ClipArrays(files::NpzFile npz) : npz_(std::move(npz)) {}

  const std::string& file() const { return npz_.file; }
  bool has(const std::string& key) const { return npz_.find(key) != nullptr; }
  /// Null if there is none of that key.
  const files::NpyArray* numbers(const std::string& key, std::initializer_list<std::size_t> shape);
  std::vector<std::string> texts(const std::string& key);  ///< of one dimension; none = no texts
  std::optional<std::string> text(const std::string& key);
  std::optional<double> number(const std::string& key);
  std::vector<Vec3> points(const std::string& key, std::size_t rows);  ///< [rows, 3]; none = empty
  /// Keys between `before` and `after`, in the order of the file.
  std::vector<std::string> names_between(const std::string& before, const std::string& after) const;
  std::vector<std::string> unread() const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    npz_.fail(key, what);
  }

 private:
  const files::NpyArray* find(const std::string& key);
  files::NpzFile npz_;
  std::set<std::string> read_;
};

/// The k-th of an array's 3×3 or 4×4 matrices, as rotation or rigid motion; NaN where a number of
/// it is. "FILE: KEY: …" if it is none within 1 %.
Quat clip_rotation(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);
Pose clip_pose(const ClipArrays& clip, const files::NpyArray& array, std::size_t k);

}  // namespace morphe::imports
