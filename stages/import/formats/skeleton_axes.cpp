#include "stages/import/formats/skeleton_axes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinAxisCosine = 0.9659258262890683;  // cos 15 degrees
/// Least ratio of the horizontal part of the line between the shoulders to its length.
constexpr double kMinShoulderLevelRatio = 0.7;
/// Most programs write Y up and a person who faces Z.
constexpr const char* kUsualAxes = "-x z y";

/// Returns the signed coordinate axis with the largest component along a direction.
Vec3 main_axis(const Vec3& direction) {
  Eigen::Index k = 0;
  direction.cwiseAbs().maxCoeff(&k);
  Vec3 axis = Vec3::Zero();
  axis[k] = direction[k] < 0 ? -1 : 1;
  return axis;
}

/// Returns the axis within 15 degrees of a direction. `noun` is the direction's name in the error.
Vec3 near_axis(const Vec3& direction, const std::string& noun, const std::string& file) {
  const Vec3 axis = main_axis(direction);
  if (!(axis.dot(direction) >= kMinAxisCosine * direction.norm()) || direction.norm() == 0) {
    throw_unknown_axes(
        file,
        fmt::format(", and in the rest skeleton {} is not within 15 degrees of an axis", noun));
  }
  return axis;
}

struct JointPair {
  int left, right;
};

std::optional<JointPair> find_pair(const BodyStream& body, const std::string& part) {
  const JointPair pair{name_index(body.names, "left_" + part),
                       name_index(body.names, "right_" + part)};
  return pair.left < 0 || pair.right < 0 ? std::nullopt : std::optional(pair);
}

}  // namespace

Eigen::Matrix3d world_from_skeleton(const BodyStream& body, const std::vector<Vec3>& rest,
                                    const std::string& file, std::vector<std::string>& reports) {
  const std::optional<JointPair> shoulders = find_pair(body, "shoulder");
  const std::optional<JointPair> hips = find_pair(body, "hip");
  if (!shoulders) {
    throw_unknown_axes(file,
                       ", and the axes cannot be derived, since no joints are named left_shoulder "
                       "and right_shoulder (see --names)",
                       kUsualAxes);
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
        fmt::format(
            ", and the trunk points along {} in the rest skeleton, but along {} in the recording",
            axis_word(up), axis_word(main_axis(recorded_trunk))));
  }
  Vec3 left_to_right = rest[shoulders->right] - rest[shoulders->left];
  if (left_to_right.norm() == 0 && hips) left_to_right = rest[hips->right] - rest[hips->left];
  const Vec3 right = near_axis(left_to_right, "the line from left to right", file);
  if (right.dot(up) != 0)
    throw_unknown_axes(file,
                       ", and in the rest skeleton trunk and shoulders are along the same axis");
  const Vec3 forward = up.cross(right);
  Eigen::Matrix3d world;
  world << right.transpose(), forward.transpose(), up.transpose();

  const Vec3 first_line =
      world * (body.position(0, shoulders->right) - body.position(0, shoulders->left));
  const double horizontal = std::hypot(first_line.x(), first_line.y());
  if (!(horizontal > kMinShoulderLevelRatio * first_line.norm())) {
    throw_unknown_axes(file,
                       ", and the line between the shoulders is not horizontal in the first frame");
  }
  add_note(reports, "axes derived from the rest skeleton: '{} {} {}' (right, forward, up)",
           axis_word(right), axis_word(forward), axis_word(up));
  return world;
}

}  // namespace morphe::imports
