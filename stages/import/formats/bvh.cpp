// BVH: the skeleton with its rest pose and channels, then a row of channel values per frame. The
// file contains neither unit nor axes.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/bvh_file.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/formats/skeleton_axes.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {
namespace {

struct PlausibleRange {
  double min, max;

  bool contains(double value) const { return value >= min && value <= max; }
};
/// For the time between two frames; the farthest joint's distance from the root, of a body and of a
/// skeleton that may be a hand alone (a small child's is 0.1 m long); the upper arm.
constexpr PlausibleRange kFramePeriodRange_s{1e-5, 10}, kBodyExtentRange_m{0.2, 3.0},
    kHandExtentRange_m{0.07, 3.0}, kUpperArmRange_m{0.15, 0.5};

BodyStream skeleton_names(const BvhFile& bvh, const RecordingFiles& files) {
  BodyStream body;
  for (const BvhJoint& joint : bvh.joints) body.names.push_back(joint.name);
  apply_name_map(bvh.text.file, files.name_map, body.names);
  for (const BvhJoint& joint : bvh.joints)
    body.parents.push_back(joint.parent < 0 ? "" : body.names[joint.parent]);
  return body;
}

/// Returns true unless there are joints of a trunk or an arm.
bool may_be_hand_alone(const std::vector<std::string>& names) {
  return std::ranges::none_of(names, [](const std::string& name) {
    return name.ends_with("_shoulder") || name.ends_with("_elbow") || name.ends_with("_hip");
  });
}

void check_size(const BvhFile& bvh, const std::vector<std::string>& names,
                const std::vector<Vec3>& rest) {
  const auto check = [&](const std::string& what, double length, const PlausibleRange& plausible) {
    if (plausible.contains(length)) return;
    throw UnresolvedConvention("unit", fmt::format("{}: unit: implausible: {} would be {:.3g} m",
                                                   bvh.text.file, what, length));
  };
  double extent = 0;
  for (const Vec3& point : rest) extent = std::max(extent, (point - rest[0]).norm());
  check("the distance of the farthest joint from the root", extent,
        may_be_hand_alone(names) ? kHandExtentRange_m : kBodyExtentRange_m);
  for (const std::string side : {"right_", "left_"}) {
    const int shoulder = name_index(names, side + "shoulder");
    const int elbow = name_index(names, side + "elbow");
    if (shoulder < 0 || elbow < 0) continue;
    check("the upper arm", (rest[elbow] - rest[shoulder]).norm(), kUpperArmRange_m);
  }
}

double frame_rate(const BvhFile& bvh, const Conventions& conventions,
                  std::vector<std::string>& reports) {
  const bool plausible = kFramePeriodRange_s.contains(bvh.frame_s);
  if (!plausible && !conventions.rate_hz) {
    throw UnresolvedConvention(
        "rate", fmt::format("{}:{}: Frame Time: {} s is implausible; give --rate or `rate_hz:`",
                            bvh.text.file, bvh.frame_time_line, bvh.frame_s));
  }
  return resolve_rate_hz(plausible ? 1 / bvh.frame_s : 0, conventions, bvh.text.file, reports);
}

/// Returns true if the first frame is a rest pose, as some programs write it: to the second frame,
/// a joint turns by at least 30 degrees and three times the largest turn between later frames.
bool starts_with_rest_pose(const BodyStream& body) {
  constexpr double kMinPoseJump_rad = 30 * M_PI / 180, kMinPoseJumpRatio = 3;
  const auto max_angle_to_next = [&](std::size_t row) {
    double max_rad = 0;
    for (std::size_t j = 0; j < body.names.size(); ++j) {
      const double angle_rad =
          angle_between(body.orientation(row, j), body.orientation(row + 1, j));
      max_rad = std::max(max_rad, angle_rad);
    }
    return max_rad;
  };
  if (body.time.size() < 3) return false;
  const double first_jump_rad = max_angle_to_next(0);
  if (first_jump_rad < kMinPoseJump_rad) return false;
  for (std::size_t row = 1; row + 1 < body.time.size(); ++row) {
    if (max_angle_to_next(row) * kMinPoseJumpRatio > first_jump_rad) return false;
  }
  return true;
}

template <class T>
void drop_first_row(Array2D<T>& array) {
  array.values.erase(array.values.begin(), array.values.begin() + array.cols);
  --array.rows;
}

void report_file(const BvhFile& bvh, std::vector<std::string>& reports) {
  if (bvh.rows.rows() != bvh.declared_frame_count) {
    add_note(reports, "'Frames:' is {}, but the file has {} frames; all are used",
             bvh.declared_frame_count, bvh.rows.rows());
  }
  const BvhJoint& root = bvh.joints[0];
  const bool moves = std::ranges::any_of(root.channels, [](const auto& c) { return !c.rotates; });
  if (moves && root.offset.norm() > 0) {
    add_note(reports,
             "the position channels of the root replace its OFFSET ({} {} {}), which is not added",
             root.offset.x(), root.offset.y(), root.offset.z());
  }
}

}  // namespace

bool recognises_bvh(std::string_view head) {
  const std::size_t begin = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  constexpr std::string_view kFirstWord = "hierarchy";
  return std::ranges::equal(head.substr(begin, kFirstWord.size()), kFirstWord, [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

Demonstration read_bvh(const RecordingFiles& files) {
  const BvhFile bvh = read_bvh_file(files.file);
  if (!files.static_trial.empty())
    throw InputError(bvh.text.file + ": static_trial: this format has no static trial");
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = bvh.text.notes;
  report_file(bvh, reports);
  const double rate_hz = frame_rate(bvh, files.conventions, reports);
  const double metres = resolve_unit_m("", files.conventions, bvh.text.file, reports);

  BodyStream body = skeleton_names(bvh, files);
  BvhPoses poses;
  bvh_forward_kinematics(bvh, nullptr, poses);
  for (Vec3& point : poses.position) point *= metres;
  const std::vector<Vec3> rest = poses.position;
  if (files.conventions.plausibility_checks) check_size(bvh, body.names, rest);

  body.position = Array2D<Vec3>(bvh.rows.rows(), bvh.joints.size(), unknown_point());
  body.orientation = Array2D<Quat>(bvh.rows.rows(), bvh.joints.size(), unknown_rotation());
  for (Eigen::Index i = 0; i < bvh.rows.rows(); ++i) {
    body.time.push_back(static_cast<double>(i) / rate_hz);
    bvh_forward_kinematics(bvh, bvh.rows.row(i).data(), poses);
    for (std::size_t j = 0; j < bvh.joints.size(); ++j) {
      body.position(i, j) = metres * poses.position[j];
      body.orientation(i, j) = poses.orientation[j];
    }
  }
  if (starts_with_rest_pose(body)) {
    body.time.erase(body.time.begin());
    drop_first_row(body.position);
    drop_first_row(body.orientation);
    reports.push_back(
        "first frame skipped: it is a rest pose, from which the joints jump to the second frame");
  }
  const std::string& axes = files.conventions.axes;
  const Eigen::Matrix3d rotation = axes.empty()
                                       ? world_from_skeleton(body, rest, bvh.text.file, reports)
                                       : world_from_recorded(axes, bvh.text.file);
  const Quat world_from_file(rotation);
  for (Vec3& point : body.position.values) point = rotation * point;
  for (Quat& pose : body.orientation.values) pose = (world_from_file * pose).normalized();
  demonstration.streams.skeleton = std::move(body);
  return demonstration;
}

}  // namespace morphe::imports
