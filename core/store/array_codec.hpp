#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// How one value of a plain struct's array lies in a file: `Scalar`, the trailing dimensions, and
/// the copy in and out, bit for bit. Rotations lie as w, x, y, z, poses as row-major 4 x 4.
template <class T>
struct ItemCodec {
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::int32_t> ||
                std::is_same_v<T, std::uint8_t> || std::is_enum_v<T>);
  using Scalar = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>,
                                             std::type_identity<T>>::type;
  static constexpr std::size_t size = 1;
  static Hdf5Shape shape() { return {}; }
  static void encode(const T& value, Scalar* out) { *out = static_cast<Scalar>(value); }
  static void decode(const Scalar* in, T& value) { value = static_cast<T>(*in); }
};

template <class Point>
struct PointCodec {
  using Scalar = typename Point::Scalar;
  static constexpr std::size_t size = 3;
  static Hdf5Shape shape() { return {size}; }
  static void encode(const Point& value, Scalar* out) {
    std::memcpy(out, value.data(), sizeof(Scalar) * size);
  }
  static void decode(const Scalar* in, Point& value) {
    std::memcpy(value.data(), in, sizeof(Scalar) * size);
  }
};
template <>
struct ItemCodec<Vec3> : PointCodec<Vec3> {};
template <>
struct ItemCodec<Eigen::Vector3i> : PointCodec<Eigen::Vector3i> {};

template <>
struct ItemCodec<std::array<int, 2>> {
  using Scalar = std::int32_t;
  static constexpr std::size_t size = 2;
  static Hdf5Shape shape() { return {size}; }
  static void encode(const std::array<int, 2>& value, Scalar* out) {
    out[0] = value[0];
    out[1] = value[1];
  }
  static void decode(const Scalar* in, std::array<int, 2>& value) { value = {in[0], in[1]}; }
};

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

template <class T>
Hdf5Shape with_item_shape(Hdf5Shape shape) {
  for (const std::size_t size : ItemCodec<T>::shape()) shape.push_back(size);
  return shape;
}

/// A whole array: `Scalar`, the shape that a reader asks for, and both ways.
template <class T>
struct ArrayCodec {  // one value
  using Scalar = typename ItemCodec<T>::Scalar;
  static Hdf5Shape shape() { return with_item_shape<T>({}); }
  static Hdf5Array<Scalar> encode(const T& value) {
    Hdf5Array<Scalar> array{shape(), std::vector<Scalar>(ItemCodec<T>::size)};
    ItemCodec<T>::encode(value, array.values.data());
    return array;
  }
  static void decode(const Hdf5Array<Scalar>& array, T& value) {
    ItemCodec<T>::decode(array.values.data(), value);
  }
};

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

template <class T>
struct ArrayCodec<Table<T>> {
  using Scalar = typename ItemCodec<T>::Scalar;
  static Hdf5Shape shape() { return with_item_shape<T>({kAnyLength, kAnyLength}); }
  static Hdf5Array<Scalar> encode(const Table<T>& table) {
    Hdf5Array<Scalar> array = ArrayCodec<std::vector<T>>::encode(table.values);
    array.dims = with_item_shape<T>({table.rows, table.cols});
    return array;
  }
  static void decode(const Hdf5Array<Scalar>& array, Table<T>& table) {
    table.rows = array.dims[0];
    table.cols = array.dims[1];
    Hdf5Array<Scalar> flat = array;
    flat.dims = {table.rows * table.cols};
    ArrayCodec<std::vector<T>>::decode(flat, table.values);
  }
};

template <>
struct ArrayCodec<JointVector> {
  using Scalar = double;
  static Hdf5Shape shape() { return {kAnyLength}; }
  static Hdf5Array<double> encode(const JointVector& vector) {
    return {{static_cast<std::size_t>(vector.size())}, {vector.begin(), vector.end()}};
  }
  static void decode(const Hdf5Array<double>& array, JointVector& vector) {
    vector = Eigen::Map<const JointVector>(array.values.data(),
                                           static_cast<Eigen::Index>(array.values.size()));
  }
};

template <>
struct ArrayCodec<JointRows> {
  using Scalar = double;
  static Hdf5Shape shape() { return {kAnyLength, kAnyLength}; }
  static Hdf5Array<double> encode(const JointRows& rows) {
    return {{static_cast<std::size_t>(rows.rows()), static_cast<std::size_t>(rows.cols())},
            {rows.data(), rows.data() + rows.size()}};
  }
  static void decode(const Hdf5Array<double>& array, JointRows& rows) {
    rows =
        Eigen::Map<const JointRows>(array.values.data(), static_cast<Eigen::Index>(array.dims[0]),
                                    static_cast<Eigen::Index>(array.dims[1]));
  }
};

}  // namespace morphe::store
