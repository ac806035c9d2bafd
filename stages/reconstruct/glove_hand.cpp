#include "stages/reconstruct/glove_hand.hpp"

#include <algorithm>
#include <cmath>

#include "core/human/glove.hpp"
#include "core/robot/hand_dimensions.hpp"
#include "stages/reconstruct/glove_filter.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kPalmArch = 19;
/// The sensors of the fingers' last joints, each preceded by its middle joint.
constexpr std::size_t kDipSensors[] = {6, 9, 13, 17};
constexpr double kDipToPipRatio = 2.0 / 3;  ///< approximate: tendons couple the two joints

double mean_seen(const HandStream& glove, Eigen::Index sensor) {
  double sum = 0, count = 0;
  for (const double angle : glove.angles.col(sensor)) {
    if (!std::isfinite(angle)) continue;
    sum += angle;
    ++count;
  }
  return sum / count;
}

bool all_unseen(const std::vector<double>& column) {
  return std::ranges::none_of(column, [](double angle) { return std::isfinite(angle); });
}

GloveColumns fill_missing_sensors(GloveColumns glove, std::vector<std::string>& estimated) {
  const auto note = [&](std::size_t sensor) {
    estimated.push_back(std::string("glove sensor ") + human::kGloveSensors[sensor]);
  };
  for (const std::size_t last : kDipSensors) {
    if (!all_unseen(glove[last]) || all_unseen(glove[last - 1])) continue;
    std::ranges::transform(glove[last - 1], glove[last].begin(),
                           [](double middle) { return kDipToPipRatio * middle; });
    note(last);
  }
  if (all_unseen(glove[kPalmArch]) && !std::ranges::all_of(glove, all_unseen)) {
    std::ranges::fill(glove[kPalmArch], 0.0);
    note(kPalmArch);
  }
  return glove;
}

}  // namespace

GloveColumns resample_glove(const HandStream& glove, const std::optional<HandStream>& flat_hand,
                            double late_s, const TimeGrid& clock, const ReconstructOptions& options,
                            std::vector<std::string>& problems) {
  const bool calibrated = flat_hand && flat_hand->kind == HandKind::glove;
  if (!calibrated) problems.push_back("no flat hand was recorded: the zero of the glove is used");
  std::vector<double> time = glove.time;
  for (double& t : time) t -= late_s;
  GloveColumns columns;
  for (Eigen::Index sensor = 0; sensor < glove.angles.cols(); ++sensor) {
    double zero = 0;
    if (calibrated) zero = mean_seen(*flat_hand, sensor);
    if (!std::isfinite(zero)) zero = 0;
    std::vector<double>& column = columns.emplace_back();
    for (const double angle : glove.angles.col(sensor)) column.push_back(angle - zero);
  }
  return filter_glove(time, columns, clock, options);
}

void pose_fingers(const GloveColumns& glove, const human::HandSize& size, HumanMotion& motion) {
  const GloveColumns columns = fill_missing_sensors(glove, motion.estimated);
  const RobotModel hand = human::human_hand(size);
  RobotModel flat_palm = hand;  // the arch, after kHandAngleNames, bends no finger
  for (RobotModel::Frame& frame : flat_palm.frames) {
    if (frame.joint == std::ssize(kHandAngleNames)) frame.joint = -1;
  }
  motion.bones = robot::hand_dimensions(flat_palm);
  std::vector<Pose> frames;
  motion.hand_angles.resize(motion.time.size(), kHandAngleCount);
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    human::GloveAngles angles;
    for (std::size_t k = 0; k < human::kGloveSensorCount; ++k) angles[k] = columns[k][i];
    const human::HandAngles decoded = human::decode_glove(angles).hand;
    for (std::size_t k = 0; k < kHandAngleCount; ++k) motion.hand_angles(i, k) = decoded.joint[k];
    const human::HandPoints points = human::hand_points(hand, decoded, frames);
    const Vec3& wrist = motion.wrist[i];
    const Quat& world_from_hand = motion.wrist_orientation[i];
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      if (!is_known(points.tip[finger])) continue;
      motion.tip(i, finger) = wrist + world_from_hand * points.tip[finger];
      motion.finger_joint(i, finger) = wrist + world_from_hand * points.middle_joint[finger];
      motion.tip_orientation(i, finger) = world_from_hand * points.tip_orientation[finger];
    }
  }
}

human::HandSize hand_size_of(const Demonstration& demonstration, const HumanOptions& human,
                             std::vector<std::string>& estimated) {
  human::HandSize size = human::hand_size_of_stature(human.stature_m.value_or(kDefaultStature_m));
  if (demonstration.hand_length) {
    size.breadth *= *demonstration.hand_length / size.length;  // replaced below if it was measured
    size.length = *demonstration.hand_length;
  } else {
    estimated.push_back("hand length");
  }
  if (demonstration.hand_breadth) {
    size.breadth = *demonstration.hand_breadth;
  } else {
    estimated.push_back("hand breadth");
  }
  return size;
}

}  // namespace morphe::reconstruct
