#include "core/robot/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

/// Words of frames that only a robot with a body has. "waist" and "base" are left out: small arms
/// call their first joint so.
constexpr std::array<std::string_view, 10> kLegWords{"leg",  "legs", "hip", "knee", "ankle",
                                                     "foot", "feet", "toe", "toes", "sole"};
constexpr std::array<std::string_view, 7> kTrunkWords{"pelvis", "torso",  "trunk", "chest",
                                                      "wheel",  "wheels", "caster"};
/// Frames that are named left and right tell a direction if they are this far apart on average [m];
/// chosen by hand: far above rounding, below the distance of any two shoulders.
constexpr double kMinSideDistance_m = 0.02;
/// Pairs of frames left and right from which on a robot has two arms: an arm has four joints.
constexpr int kMinArmPairs = 4;
/// Angles from the vertical between which a base is on its side; a third of the half turn for each
/// of upright, on its side and hanging.
constexpr double kUprightLimit_deg = 60, kHangingLimit_deg = 120;
constexpr double kExactAngle_deg = 1;  ///< smaller tilts are not mentioned
/// Angle from the person's forward direction up to which a robot faces the person's way.
constexpr double kSameWay_deg = 45;

/// Splits a frame's name into words in small letters, at other characters, digits and capitals:
/// "LHipYaw_1" -> l, hip, yaw.
std::vector<std::string> name_words(std::string_view name) {
  std::vector<std::string> words{""};
  for (std::size_t k = 0; k < name.size(); ++k) {
    const auto letter = static_cast<unsigned char>(name[k]);
    const bool capital = std::isupper(letter) != 0;
    const bool small_next =
        k + 1 < name.size() && std::islower(static_cast<unsigned char>(name[k + 1])) != 0;
    const bool small_before = k > 0 && std::islower(static_cast<unsigned char>(name[k - 1])) != 0;
    const bool begins = capital && (small_next || small_before);
    if ((begins || std::isalpha(letter) == 0) && !words.back().empty()) words.emplace_back();
    if (std::isalpha(letter) != 0) words.back() += static_cast<char>(std::tolower(letter));
  }
  return words;
}

/// Returns true if a word of the name is in the list, also after a letter of the side ("rleg").
template <std::size_t N>
bool has_word(std::string_view name, const std::array<std::string_view, N>& list) {
  return std::ranges::any_of(name_words(name), [&](std::string_view word) {
    const bool sided = word.size() > 3 && (word.front() == 'l' || word.front() == 'r');
    return std::ranges::find(list, word) != list.end() ||
           (sided && std::ranges::find(list, word.substr(1)) != list.end());
  });
}

/// Returns the words of a name of the left side with those of the right, "" for all other names.
std::string right_name_of(std::string_view name) {
  std::string mirrored;
  bool left = false;
  for (const std::string& word : name_words(name)) {
    const bool long_word = word == name_of(Side::left);
    left = left || long_word || word == "l";
    mirrored += (long_word ? std::string(name_of(Side::right)) : word == "l" ? "r" : word) + " ";
  }
  return left ? mirrored : "";
}

std::string all_words(std::string_view name) {
  std::string joined;
  for (const std::string& word : name_words(name)) joined += word + " ";
  return joined;
}

/// The pairs of frames named left and right that do not belong to the robot's own hand.
struct SidePairs {
  Vec3 sum_to_left = Vec3::Zero();  ///< of the vectors from right to left [m]
  int count = 0;
  int first_left = -1;  ///< frame
};

SidePairs find_side_pairs(const RobotModel& robot, const std::vector<Pose>& frames) {
  SidePairs pairs;
  const int flange = moving_frame_of(robot, robot.palm_frame);  // carries the whole hand
  std::vector<std::string> names;
  for (const RobotModel::Frame& frame : robot.frames) names.push_back(all_words(frame.name));
  for (int left = 0; left < std::ssize(robot.frames); ++left) {
    const std::string name = right_name_of(robot.frames[left].name);
    if (name.empty()) continue;
    // Digits are no words: the frames of a chain have one name, and stand in the same order.
    const auto same_before = std::count(names.begin(), names.begin() + left, names[left]);
    std::ptrdiff_t skipped = 0;
    for (int right = 0; right < std::ssize(robot.frames); ++right) {
      if (names[right] != name || skipped++ != same_before) continue;
      if (is_in_subtree(robot, left, flange) && is_in_subtree(robot, right, flange)) continue;
      pairs.sum_to_left += frames[left].translation() - frames[right].translation();
      if (pairs.count++ == 0) pairs.first_left = left;
    }
  }
  return pairs;
}

Vec3 nearest_axis(const Vec3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return direction[axis] < 0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis));
}

/// Returns the mean position of the frames that are named as parts of legs; unknown without any.
Vec3 mean_leg_position(const RobotModel& robot, const std::vector<Pose>& frames) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (int k = 0; k < std::ssize(robot.frames); ++k) {
    if (!has_word(robot.frames[k].name, kLegWords)) continue;
    sum += frames[k].translation();
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : unknown_point();
}

/// Returns the part of `direction` that is orthogonal to the unit vector `up`.
Vec3 horizontal_part(const Vec3& direction, const Vec3& up) {
  return direction - direction.dot(up) * up;
}

Vec3 forward_of(const SidePairs& pairs, const Vec3& up) {
  const Vec3 left =
      pairs.count > 0 ? horizontal_part(pairs.sum_to_left / pairs.count, up) : Vec3::Zero();
  if (left.norm() >= kMinSideDistance_m) return left.cross(up).normalized();
  return std::abs(up.x()) > 0.5 ? Vec3::UnitZ() : Vec3::UnitX();
}

/// Returns the first frame that only a robot with a body has; -1 if there is none.
int body_frame(const RobotModel& robot, const SidePairs& pairs) {
  for (int k = 0; k < std::ssize(robot.frames); ++k) {
    const std::string& name = robot.frames[k].name;
    if (has_word(name, kLegWords) || has_word(name, kTrunkWords)) return k;
  }
  return pairs.count >= kMinArmPairs ? pairs.first_left : -1;
}

double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / kRadPerDegree;
}

std::string facing_words(const Vec3& forward) {
  const double to_right_deg = std::atan2(forward.x(), forward.y()) / kRadPerDegree;
  if (std::abs(to_right_deg) <= kSameWay_deg) return "facing the person's way";
  if (std::abs(to_right_deg) >= 180 - kSameWay_deg) return "with its back to the table";
  return to_right_deg > 0 ? "facing the person's right" : "facing the person's left";
}

std::string side_words(const Vec3& up) {
  constexpr std::array<std::string_view, 4> kDirections{"to the front", "to the person's right",
                                                        "to the back", "to the person's left"};
  const double quarter_turns = std::atan2(up.x(), up.y()) / kRadPerDegree / 90;
  const int direction = (static_cast<int>(std::lround(quarter_turns)) + 4) % 4;
  const double above_deg = 90 - angle_deg(up, Vec3::UnitZ());
  std::string words = fmt::format("is on its side, its axis {}", kDirections.at(direction));
  if (std::abs(above_deg) >= kExactAngle_deg)
    words +=
        fmt::format(" and {:.0f} degrees {}", std::abs(above_deg), above_deg < 0 ? "down" : "up");
  return words;
}

}  // namespace

Standing standing_of(const RobotModel& robot) {
  Standing standing;
  std::vector<Pose> frames;
  forward_kinematics(robot, JointVector::Zero(robot.joints()), frames);
  const SidePairs pairs = find_side_pairs(robot, frames);
  const int body = body_frame(robot, pairs);
  if (body < 0) return standing;
  const Vec3 legs = mean_leg_position(robot, frames);
  const Vec3 upwards = frames[robot.shoulder_frame].translation() - legs;
  if (is_known(legs) && upwards.norm() > kMinSideDistance_m) standing.up = nearest_axis(upwards);
  standing.forward = forward_of(pairs, standing.up);
  standing.evidence = robot.frames[body].name;
  return standing;
}

std::string standing_words(const Standing& standing, const Quat& world_from_base) {
  const Vec3 up = world_from_base * standing.up;
  const double tilt_deg = angle_deg(up, Vec3::UnitZ());
  if (tilt_deg > kUprightLimit_deg && tilt_deg < kHangingLimit_deg) return side_words(up);
  const bool hangs = tilt_deg >= kHangingLimit_deg;
  std::string words = !hangs ? "stands upright" : standing.has_body() ? "hangs head down" : "hangs";
  const double off_deg = hangs ? 180 - tilt_deg : tilt_deg;
  if (off_deg >= kExactAngle_deg)
    words +=
        fmt::format(", tilted by {:.0f} degrees from straight {}", off_deg, hangs ? "down" : "up");
  if (!hangs && standing.has_body())
    words += ", " + facing_words(world_from_base * standing.forward);
  return words;
}

}  // namespace morphe::robot
