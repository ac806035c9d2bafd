#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// Defines how one element of an array is stored in a file, bit for bit: as `size` values of type
/// `Scalar`, which add shape() to the array's dimensions.
template <class T>
struct ItemCodec {
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::int32_t> ||
                std::is_same_v<T, std::uint8_t> || std::is_enum_v<T>);
  using Scalar = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>,
                                             std::type_identity<T>>::type;
  static constexpr std::size_t size = 1;
  /// Returns the dimensions of one element.
  static Hdf5Shape shape() { return {}; }
  /// Converts a value to scalars.
  static void encode(const T& value, Scalar* out) { *out = static_cast<Scalar>(value); }
  /// Converts scalars to a value.
  static void decode(const Scalar* in, T& value) { value = static_cast<T>(*in); }
};

/// The codec of values whose scalars are adjacent in memory.
template <class T, class ScalarType, std::size_t scalar_count>
struct ContiguousCodec {
  using Scalar = ScalarType;
  static constexpr std::size_t size = scalar_count;
  static Hdf5Shape shape() { return {size}; }
  static void encode(const T& value, Scalar* out) {
    std::memcpy(out, value.data(), sizeof(Scalar) * size);
  }
  static void decode(const Scalar* in, T& value) {
    std::memcpy(value.data(), in, sizeof(Scalar) * size);
  }
};
/// The codec of points.
template <>
struct ItemCodec<Vec3> : ContiguousCodec<Vec3, double, 3> {};
/// The codec of triangles.
template <>
struct ItemCodec<Eigen::Vector3i> : ContiguousCodec<Eigen::Vector3i, std::int32_t, 3> {};
/// The codec of pairs of indices.
template <>
struct ItemCodec<std::array<int, 2>> : ContiguousCodec<std::array<int, 2>, std::int32_t, 2> {};

/// The codec of rotations, stored as w, x, y, z.
template <>
struct ItemCodec<Quat> {
  using Scalar = double;
  static constexpr std::size_t size = 4;
  static Hdf5Shape shape() { return {size}; }
  static void encode(const Quat& value, double* out) {
    out[0] = value.w();
    std::memcpy(out + 1, value.coeffs().data(), sizeof(double) * 3);
  }
  static void decode(const double* in, Quat& value) {
    std::memcpy(value.coeffs().data(), in + 1, sizeof(double) * 3);
    value.w() = in[0];
  }
};

/// The codec of poses, stored as row-major 4 x 4 matrices.
template <>
struct ItemCodec<Pose> {
  using Scalar = double;
  static constexpr std::size_t size = 16;
  static Hdf5Shape shape() { return {4, 4}; }
  static void encode(const Pose& value, double* out) {
    for (int row = 0; row < 4; ++row)
      for (int col = 0; col < 4; ++col) out[4 * row + col] = value.matrix()(row, col);
  }
  static void decode(const double* in, Pose& value) {
    for (int row = 0; row < 4; ++row)
      for (int col = 0; col < 4; ++col) value.matrix()(row, col) = in[4 * row + col];
  }
};

/// Appends the dimensions of an element to a shape.
template <class T>
Hdf5Shape with_item_shape(Hdf5Shape shape) {
  for (const std::size_t size : ItemCodec<T>::shape()) shape.push_back(size);
  return shape;
}

/// Defines how a whole array is stored, with elements of type `Scalar`. Arrays that are decoded
/// must have the required shape.
template <class T>
struct ArrayCodec {  // a single value
  using Scalar = typename ItemCodec<T>::Scalar;
  /// Returns the shape that readers require.
  static Hdf5Shape shape() { return with_item_shape<T>({}); }
  /// Converts a value to an array of a file.
  static Hdf5Array<Scalar> encode(const T& value) {
    Hdf5Array<Scalar> array{shape(), std::vector<Scalar>(ItemCodec<T>::size)};
    ItemCodec<T>::encode(value, array.values.data());
    return array;
  }
  /// Converts an array of a file to a value.
  static void decode(const Hdf5Array<Scalar>& array, T& value) {
    ItemCodec<T>::decode(array.values.data(), value);
  }
};

/// The codec of one-dimensional arrays.
template <class T>
struct ArrayCodec<std::vector<T>> {
  using Scalar = typename ItemCodec<T>::Scalar;
  static constexpr std::size_t size = ItemCodec<T>::size;
  static Hdf5Shape shape() { return with_item_shape<T>({kAnyLength}); }
  static Hdf5Array<Scalar> encode(const std::vector<T>& items) {
    Hdf5Array<Scalar> array{with_item_shape<T>({items.size()}),
                            std::vector<Scalar>(items.size() * size)};
    for (std::size_t i = 0; i < items.size(); ++i)
      ItemCodec<T>::encode(items[i], array.values.data() + i * size);
    return array;
  }
  static void decode(const Hdf5Array<Scalar>& array, std::vector<T>& items) {
    items.resize(array.dims[0]);
    for (std::size_t i = 0; i < items.size(); ++i)
      ItemCodec<T>::decode(array.values.data() + i * size, items[i]);
  }
};

/// The codec of two-dimensional arrays.
template <class T>
struct ArrayCodec<Array2D<T>> {
  using Scalar = typename ItemCodec<T>::Scalar;
  static Hdf5Shape shape() { return with_item_shape<T>({kAnyLength, kAnyLength}); }
  static Hdf5Array<Scalar> encode(const Array2D<T>& table) {
    Hdf5Array<Scalar> array = ArrayCodec<std::vector<T>>::encode(table.values);
    array.dims = with_item_shape<T>({table.rows, table.cols});
    return array;
  }
  static void decode(const Hdf5Array<Scalar>& array, Array2D<T>& table) {
    table.rows = array.dims[0];
    table.cols = array.dims[1];
    Hdf5Array<Scalar> flat = array;
    flat.dims = {table.rows * table.cols};
    ArrayCodec<std::vector<T>>::decode(flat, table.values);
  }
};

/// The codec of matrices, which must be row-major in memory as in the file, and of vectors.
template <class Matrix>
struct MatrixCodec {
  using Scalar = double;
  static constexpr int rank = Matrix::IsVectorAtCompileTime ? 1 : 2;
  static Hdf5Shape shape() { return Hdf5Shape(rank, kAnyLength); }
  static Hdf5Array<double> encode(const Matrix& matrix) {
    Hdf5Shape dims(1, matrix.rows());
    if (rank == 2) dims.push_back(matrix.cols());
    return {dims, {matrix.data(), matrix.data() + matrix.size()}};
  }
  static void decode(const Hdf5Array<double>& array, Matrix& matrix) {
    matrix =
        Eigen::Map<const Matrix>(array.values.data(), array.dims[0], rank == 2 ? array.dims[1] : 1);
  }
};
/// The codec of joint vectors.
template <>
struct ArrayCodec<JointVector> : MatrixCodec<JointVector> {};
/// The codec of matrices with one row of joint values per sample.
template <>
struct ArrayCodec<JointRows> : MatrixCodec<JointRows> {};

}  // namespace morphe::store
