#include "stages/import/clips/write_clip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/files/npz_file.hpp"
#include "stages/import/clips/clip_hand.hpp"

namespace morphe::imports {
namespace {

using files::NpyArray;
using files::NpyKind;

constexpr double kUnit = 1;

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

/// Appends three numbers per row, and the fourth of `last` if there is a translation.
void append(const Eigen::Matrix3d& turn, const Vec3* translation, std::vector<double>& values) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index col = 0; col < 3; ++col) values.push_back(turn(row, col));
    if (translation != nullptr) values.push_back((*translation)[row]);
  }
  if (translation != nullptr) values.insert(values.end(), {0, 0, 0, kUnit});
}

Eigen::Matrix3d matrix_of(const Quat& turn) {
  return is_known(turn) ? turn.toRotationMatrix() : Eigen::Matrix3d::Constant(kUnknown);
}

/// The arrays to which the joints of a skeleton are written.
struct SkeletonSplit {
  std::vector<std::size_t> body;
  std::array<std::array<int, kKeypointCount>, 2> hands{};  ///< by Side; -1 if absent
  std::array<int, 2> turned{-1, -1};                       ///< right_hand, left_hand
  bool has(Side side) const {
    const auto which = static_cast<std::size_t>(side);
    return turned[which] >= 0 ||
           std::ranges::any_of(hands[which], [](int joint) { return joint >= 0; });
  }
};

bool has_rotations(const BodyStream& body, std::size_t k) {
  for (std::size_t i = 0; i < body.orientation.rows; ++i) {
    if (is_known(body.orientation(i, k))) return true;
  }
  return false;
}

SkeletonSplit split_skeleton(const BodyStream& skeleton) {
  SkeletonSplit parting;
  for (auto& hand : parting.hands) hand.fill(-1);
  const bool confident = skeleton.confidence.rows > 0;
  for (std::size_t k = 0; k < skeleton.names.size(); ++k) {
    bool in_body = true;
    for (const Side side : {Side::right, Side::left}) {
      const auto which = static_cast<std::size_t>(side);
      const std::vector<std::string> names = keypoint_names(side);
      const auto found = std::ranges::find(names, skeleton.names[k]);
      if (found != names.end()) {
        parting.hands[which][found - names.begin()] = static_cast<int>(k);
        in_body = has_rotations(skeleton, k) || confident;
      } else if (skeleton.names[k] == std::string(name_of(side)) + "_hand") {
        parting.turned[which] = static_cast<int>(k);
      }
    }
    if (in_body) parting.body.push_back(k);
  }
  return parting;
}

void add_hand(const BodyStream& skeleton, const SkeletonSplit& parting, Side side, Arrays& arrays) {
  const auto which = static_cast<std::size_t>(side);
  const std::size_t rows = skeleton.time.size();
  const std::string prefix = clip_prefix(side);
  const auto& joints = parting.hands[which];
  const auto point = [&](std::size_t i, int joint) {
    return joint < 0 ? unknown_point() : skeleton.position(i, joint);
  };
  std::vector<double> wrist, all, turns;
  const Eigen::Matrix3d hand_from_wrist = clip_wrist_from_hand(side).transpose();
  for (std::size_t i = 0; i < rows; ++i) {
    append(point(i, joints[0]), wrist);
    for (const int joint : joints) append(point(i, joint), all);
    if (const int hand = parting.turned[which]; hand >= 0) {
      const Quat& turn = skeleton.orientation(i, hand);
      append(matrix_of(turn) * hand_from_wrist, nullptr, turns);
    }
  }
  arrays.add(prefix + "wrist_pos", {rows, 3}, std::move(wrist));
  arrays.add(prefix + "joints", {rows, kKeypointCount, 3}, std::move(all));
  if (!turns.empty()) arrays.add(prefix + "wrist_rot", {rows, 3, 3}, std::move(turns));
}

void add_body(const BodyStream& skeleton, const std::vector<std::size_t>& joints, Arrays& arrays) {
  if (joints.empty()) return;
  const std::size_t rows = skeleton.time.size();
  std::vector<std::string> names, parents;
  for (const std::size_t k : joints) {
    names.push_back(skeleton.names[k]);
    parents.push_back(k < skeleton.parents.size() ? skeleton.parents[k] : "");
  }
  std::vector<double> points, turns, confidence;
  for (std::size_t i = 0; i < rows; ++i) {
    for (const std::size_t k : joints) {
      append(skeleton.position(i, k), points);
      const Quat& q = skeleton.orientation(i, k);
      turns.insert(turns.end(), {q.w(), q.x(), q.y(), q.z()});
      if (skeleton.confidence.rows > 0) confidence.push_back(skeleton.confidence(i, k));
    }
  }
  arrays.add("body_joint_names", std::move(names));
  arrays.add("body_joints", {rows, joints.size(), 3}, std::move(points));
  if (std::ranges::any_of(joints, [&](std::size_t k) { return has_rotations(skeleton, k); })) {
    arrays.add("body_rotations", {rows, joints.size(), 4}, std::move(turns));
  }
  if (std::ranges::any_of(parents, [](const auto& name) { return !name.empty(); })) {
    arrays.add("body_parents", std::move(parents));
  }
  if (!confidence.empty())
    arrays.add("body_confidence", {rows, joints.size()}, std::move(confidence));
}

void add_skeleton(const BodyStream& skeleton, Arrays& arrays) {
  arrays.add("times", {skeleton.time.size()}, skeleton.time);
  if (skeleton.reconstructed) arrays.add("rebuilt", 1);
  const SkeletonSplit parting = split_skeleton(skeleton);
  if (parting.has(Side::right) || parting.has(Side::left)) arrays.add("joint_order", "openpose");
  for (const Side side : {Side::right, Side::left}) {
    if (parting.has(side)) add_hand(skeleton, parting, side, arrays);
  }
  add_body(skeleton, parting.body, arrays);
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
  for (std::size_t k = 0; k < object.time.size(); ++k) {
    append(matrix_of(object.orientation[k]), &object.position[k], poses);
  }
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
