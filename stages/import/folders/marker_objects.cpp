#include "stages/import/folders/marker_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/rigid.hpp"
#include "core/math/rotation.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

/// Least extent of a box of markers, which has no thickness if they are in one plane [m].
constexpr double kMinMarkerBoxSize_m = 0.001;
constexpr std::size_t kSizes[] = {1, 3, 2, 2, 0};  // number of sizes of each shape

[[noreturn]] void fail(const std::string& file, const MarkerObject& object,
                       const std::string& message) {
  throw InputError(fmt::format("{}: objects: {}: {}", file, object.name, message));
}

std::vector<std::size_t> columns_of(const std::string& file, const MarkerObject& object,
                                    const std::vector<std::string>& names) {
  std::vector<std::size_t> columns;
  for (const std::string& wanted : object.markers) {
    const bool prefix = wanted.ends_with('*');
    const std::string stem = wanted.substr(0, wanted.size() - (prefix ? 1 : 0));
    const std::size_t before = columns.size();
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (prefix ? names[k].starts_with(stem) : names[k] == stem) columns.push_back(k);
    }
    if (columns.size() == before) fail(file, object, fmt::format("marker '{}' not found", wanted));
  }
  std::ranges::sort(columns);
  // clang 14 cannot compile the ranges::unique of g++ 12's library.
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

using Points = std::vector<Vec3>;

bool is_finite_pose(const Pose& pose) { return pose.matrix().allFinite(); }

/// Returns the mean of the frames' points, each frame transformed to `reference`; NaN for points
/// that were never seen.
Points mean_shape(const std::vector<Points>& frames, const Points& reference) {
  Points sum(reference.size(), Vec3::Zero());
  std::vector<int> count(reference.size(), 0);
  for (const Points& frame : frames) {
    const Pose reference_from_frame = math::fit_rigid_transform(frame, reference);
    if (!is_finite_pose(reference_from_frame)) continue;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      if (!is_known(frame[k])) continue;
      sum[k] += reference_from_frame * frame[k];
      ++count[k];
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = count[k] > 0 ? Vec3(sum[k] / count[k]) : unknown_point();
  }
  return sum;
}

/// Returns the principal axes as columns, permuted and signed to be nearest to x, y and z;
/// right-handed.
Eigen::Matrix3d object_axes(const Points& shape) {
  Vec3 mean = Vec3::Zero();
  double count = 0;
  for (const Vec3& point : shape) {
    if (!is_known(point)) continue;
    mean += point;
    ++count;
  }
  mean /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : shape) {
    if (is_known(point)) spread += (point - mean) * (point - mean).transpose();
  }
  const Eigen::Matrix3d principal = math::principal_axes(spread).axes;
  int order[] = {0, 1, 2};
  Eigen::Matrix3d best = principal;
  double nearest = -1;
  do {
    Eigen::Matrix3d axes;
    for (int i = 0; i < 3; ++i) {
      axes.col(i) = principal.col(order[i]);
      if (axes(i, i) < 0) axes.col(i) *= -1;
    }
    if (axes.determinant() > 0 && axes.trace() > nearest) {
      best = axes;
      nearest = axes.trace();
    }
  } while (std::next_permutation(std::begin(order), std::end(order)));
  return best;
}

}  // namespace

std::string validation_error(const MarkerObject& object) {
  const std::optional<Shape> shape = enum_from_name<Shape>(object.shape);
  if (!shape || *shape == Shape::mesh) {
    return fmt::format("shape must be sphere, box, cylinder or capsule, not '{}'", object.shape);
  }
  if (object.size.empty()) {
    return shape == Shape::box ? "" : fmt::format("a {} needs a size", object.shape);
  }
  const std::size_t wanted = kSizes[static_cast<std::size_t>(*shape)];
  if (object.size.size() != wanted ||
      std::ranges::any_of(object.size, [](double length) { return !(length > 0); })) {
    return fmt::format("the size of a {} must be {} positive lengths", object.shape, wanted);
  }
  return "";
}

void add_marker_object(const std::string& file, const MarkerObject& object,
                       Demonstration& demonstration) {
  if (!demonstration.streams.markers) fail(file, object, "the recording has no markers");
  const MarkerStream& markers = *demonstration.streams.markers;
  const std::vector<std::size_t> columns = columns_of(file, object, markers.names);
  std::vector<Points> frames;
  std::size_t fullest = 0, most = 0;
  for (std::size_t i = 0; i < markers.time.size(); ++i) {
    Points& points = frames.emplace_back();
    for (const std::size_t k : columns) points.push_back(markers.position(i, k));
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(points, [](const Vec3& point) { return is_known(point); }));
    if (count > most) {
      most = count;
      fullest = i;
    }
  }
  if (most == 0 || !is_finite_pose(math::fit_rigid_transform(frames[fullest], frames[fullest]))) {
    fail(file, object, "in no frame are three of its markers visible that are not on a line");
  }
  Points shape = mean_shape(frames, frames[fullest]);
  const Eigen::Matrix3d axes = object_axes(shape);
  Eigen::AlignedBox3d extent;
  for (Vec3& point : shape) {
    point = axes.transpose() * point;
    if (is_known(point)) extent.extend(point);
  }
  for (Vec3& point : shape) point -= extent.center();

  SceneObject body;
  body.name = object.name;
  body.shape = enum_from_name<Shape>(object.shape).value_or(Shape::box);
  body.size = object.size;
  if (body.size.empty()) {
    const Vec3 sizes = extent.sizes();
    if (sizes.minCoeff() < kMinMarkerBoxSize_m)
      fail(file, object, "its markers are in one plane; give its size");
    body.size = {sizes.x(), sizes.y(), sizes.z()};
  }
  double squares = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Pose world_from_body = math::fit_rigid_transform(shape, frames[i]);
    if (!is_finite_pose(world_from_body)) continue;
    body.time.push_back(markers.time[i]);
    body.position.push_back(world_from_body.translation());
    body.orientation.push_back(Quat(world_from_body.linear()).normalized());
    const double residual = math::rigid_residual(world_from_body, shape, frames[i]);
    squares += residual * residual;
  }
  const auto poses = static_cast<double>(body.time.size());
  std::string report =
      fmt::format("{}: from {}, RMS deviation from a rigid body {:.1f} mm", object.name,
                  count_with_noun(columns.size(), "marker"), 1000 * std::sqrt(squares / poses));
  if (body.time.size() < frames.size()) {
    report += fmt::format("; not visible in {} of {} frames", frames.size() - body.time.size(),
                          frames.size());
  }
  demonstration.import_notes.push_back(report);
  demonstration.objects.push_back(std::move(body));
}

}  // namespace morphe::imports
