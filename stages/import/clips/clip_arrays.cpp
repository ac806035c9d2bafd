#include "stages/import/clips/clip_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::imports {
namespace {

using files::NpyArray;
using files::NpyKind;

std::string required_shape_text(std::initializer_list<std::size_t> shape) {
  std::string text;
  for (const std::size_t length : shape) {
    text += text.empty() ? "" : ", ";
    text += length == ClipArrays::kAnyLength ? "any" : std::to_string(length);
  }
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

bool fits(const std::vector<std::size_t>& shape, std::initializer_list<std::size_t> required) {
  return std::ranges::equal(shape, required, [](std::size_t length, std::size_t required_length) {
    return required_length == ClipArrays::kAnyLength || length == required_length;
  });
}

/// Returns the rotation in the first three rows and columns of the array's k-th square matrix.
Quat rotation_of(const ClipArrays& clip, const NpyArray& array, std::size_t k, int size) {
  constexpr double kRotationTolerance = 0.01;
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col)
      matrix(row, col) = array.values[k * size * size + row * size + col];
  }
  if (!matrix.allFinite() || matrix.isZero(0)) return unknown_rotation();
  if (!(matrix * matrix.transpose()).isIdentity(kRotationTolerance) || matrix.determinant() < 0)
    clip.fail(array.name, fmt::format("matrix {} is not a rotation", k));
  return Quat(matrix).normalized();
}

}  // namespace

const NpyArray* ClipArrays::find(const std::string& key) {
  read_.insert(key);
  return npz_.find(key);
}

const NpyArray* ClipArrays::numbers(const std::string& key,
                                    std::initializer_list<std::size_t> shape) {
  const NpyArray* const array = find(key);
  if (array == nullptr) return nullptr;
  if (array->kind == NpyKind::text) fail(key, "must contain numbers, not text");
  if (!fits(array->shape, shape)) {
    fail(key, fmt::format("has shape {}, must be {}", files::shape_text(array->shape),
                          required_shape_text(shape)));
  }
  return array;
}

std::vector<std::string> ClipArrays::texts(const std::string& key) {
  const NpyArray* const array = find(key);
  if (array == nullptr) return {};
  if (array->kind != NpyKind::text || array->shape.size() != 1)
    fail(key, "must be a list of texts");
  return array->text;
}

std::optional<std::string> ClipArrays::text(const std::string& key) {
  const NpyArray* const array = find(key);
  if (array == nullptr) return std::nullopt;
  if (array->kind != NpyKind::text || array->text.size() != 1) fail(key, "must be one text");
  return array->text.front();
}

std::optional<double> ClipArrays::number(const std::string& key) {
  const NpyArray* const array = find(key);
  if (array == nullptr) return std::nullopt;
  if (array->values.size() != 1 || !std::isfinite(array->values[0]))
    fail(key, "must be one number");
  return array->values.front();
}

std::vector<Vec3> ClipArrays::points(const std::string& key, std::size_t rows) {
  std::vector<Vec3> points;
  const NpyArray* const array = numbers(key, {rows, 3});
  if (array == nullptr) return points;
  for (std::size_t i = 0; i < array->shape[0]; ++i)
    points.emplace_back(Eigen::Map<const Vec3>(array->values.data() + 3 * i));
  return points;
}

void ClipArrays::expect_increasing(const std::string& key, const std::vector<double>& time) const {
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1])))
      fail(key, fmt::format("value {} must be greater than the previous one", i));
  }
}

std::vector<std::string> ClipArrays::names_between(const std::string& before,
                                                   const std::string& after) const {
  std::vector<std::string> names;
  for (const NpyArray& array : npz_.arrays) {
    const std::string& key = array.name;
    const std::size_t others = before.size() + after.size();
    if (key.size() <= others || !key.starts_with(before) || !key.ends_with(after)) continue;
    names.push_back(key.substr(before.size(), key.size() - others));
  }
  return names;
}

std::vector<std::string> ClipArrays::unread() const {
  std::vector<std::string> keys;
  for (const NpyArray& array : npz_.arrays) {
    if (!read_.contains(array.name)) keys.push_back(array.name);
  }
  return keys;
}

Quat clip_rotation(const ClipArrays& clip, const NpyArray& array, std::size_t k) {
  return rotation_of(clip, array, k, 3);
}

Pose clip_pose(const ClipArrays& clip, const NpyArray& array, std::size_t k) {
  const Quat rotation = rotation_of(clip, array, k, 4);
  const double* const matrix = array.values.data() + 16 * k;
  const Eigen::Map<const Eigen::Vector4d> last_row(matrix + 12);
  if (is_known(rotation) && !last_row.isApprox(Eigen::Vector4d::UnitW(), 1e-6))
    clip.fail(array.name, fmt::format("the last row of matrix {} must be 0 0 0 1", k));
  return make_pose(Vec3(matrix[3], matrix[7], matrix[11]), rotation);
}

}  // namespace morphe::imports
