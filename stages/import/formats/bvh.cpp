// BVH: the skeleton with its rest pose and channels, then a row of channel values per frame. The
// file contains neither unit nor axes.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/bvh_file.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/formats/skeleton_axes.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {
namespace {

/// Plausible ranges of the time between two frames [s], and of body lengths in the assumed unit
/// [m]: from the root to its farthest joint, and the upper arm.
struct PlausibleRange {
  double min, max;
};
constexpr PlausibleRange kFramePeriodRange_s{1e-5, 10}, kSkeletonExtentRange_m{0.2, 3.0},
    kUpperArmRange_m{0.15, 0.5};

BodyStream skeleton_names(const BvhFile& bvh, const RecordingFiles& files) {
  BodyStream body;
  for (const BvhJoint& joint : bvh.joints) body.names.push_back(joint.name);
  apply_name_map(bvh.text.file, files.name_map, body.names);
  for (const BvhJoint& joint : bvh.joints) {
    body.parents.push_back(joint.parent < 0 ? "" : body.names[joint.parent]);
  }
  return body;
}

void check_size(const BvhFile& bvh, const std::vector<std::string>& names,
                const std::vector<Vec3>& rest) {
  const auto check = [&](const std::string& what, double length, const PlausibleRange& plausible) {
    if (length >= plausible.min && length <= plausible.max) return;
    throw UnresolvedConvention("unit", fmt::format("{}: unit: implausible: {} would be {:.3g} m",
                                                   bvh.text.file, what, length));
  };
  double extent = 0;
  for (const Vec3& point : rest) extent = std::max(extent, (point - rest[0]).norm());
  check("the distance of the farthest joint from the root", extent, kSkeletonExtentRange_m);
  const auto find = [&](const char* name) { return std::find(names.begin(), names.end(), name); };
  for (const auto& [shoulder, elbow] : {std::pair(find("right_shoulder"), find("right_elbow")),
                                        std::pair(find("left_shoulder"), find("left_elbow"))}) {
    if (shoulder == names.end() || elbow == names.end()) continue;
    const Vec3 upper_arm = rest[elbow - names.begin()] - rest[shoulder - names.begin()];
    check("the upper arm", upper_arm.norm(), kUpperArmRange_m);
  }
}

double frame_rate(const BvhFile& bvh, const Conventions& conventions,
                  std::vector<std::string>& reports) {
  const bool plausible =
      bvh.frame_s >= kFramePeriodRange_s.min && bvh.frame_s <= kFramePeriodRange_s.max;
  if (!plausible && !conventions.rate_hz) {
    throw UnresolvedConvention(
        "rate", fmt::format("{}:{}: Frame Time: {} s is implausible; give --rate or `rate_hz:`",
                            bvh.text.file, bvh.frame_time_line, bvh.frame_s));
  }
  return resolve_rate_hz(plausible ? 1 / bvh.frame_s : 0, conventions, bvh.text.file, reports);
}

/// Returns true if the first frame is not part of the recording: some programs write the rest pose
/// there. A joint turns by more than 30 degrees to the next frame, and by more than three times the
/// largest turn between later frames.
bool starts_with_rest_pose(const BodyStream& body) {
  constexpr double kMinPoseJump_rad = 30 * M_PI / 180, kMinPoseJumpRatio = 3;
  const auto most = [&](std::size_t row) {
    double turned = 0;
    for (std::size_t j = 0; j < body.names.size(); ++j) {
      turned =
          std::max(turned, angle_between(body.orientation(row, j), body.orientation(row + 1, j)));
    }
    return turned;
  };
  if (body.time.size() < 3) return false;
  const double first = most(0);
  if (first < kMinPoseJump_rad) return false;
  for (std::size_t row = 1; row + 1 < body.time.size(); ++row) {
    if (most(row) * kMinPoseJumpRatio > first) return false;
  }
  return true;
}

void drop_first_frame(BodyStream& body) {
  const auto joints = static_cast<std::ptrdiff_t>(body.names.size());
  body.time.erase(body.time.begin());
  body.position.values.erase(body.position.values.begin(), body.position.values.begin() + joints);
  body.orientation.values.erase(body.orientation.values.begin(),
                                body.orientation.values.begin() + joints);
  --body.position.rows;
  --body.orientation.rows;
}

void report_file(const BvhFile& bvh, std::vector<std::string>& reports) {
  const auto frames = static_cast<std::size_t>(bvh.rows.rows());
  if (frames != bvh.declared_frame_count) {
    reports.push_back(fmt::format("'Frames:' is {}, but the file has {} frames; all are used",
                                  bvh.declared_frame_count, frames));
  }
  const BvhJoint& root = bvh.joints[0];
  const bool moved = std::ranges::any_of(root.channels, [](const auto& c) { return !c.rotates; });
  if (moved && root.offset.norm() > 0) {
    reports.push_back(fmt::format(
        "the position channels of the root replace its OFFSET ({} {} {}), which is not added",
        root.offset.x(), root.offset.y(), root.offset.z()));
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
  if (!files.static_trial.empty()) {
    throw InputError(
        fmt::format("{}: static_trial: this format has no static trial", bvh.text.file));
  }
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

  const auto frames = static_cast<std::size_t>(bvh.rows.rows());
  body.position = Array2D<Vec3>(frames, bvh.joints.size(), unknown_point());
  body.orientation = Array2D<Quat>(frames, bvh.joints.size(), unknown_rotation());
  for (std::size_t i = 0; i < frames; ++i) {
    body.time.push_back(static_cast<double>(i) / rate_hz);
    bvh_forward_kinematics(bvh, bvh.rows.row(i).data(), poses);
    for (std::size_t j = 0; j < bvh.joints.size(); ++j) {
      body.position(i, j) = metres * poses.position[j];
      body.orientation(i, j) = poses.orientation[j];
    }
  }
  if (starts_with_rest_pose(body)) {
    drop_first_frame(body);
    reports.push_back(
        "first frame skipped: it is a rest pose, from which the joints jump to the second frame");
  }
  const std::string& axes = files.conventions.axes;
  const Eigen::Matrix3d world = axes.empty()
                                    ? world_from_skeleton(body, rest, bvh.text.file, reports)
                                    : world_from_recorded(axes, bvh.text.file);
  const Quat world_from_file(world);
  for (Vec3& point : body.position.values) point = world * point;
  for (Quat& turn : body.orientation.values) turn = (world_from_file * turn).normalized();
  demonstration.streams.skeleton = std::move(body);
  return demonstration;
}

}  // namespace morphe::imports
