#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::store {

/// Equality down to the bits: NaN equals NaN, 0 does not equal -0.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const std::string& a, const std::string& b) { return a == b; }
template <class T>
requires std::is_integral_v<T> || std::is_enum_v<T>
bool same_bits(T a, T b) { return a == b; }
template <class Derived>
bool same_bits(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Eigen::Index row = 0; row < a.rows(); ++row)
    for (Eigen::Index col = 0; col < a.cols(); ++col)
      if (!same_bits(a(row, col), b(row, col))) return false;
  return true;
}
inline bool same_bits(const Quat& a, const Quat& b) { return same_bits(a.coeffs(), b.coeffs()); }
inline bool same_bits(const Pose& a, const Pose& b) { return same_bits(a.matrix(), b.matrix()); }
template <class T>
bool same_bits(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same_bits(*a, *b));
}
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same_bits(a[i], b[i])) return false;
  return true;
}
template <class T>
bool same_bits(const Array2D<T>& a, const Array2D<T>& b) {
  return a.rows == b.rows && a.cols == b.cols && same_bits(a.values, b.values);
}

}  // namespace morphe::store

/// One member of two structs `a` and `b`.
#define EXPECT_SAME(member) EXPECT_TRUE(same_bits(a.member, b.member)) << #member
