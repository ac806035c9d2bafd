#include "stages/import/formats/skeleton_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinAxisCosine = 0.9659258262890683;  // cos 15 degrees
// Least horizontal share of the shoulder line in the first frame.
constexpr double kMinShoulderLevelShare = 0.7;

[[noreturn]] void throw_unknown_axes(const std::string& file, const std::string& why) {
  throw UnresolvedConvention(
      "axes", fmt::format("{}: axes: the file does not state which axes point "
                          "right, forward and up, and {}; give --axes or `axes:` such as 'x y z'",
                          file, why));
}

/// Returns the signed coordinate axis with the largest component along a direction.
Vec3 main_axis(const Vec3& direction) {
  Eigen::Index which = 0;
  direction.cwiseAbs().maxCoeff(&which);
  Vec3 axis = Vec3::Zero();
  axis[which] = direction[which] < 0 ? -1 : 1;
  return axis;
}

Vec3 near_axis(const Vec3& direction, const std::string& what, const std::string& file) {
  const Vec3 axis = main_axis(direction);
  if (!(axis.dot(direction) >= kMinAxisCosine * direction.norm()) || direction.norm() == 0) {
    throw_unknown_axes(
        file, fmt::format("in the rest skeleton {} is not within 15 degrees of an axis", what));
  }
  return axis;
}

struct Pair {
  std::size_t left, right;
};
std::optional<Pair> find_pair(const BodyStream& body, const std::string& part) {
  const auto left = std::find(body.names.begin(), body.names.end(), "left_" + part);
  const auto right = std::find(body.names.begin(), body.names.end(), "right_" + part);
  if (left == body.names.end() || right == body.names.end()) return std::nullopt;
  return Pair{static_cast<std::size_t>(left - body.names.begin()),
              static_cast<std::size_t>(right - body.names.begin())};
}

}  // namespace

Eigen::Matrix3d world_from_skeleton(const BodyStream& body, const std::vector<Vec3>& rest,
                                    const std::string& file, std::vector<std::string>& reports) {
  const std::optional<Pair> shoulders = find_pair(body, "shoulder"), hips = find_pair(body, "hip");
  if (!shoulders) {
    throw_unknown_axes(file,
                       "the axes cannot be derived, since no joints are named left_shoulder and "
                       "right_shoulder (see --names)");
  }
  const auto trunk = [&](const Vec3& root, const Vec3& left, const Vec3& right) -> Vec3 {
    return (left + right) / 2 - root;
  };
  const Vec3 up = near_axis(trunk(rest[0], rest[shoulders->left], rest[shoulders->right]),
                            "the trunk (root to shoulders)", file);
  Vec3 recorded_trunk = Vec3::Zero();
  for (std::size_t i = 0; i < body.position.rows; ++i) {
    recorded_trunk += trunk(body.position(i, 0), body.position(i, shoulders->left),
                            body.position(i, shoulders->right))
                          .normalized();
  }
  if (main_axis(recorded_trunk) != up) {
    throw_unknown_axes(
        file,
        fmt::format("the trunk points along {} in the rest skeleton, but along {} in the recording",
                    axis_word(up), axis_word(main_axis(recorded_trunk))));
  }
  Vec3 line = rest[shoulders->right] - rest[shoulders->left];
  const bool by_hips = line.norm() == 0 && hips;
  if (by_hips) line = rest[hips->right] - rest[hips->left];
  const Vec3 right = near_axis(line, "the line from left to right", file);
  if (right.dot(up) != 0)
    throw_unknown_axes(file, "in the rest skeleton trunk and shoulders are along the same axis");
  const Vec3 forward = up.cross(right);
  Eigen::Matrix3d world;
  world << right.transpose(), forward.transpose(), up.transpose();

  const Vec3 first =
      world * (body.position(0, shoulders->right) - body.position(0, shoulders->left));
  const double level = std::hypot(first.x(), first.y());
  if (!(level > kMinShoulderLevelShare * first.norm())) {
    throw_unknown_axes(file, "the line between the shoulders is not horizontal in the first frame");
  }
  reports.push_back(
      fmt::format("axes derived from the rest skeleton: '{} {} {}' (right, forward, up)",
                  axis_word(right), axis_word(forward), axis_word(up)));
  return world;
}

}  // namespace morphe::imports
