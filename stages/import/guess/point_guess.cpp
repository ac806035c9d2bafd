#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/recorded_words.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// The part of an arm on which a point is, independent of the decision between joints and markers.
enum class PointPart {
  none,
  girdle,
  shoulder,
  upper_arm,
  elbow,
  elbow_outer,
  elbow_inner,
  forearm,
  wrist,
  wrist_thumb,
  wrist_little,
  hand,
  hip,
  finger
};

struct PointAssignment {
  PointPart part = PointPart::none;
  bool left = false;
  std::string finger_joint;  ///< "index_tip"
};

/// Returns a finger's joint by its word or number; a finger alone is its tip.
std::string finger_joint_of(const RecordedWords& w, std::size_t which) {
  using enum BodyWord;
  const std::vector<std::string> joints = finger_joint_names(which);
  const bool thumb_joints = which == kThumb;
  if (w.has(tip)) return joints[3];
  if (w.has(metacarpal)) return thumb_joints ? joints[0] : "";
  if (w.has(cmc)) return thumb_joints ? joints[0] : "";
  if (w.has(mcp) || w.has(proximal)) return joints[thumb_joints ? 1 : 0];
  if (w.has(ip) || (thumb_joints && (w.has(distal) || w.has(dip)))) return joints[2];
  if (w.has(pip) || w.has(intermediate)) return thumb_joints ? "" : joints[1];
  if (w.has(dip) || w.has(distal)) return joints[2];
  if (w.numbers.empty()) return joints[3];
  const int number = w.numbers.back();
  return number >= 1 && number <= 4 ? joints[number - 1] : "";
}

PointAssignment classify_finger_point(const RecordedWords& w) {
  using enum BodyWord;
  for (std::size_t which = 0; which < kFingerCount; ++which) {
    if (!w.has(kFingerWords[which])) continue;
    const std::string joint = finger_joint_of(w, which);
    return joint.empty() ? PointAssignment{} : PointAssignment{PointPart::finger, false, joint};
  }
  return w.has(hand) && w.has(tip) ? PointAssignment{PointPart::finger, false, "middle_tip"}
                                   : PointAssignment{};
}

PointPart classify_arm_point(const RecordedWords& w) {
  using enum BodyWord;
  const bool thumb_side = w.has(radial) || w.has(lateral) || w.has(thumb);
  const bool little_side = w.has(ulnar) || w.has(medial) || w.has(little);
  if (w.has(wrist) || w.has(styloid)) {
    return thumb_side    ? PointPart::wrist_thumb
           : little_side ? PointPart::wrist_little
                         : PointPart::wrist;
  }
  if (w.has(elbow) || w.has(epicondyle)) {
    return w.has(lateral) || w.has(radial) ? PointPart::elbow_outer
           : w.has(medial) || w.has(ulnar) ? PointPart::elbow_inner
                                           : PointPart::elbow;
  }
  if (w.has(forearm) || (w.has(arm) && w.has(lower))) return PointPart::forearm;
  if (w.has(upper_arm) || w.has(arm)) return PointPart::upper_arm;
  if (w.has(scapula)) return PointPart::girdle;
  if (w.has(shoulder)) return PointPart::shoulder;
  if (w.has(hip) || w.has(thigh)) return PointPart::hip;
  return w.has(hand) ? PointPart::hand : PointPart::none;
}

PointAssignment classify_point(const std::string& name, Side recorded) {
  using enum BodyWord;
  const RecordedWords w = parse_recorded_name(name);
  const bool sided = w.has(left) || w.has(right);
  for (const BodyWord elsewhere : {head, neck, trunk, pelvis, clavicle, knee, ankle, foot, toe}) {
    if (w.has(elsewhere) && !w.has(hand)) return {};  // "back of the hand" is on an arm
  }
  if (w.has_unknown_word && !sided && w.words.size() < 2) return {};  // for example "ring_stand"
  PointAssignment placed{classify_arm_point(w), false, ""};
  const bool side_of_wrist =
      placed.part == PointPart::wrist_thumb || placed.part == PointPart::wrist_little;
  if (placed.part == PointPart::none || (placed.part == PointPart::hand && !side_of_wrist)) {
    const PointAssignment on_finger = classify_finger_point(w);
    if (on_finger.part != PointPart::none) placed = on_finger;
  }
  placed.left = sided ? w.has(left) : recorded == Side::left;
  return placed;
}

using NamesByPart = std::map<PointPart, std::vector<std::string>>;

/// Adds the markers of one side. Clusters are numbered in the order of the file.
void add_markers(const NamesByPart& points, const std::map<std::string, std::string>& fingers,
                 char side, GuessedNames& guessed) {
  const auto cluster = [&](PointPart part, const char* name) {
    const auto found = points.find(part);
    if (found == points.end()) return;
    for (std::size_t n = 0; n < found->second.size(); ++n) {
      guessed.emplace_back(found->second[n], fmt::format("{}{}{}", side, name, n + 1));
    }
  };
  const auto landmark = [&](PointPart part, const char* name) {
    const auto found = points.find(part);
    if (found == points.end()) return;
    guessed.emplace_back(found->second.front(), fmt::format("{}{}", side, name));
  };
  constexpr std::size_t kMinClusterMarkers = 3;
  const auto shoulders = points.find(PointPart::shoulder);
  const bool many = shoulders != points.end() && shoulders->second.size() >= kMinClusterMarkers;
  if (many && !points.contains(PointPart::girdle)) {
    cluster(PointPart::shoulder, "SHO");
  } else {
    cluster(PointPart::girdle, "SHO");
    landmark(PointPart::shoulder, "GTH");
  }
  cluster(PointPart::upper_arm, "UAR");
  cluster(PointPart::forearm, "LAR");
  cluster(PointPart::hand, "HAN");
  landmark(points.contains(PointPart::elbow_outer) ? PointPart::elbow_outer : PointPart::elbow,
           "LEP");
  landmark(PointPart::elbow_inner, "MEP");
  landmark(points.contains(PointPart::wrist_thumb) ? PointPart::wrist_thumb : PointPart::wrist,
           "SPR");
  landmark(PointPart::wrist_little, "SPU");
  for (const auto& [joint, name] : {std::pair("thumb_tip", "THUM"), std::pair("index_tip", "FTP"),
                                    std::pair("index_mcp", "FB")}) {
    const auto found = fingers.find(joint);
    if (found != fingers.end())
      guessed.emplace_back(found->second, fmt::format("{}{}", side, name));
  }
}

/// Adds the joints of one side. A marker beside a joint is used if there is no better point.
void add_joints(const NamesByPart& points, const std::map<std::string, std::string>& fingers,
                const std::string& side, GuessedNames& guessed) {
  const auto joint = [&](const char* name, std::initializer_list<PointPart> parts) {
    for (const PointPart part : parts) {
      const auto found = points.find(part);
      if (found == points.end()) continue;
      guessed.emplace_back(found->second.front(), side + name);
      return;
    }
  };
  using enum PointPart;
  joint("shoulder", {shoulder, upper_arm});
  joint("elbow", {elbow, forearm, elbow_outer});
  joint("wrist", {wrist, hand, wrist_thumb, wrist_little});
  joint("hip", {hip});
  for (const auto& [name, recorded] : fingers) guessed.emplace_back(recorded, side + name);
}

/// Returns the names of 21 points that are only numbered, from 0: a hand in the most common order.
GuessedNames numbered_hand(const std::vector<std::string>& names, Side hand) {
  constexpr std::size_t kHandPointCount = 21;
  std::vector<std::string> parts = {"wrist"};
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (const std::string& joint : finger_joint_names(finger)) parts.push_back(joint);
  }
  std::map<int, std::string> by_number;
  for (const std::string& name : names) {
    const RecordedWords words = parse_recorded_name(name);
    if (words.numbers.size() == 1) by_number.emplace(words.numbers[0], name);
  }
  const bool whole = names.size() == kHandPointCount && by_number.size() == kHandPointCount &&
                     by_number.begin()->first == 0 &&
                     by_number.rbegin()->first == kHandPointCount - 1;
  GuessedNames guessed;
  for (std::size_t k = 0; whole && k < kHandPointCount; ++k) {
    guessed.emplace_back(by_number[static_cast<int>(k)],
                         fmt::format("{}_{}", name_of(hand), parts[k]));
  }
  return guessed;
}

}  // namespace

GuessedNames guess_points(const std::vector<std::string>& names, Side hand) {
  NamesByPart points[2];
  std::map<std::string, std::string> fingers[2];
  for (const std::string& name : names) {
    const PointAssignment placed = classify_point(name, hand);
    if (placed.part == PointPart::finger) {
      fingers[placed.left].emplace(placed.finger_joint, name);
    } else if (placed.part != PointPart::none) {
      points[placed.left][placed.part].push_back(name);
    }
  }
  constexpr std::size_t kMinClusterMarkers = 3;
  const auto has = [&](PointPart part, std::size_t count) {
    return std::ranges::any_of(points, [&](const NamesByPart& side) {
      const auto found = side.find(part);
      return found != side.end() && found->second.size() >= count;
    });
  };
  const bool markers = has(PointPart::upper_arm, kMinClusterMarkers) ||
                       has(PointPart::forearm, kMinClusterMarkers) ||
                       (has(PointPart::elbow_outer, 1) && has(PointPart::elbow_inner, 1));
  GuessedNames guessed;
  if (points[0].empty() && points[1].empty() && fingers[0].empty() && fingers[1].empty()) {
    return numbered_hand(names, hand);
  }
  for (const bool left : {false, true}) {
    if (markers) {
      add_markers(points[left], fingers[left], left ? 'L' : 'R', guessed);
    } else {
      add_joints(points[left], fingers[left], left ? "left_" : "right_", guessed);
    }
  }
  return guessed;
}

}  // namespace morphe::imports
