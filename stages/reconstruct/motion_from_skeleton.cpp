#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "pipeline/human/hand.hpp"
#include "stages/reconstruct/arm_chain.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kNoLength = 1e-4;  // bones that are there in name only [m]
/// Joints of a digit from its base to its tip.
constexpr const char* kThumbJoints[] = {"cmc", "mcp", "ip", "tip"};
constexpr const char* kFingerJoints[] = {"mcp", "pip", "dip", "tip"};

std::string joint_name(std::size_t finger, std::size_t joint) {
  return fmt::format("right_{}_{}", kFingerNames[finger],
                     finger == 0 ? kThumbJoints[joint] : kFingerJoints[joint]);
}

/// A joint of the skeleton as it was recorded; no rows if it has none of that name.
struct Joint {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
  bool there() const { return !position.empty(); }
};
Joint find_joint(const BodyStream& body, const std::string& name) {
  Joint joint;
  const auto found = std::find(body.names.begin(), body.names.end(), name);
  if (found == body.names.end()) return joint;
  const auto k = static_cast<std::size_t>(found - body.names.begin());
  for (std::size_t i = 0; i < body.position.rows; ++i) {
    joint.position.push_back(body.position(i, k));
    joint.orientation.push_back(body.orientation(i, k));
  }
  return joint;
}

using Digits = std::array<std::array<Joint, 4>, kFingers>;

/// Mean over the recording of where `to` lies from `from`, in the axes of a joint.
Vec3 mean_direction(const Joint& axes, const Joint& from, const Joint& to) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < axes.position.size(); ++i) {
    const Vec3 direction = axes.orientation[i].conjugate() * (to.position[i] - from.position[i]);
    if (!seen(direction)) continue;
    sum += direction;
    ++count;
  }
  return sum / count;
}

double mean_length(const Joint& from, const Joint& to) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < from.position.size(); ++i) {
    const double length = (to.position[i] - from.position[i]).norm();
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return sum / count;
}

/// Axes of the hand in those of the wrist joint, NaN if the skeleton's hand does not show them.
Eigen::Matrix3d wrist_from_hand(const Joint& wrist, const Digits& digits, HumanMotion& motion) {
  const Eigen::Matrix3d unknown = Eigen::Matrix3d::Constant(kNotSeen);
  const Joint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const Joint& thumb = digits[0][0].there() ? digits[0][0] : digits[0][1];
  Vec3 to_fingers = unseen_point(), to_thumb = unseen_point();
  if (middle.there()) {
    to_fingers = mean_direction(wrist, wrist, middle);
  } else if (index.there() && little.there()) {
    to_fingers = mean_direction(wrist, wrist, index) + mean_direction(wrist, wrist, little);
  }
  if (index.there() && little.there()) {
    to_thumb = mean_direction(wrist, little, index);
  } else if (thumb.there()) {
    to_thumb = mean_direction(wrist, wrist, thumb);
  }
  if (!seen(to_fingers) || !seen(to_thumb)) {
    motion.problems.push_back(
        "the skeleton's hand has no knuckles of index, middle and little finger, nor a thumb: how "
        "the hand is turned is not known");
    return unknown;
  }
  if (!(index.there() && little.there())) {
    motion.problems.push_back(
        "the skeleton's hand has no knuckles of index and little finger: its thumb's side is where "
        "the thumb is on average");
    motion.estimated.push_back("wrist orientation");
  }
  return hand_axes(to_fingers, to_thumb);
}

/// The hand's orientation in each frame where joints have none of their own, from the same points.
std::vector<Quat> hand_from_points(const Joint& wrist, const Digits& digits, HumanMotion& motion) {
  const Joint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const Joint& thumb = digits[0][0].there() ? digits[0][0] : digits[0][1];
  const bool knuckles = index.there() && little.there();
  std::vector<Quat> world_from_hand(wrist.position.size(), unseen_rotation());
  if (!knuckles && !(middle.there() && thumb.there())) {
    motion.problems.push_back(
        "the points show no knuckles of index and little finger: how the hand is turned is not "
        "known");
    return world_from_hand;
  }
  for (std::size_t i = 0; i < world_from_hand.size(); ++i) {
    const Vec3& base = wrist.position[i];
    const Vec3 to_fingers = middle.there()
                                ? Vec3(middle.position[i] - base)
                                : Vec3((index.position[i] + little.position[i]) / 2 - base);
    const Vec3 to_thumb =
        knuckles ? Vec3(index.position[i] - little.position[i]) : Vec3(thumb.position[i] - base);
    const Eigen::Matrix3d axes = hand_axes(to_fingers, to_thumb);
    if (axes.allFinite()) world_from_hand[i] = Quat(axes);
  }
  return world_from_hand;
}

/// Puts tips that stand on the joint before them where a last bone of usual length, straight at
/// rest, would end: along the bone before it, turned as the last joint is.
void estimate_tips(Digits& digits, HumanMotion& motion) {
  const RobotTable usual = human::human_hand({1, 1});
  std::vector<std::string> estimated;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    auto& [base, middle, last, tip] = digits[finger];
    if (!middle.there() || !last.there() || !tip.there()) continue;
    const double before = mean_length(middle, last);
    if (!(mean_length(last, tip) < kNoLength) || !(before > kNoLength)) continue;
    const RobotTable::Tip& model = usual.tips[finger];
    const double length =
        before * model.transform.translation().norm() /
        usual.frames[static_cast<std::size_t>(model.frame)].transform.translation().norm();
    const Vec3 along = mean_direction(middle, middle, last).normalized();
    for (std::size_t i = 0; i < tip.position.size(); ++i) {
      tip.position[i] = last.position[i] + length * (last.orientation[i] * along);
    }
    estimated.push_back(kFingerNames[finger]);
  }
  if (estimated.empty()) return;
  motion.problems.push_back(
      fmt::format("the last bones of {} have no length in the skeleton: the tips are estimated",
                  fmt::join(estimated, ", ")));
  motion.estimated.push_back("fingertips");
}

/// Joints of the fingers on the clock: from the wrist on, each bone has its length and the
/// direction that was recorded; a joint is where it was if the one before it is missing. Unseen
/// where the skeleton has no such joint.
std::vector<HandKeypoints> fingers_on_clock(const std::vector<double>& time, const Joint& wrist,
                                            const Digits& digits, const Clock& clock,
                                            const ReconstructOptions& options,
                                            const HumanMotion& motion) {
  HandKeypoints nothing;
  nothing.fill(unseen_point());
  std::vector<HandKeypoints> frames(clock.count, nothing);
  for (std::size_t i = 0; i < clock.count; ++i) frames[i][0] = motion.wrist[i];
  const std::vector<Vec3> recorded_wrist = on_clock(time, wrist.position, clock, options);
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    std::vector<Vec3> before = recorded_wrist;
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const Joint& here = digits[finger][joint];
      if (!here.there()) continue;
      const Joint& parent = joint == 0 ? wrist : digits[finger][joint - 1];
      const std::size_t parent_point = joint == 0 ? 0 : keypoint_of(finger, joint - 1);
      const double length = parent.there() ? mean_length(parent, here) : kNotSeen;
      std::vector<Vec3> now = on_clock(time, here.position, clock, options);
      for (std::size_t i = 0; i < clock.count; ++i) {
        frames[i][keypoint_of(finger, joint)] =
            parent.there()
                ? Vec3(frames[i][parent_point] + length * (now[i] - before[i]).normalized())
                : now[i];
      }
      before = std::move(now);
    }
  }
  return frames;
}

}  // namespace

HumanMotion motion_from_skeleton(const Demonstration& demonstration,
                                 const ReconstructOptions& options) {
  const BodyStream& body = *demonstration.streams.skeleton;
  const Clock clock = clock_over({&body.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  const Joint shoulder = find_joint(body, "right_shoulder"),
              elbow = find_joint(body, "right_elbow"), wrist = find_joint(body, "right_wrist");
  const auto place = [&](const char* name, const Joint& joint, std::vector<Vec3>& centres) {
    if (joint.there()) {
      centres = on_clock(body.time, joint.position, clock, options);
      note_unseen(name, centres, motion.problems);
    } else {
      motion.problems.push_back(fmt::format(
          "the skeleton has no joint called right_{0} (left_{0} of a left arm): map its "
          "names with --names or `names:`",
          name));
    }
  };
  place("shoulder", shoulder, motion.shoulder);
  place("elbow", elbow, motion.elbow);
  place("wrist", wrist, motion.wrist);
  if (shoulder.there() && elbow.there() && wrist.there()) {
    keep_bone_lengths(motion,
                      human::ArmLengths{mean_length(shoulder, elbow), mean_length(elbow, wrist)});
  }
  if (!wrist.there()) return motion;

  Digits digits;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    for (std::size_t joint = 0; joint < 4; ++joint) {
      digits[finger][joint] = find_joint(body, joint_name(finger, joint));
    }
  }
  const bool turned = std::ranges::any_of(wrist.orientation, [](const Quat& q) { return seen(q); });
  if (!turned) {
    motion.wrist_orientation =
        on_clock(body.time, hand_from_points(wrist, digits, motion), clock, options);
  } else if (const auto hand = wrist_from_hand(wrist, digits, motion); hand.allFinite()) {
    std::vector<Quat> world_from_hand;
    for (const Quat& turn : wrist.orientation) world_from_hand.push_back(turn * Quat(hand));
    motion.wrist_orientation = on_clock(body.time, world_from_hand, clock, options);
  }
  add_arm_angles(motion);
  estimate_tips(digits, motion);
  const std::vector<HandKeypoints> fingers =
      fingers_on_clock(body.time, wrist, digits, clock, options, motion);
  for (std::size_t i = 0; i < clock.count; ++i) {
    for (std::size_t finger = 0; finger < kFingers; ++finger) {
      motion.tip(i, finger) = fingers[i][keypoint_of(finger, 3)];
      motion.finger_joint(i, finger) = fingers[i][keypoint_of(finger, 1)];
    }
  }
  if (std::none_of(digits.begin(), digits.end(), [](const auto& d) { return d[3].there(); })) {
    motion.problems.push_back("the skeleton has no fingertips");
  }
  if (const auto fitted = fit_hand(fingers, std::nullopt, clock.rate_hz)) {
    motion.hand_angles = fitted->angles;
    motion.residuals.insert(motion.residuals.end(), fitted->residuals.begin(),
                            fitted->residuals.end());
    for (std::size_t i = 0; i < clock.count; ++i) {
      for (std::size_t finger = 0; finger < kFingers; ++finger) {
        motion.tip_orientation(i, finger) =
            motion.wrist_orientation[i] * fitted->tip_orientation(i, finger);
      }
    }
  }
  return motion;
}

}  // namespace morphe::reconstruct
