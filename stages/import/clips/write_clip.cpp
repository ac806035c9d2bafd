#include "stages/import/clips/write_clip.hpp"

#include <algorithm>
#include <utility>

#include "core/files/npz_file.hpp"
#include "stages/import/clips/clip_hand.hpp"

namespace morphe::imports {
namespace {

using files::NpyArray;
using files::NpyKind;

struct Arrays {
  std::vector<NpyArray> all;

  void add(const std::string& key, std::vector<std::size_t> shape, std::vector<double> values) {
    all.push_back({key, NpyKind::floating, std::move(shape), std::move(values), {}});
  }
  void add(const std::string& key, double value) { add(key, {}, {value}); }
  void add(const std::string& key, std::vector<std::string> text) {
    const std::size_t count = text.size();
    if (count > 0) all.push_back({key, NpyKind::text, {count}, {}, std::move(text)});
  }
  void add(const std::string& key, const std::string& text) {
    if (!text.empty()) all.push_back({key, NpyKind::text, {}, {}, {text}});
  }
};

void append(const Vec3& point, std::vector<double>& values) {
  values.insert(values.end(), point.begin(), point.end());
}

/// Appends a 3×3 matrix, or with a translation a 4×4 matrix, row by row.
void append(const Eigen::Matrix3d& rotation, const Vec3* translation, std::vector<double>& values) {
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) values.push_back(rotation(row, col));
    if (translation != nullptr) values.push_back((*translation)[row]);
  }
  if (translation != nullptr) values.insert(values.end(), {0, 0, 0, 1});
}

Eigen::Matrix3d matrix_of(const Quat& rotation) {
  return is_known(rotation) ? rotation.toRotationMatrix() : Eigen::Matrix3d::Constant(kUnknown);
}

/// The joints of a skeleton that are written as one hand; -1 if absent.
struct HandJoints {
  std::array<int, kKeypointCount> keypoints;
  int orientation = -1;  ///< right_hand or left_hand

  HandJoints() { keypoints.fill(-1); }
  bool any() const {
    return orientation >= 0 || std::ranges::any_of(keypoints, [](int joint) { return joint >= 0; });
  }
};

struct SkeletonSplit {
  std::vector<int> body;
  std::array<HandJoints, 2> hands;  ///< by Side
};

SkeletonSplit split_skeleton(const BodyStream& skeleton) {
  SkeletonSplit split;
  const bool has_confidence = skeleton.confidence.rows > 0;
  for (int k = 0; k < std::ssize(skeleton.names); ++k) {
    bool in_body = true;
    for (const Side side : {Side::right, Side::left}) {
      HandJoints& hand = split.hands[side_index(side)];
      if (const int keypoint = name_index(keypoint_names(side), skeleton.names[k]); keypoint >= 0) {
        hand.keypoints[keypoint] = k;
        in_body = has_confidence || any_known(skeleton.orientation, k);
      } else if (skeleton.names[k] == std::string(name_of(side)) + "_hand") {
        hand.orientation = k;
      }
    }
    if (in_body) split.body.push_back(k);
  }
  return split;
}

void add_hand(const BodyStream& skeleton, const HandJoints& hand, Side side, Arrays& arrays) {
  const std::size_t rows = skeleton.time.size();
  const std::string prefix = clip_prefix(side);
  const auto point = [&](std::size_t i, int joint) {
    return joint < 0 ? unknown_point() : skeleton.position(i, joint);
  };
  std::vector<double> wrist, joints, rotations;
  const Eigen::Matrix3d hand_from_wrist = clip_wrist_from_hand(side).transpose();
  for (std::size_t i = 0; i < rows; ++i) {
    append(point(i, hand.keypoints[0]), wrist);
    for (const int joint : hand.keypoints) append(point(i, joint), joints);
    if (hand.orientation < 0) continue;
    const Quat& orientation = skeleton.orientation(i, hand.orientation);
    append(matrix_of(orientation) * hand_from_wrist, nullptr, rotations);
  }
  arrays.add(prefix + "wrist_pos", {rows, 3}, std::move(wrist));
  arrays.add(prefix + "joints", {rows, kKeypointCount, 3}, std::move(joints));
  if (!rotations.empty()) arrays.add(prefix + "wrist_rot", {rows, 3, 3}, std::move(rotations));
}

void add_body(const BodyStream& skeleton, const std::vector<int>& joints, Arrays& arrays) {
  if (joints.empty()) return;
  const std::size_t rows = skeleton.time.size();
  std::vector<std::string> names, parents;
  for (const int k : joints) {
    names.push_back(skeleton.names[k]);
    parents.push_back(k < std::ssize(skeleton.parents) ? skeleton.parents[k] : "");
  }
  std::vector<double> points, rotations, confidence;
  for (std::size_t i = 0; i < rows; ++i) {
    for (const int k : joints) {
      append(skeleton.position(i, k), points);
      const Quat& q = skeleton.orientation(i, k);
      rotations.insert(rotations.end(), {q.w(), q.x(), q.y(), q.z()});
      if (skeleton.confidence.rows > 0) confidence.push_back(skeleton.confidence(i, k));
    }
  }
  arrays.add("body_joint_names", std::move(names));
  arrays.add("body_joints", {rows, joints.size(), 3}, std::move(points));
  if (std::ranges::any_of(joints, [&](int k) { return any_known(skeleton.orientation, k); }))
    arrays.add("body_rotations", {rows, joints.size(), 4}, std::move(rotations));
  if (std::ranges::any_of(parents, [](const auto& name) { return !name.empty(); }))
    arrays.add("body_parents", std::move(parents));
  if (!confidence.empty())
    arrays.add("body_confidence", {rows, joints.size()}, std::move(confidence));
}

void add_skeleton(const BodyStream& skeleton, Arrays& arrays) {
  arrays.add("times", {skeleton.time.size()}, skeleton.time);
  if (skeleton.reconstructed) arrays.add("rebuilt", 1);
  const SkeletonSplit split = split_skeleton(skeleton);
  if (std::ranges::any_of(split.hands, &HandJoints::any)) arrays.add("joint_order", "openpose");
  for (const Side side : {Side::right, Side::left}) {
    const HandJoints& hand = split.hands[side_index(side)];
    if (hand.any()) add_hand(skeleton, hand, side, arrays);
  }
  add_body(skeleton, split.body, arrays);
}

void add_keypoints(const HandStream& hand, Side side, Arrays& arrays) {
  const std::size_t rows = hand.time.size();
  std::vector<double> joints;
  for (const Vec3& point : hand.position.values) append(point, joints);
  arrays.add("times", {rows}, hand.time);
  arrays.add("in_hand", 1);
  arrays.add("joint_order", "openpose");
  arrays.add(clip_prefix(side) + "joints", {rows, kKeypointCount, 3}, std::move(joints));
}

void add_object(const SceneObject& object, Arrays& arrays) {
  const std::string prefix = "object_" + object.name + "_";
  std::vector<double> poses, vertices, triangles;
  for (std::size_t k = 0; k < object.time.size(); ++k)
    append(matrix_of(object.orientation[k]), &object.position[k], poses);
  arrays.add(prefix + "pose", {object.time.size(), 4, 4}, std::move(poses));
  arrays.add(prefix + "times", {object.time.size()}, object.time);
  arrays.add(prefix + "shape", std::string(name_of(object.shape)));
  if (object.shape != Shape::mesh) {
    arrays.add(prefix + "size", {object.size.size()}, object.size);
    return;
  }
  for (const Vec3& vertex : object.vertices) append(vertex, vertices);
  for (const Eigen::Vector3i& corners : object.triangles) append(corners.cast<double>(), triangles);
  arrays.add(prefix + "vertices", {object.vertices.size(), 3}, std::move(vertices));
  arrays.add(prefix + "triangles", {object.triangles.size(), 3}, std::move(triangles));
  arrays.all.back().kind = NpyKind::integer;
}

void add_clip_metadata(const Demonstration& demonstration, Arrays& arrays) {
  arrays.add("axes", "x y z");
  arrays.add("unit", "m");
  arrays.add("hand", std::string(name_of(demonstration.hand)));
  arrays.add("subject", demonstration.subject);
  arrays.add("task", demonstration.task);
  arrays.add("source", demonstration.source);
  arrays.add("licence", demonstration.licence);
  using Length = std::pair<const char*, std::optional<double>>;
  for (const auto& [key, length] : {Length{"upper_arm", demonstration.upper_arm},
                                    {"forearm", demonstration.forearm},
                                    {"hand_length", demonstration.hand_length},
                                    {"hand_breadth", demonstration.hand_breadth}}) {
    if (length) arrays.add(key, *length);
  }
  std::vector<std::string> phases;
  std::vector<double> times;
  for (const Label& label : demonstration.labels) {
    phases.emplace_back(name_of(label.phase));
    times.insert(times.end(), {label.begin_s, label.end_s});
  }
  const std::size_t count = phases.size();
  arrays.add("label_phases", std::move(phases));
  if (count > 0) arrays.add("label_times", {count, 2}, std::move(times));
  arrays.add("reports", demonstration.import_notes);
}

}  // namespace

bool can_write_clip(const Demonstration& demonstration) {
  const Streams& streams = demonstration.streams;
  if (streams.sensors || (streams.hand && streams.hand->kind == HandKind::glove)) return false;
  if (streams.skeleton) return true;
  return !streams.markers && streams.hand && streams.hand->kind == HandKind::keypoints;
}

void write_clip(const Demonstration& demonstration, const std::filesystem::path& file) {
  Arrays arrays;
  add_clip_metadata(demonstration, arrays);
  if (demonstration.streams.skeleton) {
    add_skeleton(*demonstration.streams.skeleton, arrays);
  } else {
    add_keypoints(*demonstration.streams.hand, demonstration.hand, arrays);
  }
  for (const SceneObject& object : demonstration.objects) add_object(object, arrays);
  files::write_npz(file, arrays.all);
}

}  // namespace morphe::imports
