#include "stages/import/clips/clip_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::imports {
namespace {

using files::NpyArray;
using files::NpyKind;

std::string wanted_text(std::initializer_list<std::size_t> shape) {
  std::string text;
  for (const std::size_t length : shape) {
    text += text.empty() ? "" : ", ";
    text += length == ClipArrays::kAnyLength ? "any" : std::to_string(length);
  }
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

bool fits(const std::vector<std::size_t>& shape, std::initializer_list<std::size_t> wanted) {
  return std::ranges::equal(shape, wanted, [](std::size_t length, std::size_t as) {
    return as == ClipArrays::kAnyLength || length == as;
  });
}

/// Returns a 3×3 matrix whose rows are `row_length` apart, starting at `begin`.
Eigen::Matrix3d matrix_at(const NpyArray& array, std::size_t begin, std::size_t row_length) {
  Eigen::Matrix3d matrix;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index col = 0; col < 3; ++col) {
      matrix(row, col) = array.values[begin + row * row_length + col];
    }
  }
  return matrix;
}

Quat rotation_of(const ClipArrays& clip, const NpyArray& array, std::size_t k,
                 const Eigen::Matrix3d& matrix) {
  constexpr double kRotationTolerance = 0.01;
  if (!matrix.allFinite()) return unknown_rotation();
  if (!(matrix * matrix.transpose()).isIdentity(kRotationTolerance) || matrix.determinant() < 0) {
    clip.fail(array.name, fmt::format("matrix {} is not a rotation", k));
  }
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
                          wanted_text(shape)));
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
  for (std::size_t i = 0; i < array->shape[0]; ++i) {
    points.emplace_back(Eigen::Map<const Vec3>(array->values.data() + 3 * i));
  }
  return points;
}

std::vector<std::string> ClipArrays::names_between(const std::string& before,
                                                   const std::string& after) const {
  std::vector<std::string> names;
  for (const NpyArray& array : npz_.arrays) {
    const std::string& key = array.name;
    if (key.size() <= before.size() + after.size() || !key.starts_with(before)) continue;
    if (!key.ends_with(after)) continue;
    names.push_back(key.substr(before.size(), key.size() - before.size() - after.size()));
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
  return rotation_of(clip, array, k, matrix_at(array, 9 * k, 3));
}

Pose clip_pose(const ClipArrays& clip, const NpyArray& array, std::size_t k) {
  const Quat turn = rotation_of(clip, array, k, matrix_at(array, 16 * k, 4));
  const double* const first = array.values.data() + 16 * k;
  if (is_known(turn) &&
      !(Eigen::Map<const Eigen::Vector4d>(first + 12).isApprox(Eigen::Vector4d::UnitW(), 1e-6))) {
    clip.fail(array.name, fmt::format("the last row of matrix {} must be 0 0 0 1", k));
  }
  return make_pose(Vec3(first[3], first[7], first[11]), turn);
}

}  // namespace morphe::imports
