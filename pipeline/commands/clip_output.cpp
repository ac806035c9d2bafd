#include "pipeline/commands/clip_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/clips/write_clip.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::commands {
namespace {

/// A skeleton of a right arm that is composed joint by joint.
struct Skeleton {
  BodyStream body;
  std::vector<std::vector<Vec3>> positions;
  std::vector<std::vector<Quat>> orientations;
  std::vector<bool> estimated;

  void add(const std::string& name, std::vector<Vec3> position, bool is_estimated,
           std::vector<Quat> orientation = {}) {
    if (std::ranges::none_of(position, [](const Vec3& p) { return is_known(p); })) return;
    body.names.push_back(name);
    if (orientation.empty()) orientation.assign(position.size(), unknown_rotation());
    positions.push_back(std::move(position));
    orientations.push_back(std::move(orientation));
    estimated.push_back(is_estimated);
  }
  BodyStream build(const std::vector<double>& time) {
    const auto rows = std::ssize(time), joints = std::ssize(body.names);
    body.time = time;
    body.reconstructed = true;
    body.parents.assign(joints, "");
    body.position = Array2D<Vec3>(rows, joints, unknown_point());
    body.orientation = Array2D<Quat>(rows, joints, unknown_rotation());
    // Reconstruction recognises estimates by a confidence of 0.
    if (std::ranges::find(estimated, true) != estimated.end())
      body.confidence = Array2D<double>(rows, joints, 1);
    for (int k = 0; k < joints; ++k) {
      for (int i = 0; i < rows; ++i) {
        body.position(i, k) = positions[k][i];
        body.orientation(i, k) = orientations[k][i];
        if (estimated[k]) body.confidence(i, k) = 0;
      }
    }
    return std::move(body);
  }
};

template <class T>
std::vector<T> column_of(const Array2D<T>& table, std::size_t column) {
  std::vector<T> values;
  for (std::size_t i = 0; i < table.rows; ++i) values.push_back(table(i, column));
  return values;
}

BodyStream skeleton_of(const HumanMotion& motion) {
  const auto estimated = [&](const char* body_part) {
    return std::ranges::find(motion.estimated, body_part) != motion.estimated.end();
  };
  Skeleton skeleton;
  skeleton.add("right_shoulder", motion.shoulder, estimated("shoulder"));
  skeleton.add("right_elbow", motion.elbow, estimated("elbow"));
  skeleton.add("right_wrist", motion.wrist, estimated("wrist"));
  if (std::ranges::any_of(motion.wrist_orientation, [](const Quat& q) { return is_known(q); }))
    skeleton.add("right_hand", motion.wrist, estimated("wrist orientation"),
                 motion.wrist_orientation);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const std::vector<std::string> names = imports::finger_joint_names(finger);
    skeleton.add("right_" + names[1], column_of(motion.finger_joint, finger), false);
    skeleton.add("right_" + names[3], column_of(motion.tip, finger), estimated("fingertips"),
                 column_of(motion.tip_orientation, finger));
  }
  return skeleton.build(motion.time);
}

}  // namespace

Demonstration reconstructed_joints(const Demonstration& demonstration) {
  if (imports::can_write_clip(demonstration)) return demonstration;
  // Left arms are reconstructed as their mirror images, and the result is mirrored back.
  const bool left = demonstration.hand == Side::left;
  const HumanMotion motion = reconstruct::reconstruct(
      left ? reconstruct::mirror_image(demonstration) : demonstration, {}, {});
  Demonstration arm;
  BodyStream skeleton = skeleton_of(motion);
  if (!skeleton.names.empty()) arm.streams.skeleton = std::move(skeleton);
  if (left) arm = reconstruct::mirror_image(arm);
  Demonstration joints = demonstration;
  joints.streams = std::move(arm.streams);
  joints.calibration = {};
  joints.sensor_offsets.reset();
  joints.import_notes.emplace_back("joints as Morphe reconstructed them from the recording");
  joints.import_notes.insert(joints.import_notes.end(), motion.reconstruction_notes.begin(),
                             motion.reconstruction_notes.end());
  if (!motion.estimated.empty())
    joints.import_notes.push_back(
        fmt::format("estimated, not recorded: {}", fmt::join(motion.estimated, ", ")));
  return joints;
}

void ClipOutput::add(const Demonstration& demonstration) {
  const std::string& name = demonstration.name;
  if (name.find('/') != std::string::npos || name.starts_with('.'))
    throw InputError(fmt::format("{}: '{}' cannot be a file name", path_.string(), name));
  const Demonstration joints = reconstructed_joints(demonstration);
  if (!imports::can_write_clip(joints)) {
    without_clip_.push_back(name);
    return;
  }
  if (!folder_) folder_.emplace(path_);
  imports::write_clip(joints, path_ / (name + ".npz"));
  folder_->keep();
  ++written_;
}

std::string ClipOutput::text() const {
  std::string text = fmt::format("{}: {}\n", path_.string(), count_with_noun(written_, "clip"));
  for (const std::string& name : without_clip_)
    text += fmt::format(
        "  {}: no clip written: it has no joints, and they cannot be reconstructed\n", name);
  return text;
}

}  // namespace morphe::commands
