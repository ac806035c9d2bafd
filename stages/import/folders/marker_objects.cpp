#include "stages/import/folders/marker_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/files/item_name.hpp"
#include "core/math/rigid.hpp"
#include "core/math/rotation.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {
namespace {

/// Least thickness of a box around markers; markers in one plane do not determine it.
constexpr double kMinMarkerBoxSize_m = 0.001;

[[noreturn]] void fail(const std::string& file, const MarkerObject& object,
                       const std::string& message) {
  throw InputError(fmt::format("{}: objects: {}: {}", file, object.name, message));
}

std::vector<int> columns_of(const std::string& file, const MarkerObject& object,
                            const std::vector<std::string>& names) {
  std::vector<int> columns;
  for (const std::string& marker : object.markers) {
    const bool prefix = marker.ends_with('*');
    const std::string stem = marker.substr(0, marker.size() - (prefix ? 1 : 0));
    const std::size_t before = columns.size();
    for (int k = 0; k < std::ssize(names); ++k) {
      if (prefix ? names[k].starts_with(stem) : names[k] == stem) columns.push_back(k);
    }
    if (columns.size() == before) fail(file, object, fmt::format("marker '{}' not found", marker));
  }
  std::ranges::sort(columns);
  // clang 14 cannot compile the ranges::unique of g++ 12's library.
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

using Points = std::vector<Vec3>;

bool is_finite_pose(const Pose& pose) { return pose.matrix().allFinite(); }

/// Returns the mean position of each point over the frames, which are rigidly fitted to
/// `reference`; NaN for a point that was never seen in a frame that can be fitted.
Points mean_shape(const std::vector<Points>& frames, const Points& reference) {
  Points sum(reference.size(), Vec3::Zero());
  std::vector<int> count(reference.size(), 0);
  for (const Points& frame : frames) {
    const Pose reference_from_frame = math::fit_rigid_transform(frame, reference);
    if (!is_finite_pose(reference_from_frame)) continue;
    for (int k = 0; k < std::ssize(frame); ++k) {
      if (!is_known(frame[k])) continue;
      sum[k] += reference_from_frame * frame[k];
      ++count[k];
    }
  }
  for (int k = 0; k < std::ssize(sum); ++k)
    sum[k] = count[k] > 0 ? Vec3(sum[k] / count[k]) : unknown_point();
  return sum;
}

/// Returns the principal axes as the columns of the rotation that is nearest to the identity.
Eigen::Matrix3d object_axes(const Points& shape) {
  const Eigen::Matrix3d principal = math::principal_axes(scatter_of(shape)).axes;
  int order[] = {0, 1, 2};
  Eigen::Matrix3d nearest_axes = principal;
  double max_trace = -1;
  do {
    Eigen::Matrix3d axes;
    for (int i = 0; i < 3; ++i) {
      axes.col(i) = principal.col(order[i]);
      if (axes(i, i) < 0) axes.col(i) *= -1;
    }
    if (axes.determinant() > 0 && axes.trace() > max_trace) {
      nearest_axes = axes;
      max_trace = axes.trace();
    }
  } while (std::next_permutation(std::begin(order), std::end(order)));
  return nearest_axes;
}

}  // namespace

std::string validation_error(const MarkerObject& object) {
  if (!files::is_item_name(object.name)) return fmt::format("name: {}", files::kItemNameError);
  const std::optional<Shape> shape = enum_from_name<Shape>(object.shape);
  if (!shape || *shape == Shape::mesh)
    return fmt::format("shape must be sphere, box, cylinder or capsule, not '{}'", object.shape);
  if (object.size.empty())
    return shape == Shape::box ? "" : fmt::format("a {} needs a size", object.shape);
  const std::size_t count = shape == Shape::sphere ? 1 : shape == Shape::box ? 3 : 2;
  if (object.size.size() != count)
    return fmt::format("the size of a {} must be {}", object.shape,
                       count_with_noun(count, "length"));
  return "";
}

void add_marker_object(const std::string& file, const MarkerObject& object,
                       Demonstration& demonstration) {
  if (!demonstration.streams.markers) fail(file, object, "the recording has no markers");
  const MarkerStream& markers = *demonstration.streams.markers;
  const std::vector<int> columns = columns_of(file, object, markers.names);
  std::vector<Points> frames;
  int reference = 0;
  std::ptrdiff_t max_seen_count = 0;
  for (int i = 0; i < std::ssize(markers.time); ++i) {
    Points& points = frames.emplace_back();
    for (const int k : columns) points.push_back(markers.position(i, k));
    const auto seen_count =
        std::ranges::count_if(points, [](const Vec3& point) { return is_known(point); });
    if (seen_count > max_seen_count) {
      max_seen_count = seen_count;
      reference = i;
    }
  }
  if (max_seen_count == 0 ||
      !is_finite_pose(math::fit_rigid_transform(frames[reference], frames[reference])))
    fail(file, object, "in no frame are three of its markers visible that are not on a line");
  Points shape = mean_shape(frames, frames[reference]);
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
  double square_sum = 0;
  for (int i = 0; i < std::ssize(frames); ++i) {
    const Pose world_from_body = math::fit_rigid_transform(shape, frames[i]);
    if (!is_finite_pose(world_from_body)) continue;
    body.time.push_back(markers.time[i]);
    body.position.push_back(world_from_body.translation());
    body.orientation.push_back(Quat(world_from_body.linear()).normalized());
    const double residual = math::rigid_residual(world_from_body, shape, frames[i]);
    square_sum += residual * residual;
  }
  const auto pose_count = static_cast<double>(body.time.size());
  std::string report = fmt::format("{}: from {}, RMS deviation from a rigid body {:.1f} mm",
                                   object.name, count_with_noun(columns.size(), "marker"),
                                   1000 * std::sqrt(square_sum / pose_count));
  if (body.time.size() < frames.size()) {
    report += fmt::format("; not visible in {} of {} frames", frames.size() - body.time.size(),
                          frames.size());
  }
  demonstration.import_notes.push_back(report);
  demonstration.objects.push_back(std::move(body));
}

}  // namespace morphe::imports
