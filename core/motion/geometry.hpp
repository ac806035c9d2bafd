#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace morphe {

/// A point or vector.
using Vec3 = Eigen::Vector3d;
/// A rotation as a quaternion of unit norm; files hold it as w, x, y, z.
using Quat = Eigen::Quaterniond;
/// A rigid transformation; variables are named target_from_source.
using Pose = Eigen::Isometry3d;
/// One value per joint [rad or m].
using JointVector = Eigen::VectorXd;
/// Joint values along a movement, [samples, joints], one row per sample.
using JointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Matrices are passed between the library and its users, which may be compiled for different
// processors. Their memory layout and allocation must not depend on the processor.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MALLOC_ALREADY_ALIGNED == 0 &&
                  alignof(Quat) == 16 && !Eigen::Matrix3d::IsRowMajor,
              "compile with -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=0, as Morphe "
              "was, and Eigen's other defaults; CMake's target Morphe::morphe does");

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kRadPerDegree = std::numbers::pi / 180;
inline constexpr double kMillimetresPerMetre = 1e3;
inline constexpr double kGravity_m_s2 = 9.81;

/// The value of quantities that were not observed, in memory and in files: NaN.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// Returns a point whose coordinates are all NaN.
inline Vec3 unknown_point() { return Vec3::Constant(kUnknown); }
/// Returns a quaternion whose coefficients are all NaN.
inline Quat unknown_rotation() { return Quat(kUnknown, kUnknown, kUnknown, kUnknown); }
/// Returns true if the point is finite, that is, was observed.
inline bool is_known(const Vec3& point) { return point.allFinite(); }
/// Returns true if the rotation is finite, that is, was observed.
inline bool is_known(const Quat& rotation) { return rotation.coeffs().allFinite(); }

/// A dense two-dimensional array of points or rotations in row-major order.
template <class T>
struct Array2D {
  std::size_t rows = 0, cols = 0;
  std::vector<T> values;  ///< [rows * cols]

  Array2D() = default;
  /// Makes an array with all elements equal to `value`.
  Array2D(std::size_t row_count, std::size_t col_count, const T& value)
      : rows(row_count), cols(col_count), values(row_count * col_count, value) {}
  /// Returns an element.
  T& operator()(std::size_t row, std::size_t col) { return values[row * cols + col]; }
  /// Returns an element.
  const T& operator()(std::size_t row, std::size_t col) const { return values[row * cols + col]; }
};

/// Returns the rigid transformation with this translation and rotation.
inline Pose make_pose(const Vec3& position, const Quat& orientation) {
  Pose pose = Pose::Identity();
  pose.translation() = position;
  pose.linear() = orientation.toRotationMatrix();
  return pose;
}

/// Returns the full rotation angle between two orientations, 2 acos|<a, b>| in [0, pi] [rad].
inline double angle_between(const Quat& a, const Quat& b) { return a.angularDistance(b); }

}  // namespace morphe
