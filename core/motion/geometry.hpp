#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace morphe {

using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;  ///< unit norm; files hold w, x, y, z
using Pose = Eigen::Isometry3d;   ///< named target_from_source
using JointVector = Eigen::VectorXd;
/// Joint values along a movement, [samples, joints], a row per sample.
using JointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The library and its users hand these to each other, each compiled for a processor of its own: how
// they lie in memory and how the heap is asked for them must not depend on it.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MALLOC_ALREADY_ALIGNED == 0 &&
                  alignof(Quat) == 16 && !Eigen::Matrix3d::IsRowMajor,
              "compile with -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=0, as Morphe "
              "was, and Eigen's other defaults; CMake's target Morphe::morphe does");

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kDegree = std::numbers::pi / 180;  ///< [rad]

/// What was not seen is NaN, in memory as in the files.
inline constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();
inline Vec3 unseen_point() { return Vec3::Constant(kNotSeen); }
inline Quat unseen_rotation() { return Quat(kNotSeen, kNotSeen, kNotSeen, kNotSeen); }
inline bool seen(const Vec3& point) { return point.allFinite(); }
inline bool seen(const Quat& rotation) { return rotation.coeffs().allFinite(); }

/// A dense two-dimensional array of points or rotations, row-major.
template <class T>
struct Table {
  std::size_t rows = 0, cols = 0;
  std::vector<T> values;  ///< [rows * cols]

  Table() = default;
  Table(std::size_t row_count, std::size_t col_count, const T& value)
      : rows(row_count), cols(col_count), values(row_count * col_count, value) {}
  T& operator()(std::size_t row, std::size_t col) { return values[row * cols + col]; }
  const T& operator()(std::size_t row, std::size_t col) const { return values[row * cols + col]; }
};

inline Pose make_pose(const Vec3& position, const Quat& orientation) {
  Pose pose = Pose::Identity();
  pose.translation() = position;
  pose.linear() = orientation.toRotationMatrix();
  return pose;
}

/// Rotation angle between two orientations, 2 acos|<a, b>| in [0, pi] [rad]: the full angle.
inline double angle_between(const Quat& a, const Quat& b) { return a.angularDistance(b); }

}  // namespace morphe
