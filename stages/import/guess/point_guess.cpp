#include <fmt/format.h>

#include <map>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/finger_joint.hpp"
#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/recorded_name.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/import/recording/name_sides.hpp"

namespace morphe::imports {
namespace {

/// The part of an arm on which a point is, before it is known whether it is a joint or a marker.
// clang-format off
enum class PointPart {
  none, girdle, shoulder, upper_arm, elbow, elbow_outer, elbow_inner, forearm,
  wrist, wrist_thumb, wrist_little, hand, hip, finger
};
// clang-format on

struct PointAssignment {
  PointPart part = PointPart::none;
  bool left = false;
  std::string finger_joint;  ///< "index_tip"
};

PointAssignment classify_finger_point(const RecordedName& w) {
  using enum BodyTerm;
  for (std::size_t i = 0; i < kFingerCount; ++i) {
    if (!w.has(kFingerTerms[i])) continue;
    const std::string joint = finger_joint_of(w, i);
    return joint.empty() ? PointAssignment{} : PointAssignment{PointPart::finger, false, joint};
  }
  return w.has(hand) && w.has(tip) ? PointAssignment{PointPart::finger, false, "middle_tip"}
                                   : PointAssignment{};
}

PointPart classify_arm_point(const RecordedName& w) {
  using enum BodyTerm;
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

/// Returns the parsed name with the sides that all names of the file together tell.
RecordedName parse_sided_name(const std::string& name, const NameSide& side) {
  using enum BodyTerm;
  RecordedName w = parse_recorded_name(name);
  if (side.joint == PointSide::unstated) return w;
  std::erase_if(w.terms, [](BodyTerm term) { return term == left || term == right; });
  if (side.body) w.terms.push_back(*side.body == Side::left ? left : right);
  w.terms.push_back(side.joint == PointSide::lateral  ? lateral
                    : side.joint == PointSide::medial ? medial
                    : side.joint == PointSide::radial ? radial
                                                      : ulnar);
  return w;
}

PointAssignment classify_point(const std::string& name, const NameSide& side, Side recorded_hand) {
  using enum BodyTerm;
  const RecordedName w = parse_sided_name(name, side);
  const bool sided = w.has(left) || w.has(right);
  if (w.has(quantity) && !w.has(scapula)) return {};  // but the scapula has an inferior angle
  for (const BodyTerm elsewhere : {head, neck, trunk, pelvis, clavicle, knee, ankle, foot, toe}) {
    if (w.has(elsewhere) && !w.has(hand)) return {};  // "back of the hand" is on an arm
  }
  if (w.has_unknown_word && !sided && w.terms.size() < 2) return {};  // for example "ring_stand"
  PointAssignment assignment{classify_arm_point(w), false, ""};
  if (assignment.part == PointPart::none || assignment.part == PointPart::hand) {
    const PointAssignment on_finger = classify_finger_point(w);
    if (on_finger.part != PointPart::none) assignment = on_finger;
  }
  assignment.left = sided ? w.has(left) : recorded_hand == Side::left;
  return assignment;
}

/// The recorded names of one side, in the order of the file.
struct NamesOfSide {
  std::map<PointPart, std::vector<std::string>> by_part;
  std::map<std::string, std::string> by_finger_joint;

  std::size_t count(PointPart part) const {
    const auto names = by_part.find(part);
    return names == by_part.end() ? 0 : names->second.size();
  }
};

/// Adds the markers of one side, 'R' or 'L'. Those of a cluster are numbered in the file's order.
void add_markers(const NamesOfSide& points, char side, GuessedNames& guessed) {
  const auto cluster = [&](PointPart part, const char* name) {
    for (std::size_t n = 0; n < points.count(part); ++n)
      guessed.emplace_back(points.by_part.at(part)[n], fmt::format("{}{}{}", side, name, n + 1));
  };
  const auto landmark = [&](PointPart part, const char* name) {
    if (points.count(part) == 0) return;
    guessed.emplace_back(points.by_part.at(part).front(), fmt::format("{}{}", side, name));
  };
  if (points.count(PointPart::shoulder) >= kMinClusterMarkers &&
      points.count(PointPart::girdle) == 0) {
    cluster(PointPart::shoulder, "SHO");
  } else {
    cluster(PointPart::girdle, "SHO");
    landmark(PointPart::shoulder, "GTH");
  }
  cluster(PointPart::upper_arm, "UAR");
  cluster(PointPart::forearm, "LAR");
  cluster(PointPart::hand, "HAN");
  landmark(points.count(PointPart::elbow_outer) > 0 ? PointPart::elbow_outer : PointPart::elbow,
           "LEP");
  landmark(PointPart::elbow_inner, "MEP");
  landmark(points.count(PointPart::wrist_thumb) > 0 ? PointPart::wrist_thumb : PointPart::wrist,
           "SPR");
  landmark(PointPart::wrist_little, "SPU");
  for (const auto& [joint, name] : {std::pair("thumb_tip", "THUM"), std::pair("index_tip", "FTP"),
                                    std::pair("index_mcp", "FB")}) {
    const auto recorded = points.by_finger_joint.find(joint);
    if (recorded != points.by_finger_joint.end())
      guessed.emplace_back(recorded->second, fmt::format("{}{}", side, name));
  }
}

/// Adds the joints of one side, "right_" or "left_", at the first of the listed parts with points.
void add_joints(const NamesOfSide& points, const std::string& side, GuessedNames& guessed) {
  const auto add_first = [&](const char* name, std::initializer_list<PointPart> parts) {
    for (const PointPart part : parts) {
      if (points.count(part) == 0) continue;
      guessed.emplace_back(points.by_part.at(part).front(), side + name);
      return;
    }
  };
  using enum PointPart;
  add_first("shoulder", {shoulder, upper_arm});
  add_first("elbow", {elbow, forearm, elbow_outer});
  add_first("wrist", {wrist, hand, wrist_thumb, wrist_little});
  add_first("hip", {hip});
  for (const auto& [name, recorded] : points.by_finger_joint)
    guessed.emplace_back(recorded, side + name);
}

/// Returns the names of 21 points that are numbered from 0 as a hand's keypoints; otherwise empty.
GuessedNames numbered_hand(const std::vector<std::string>& names, Side hand) {
  std::vector<std::string> parts = {"wrist"};
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (const std::string& joint : finger_joint_names(finger)) parts.push_back(joint);
  }
  std::map<int, std::string> by_number;
  for (const std::string& name : names) {
    const RecordedName parsed = parse_recorded_name(name);
    if (parsed.numbers.size() == 1) by_number.emplace(parsed.numbers[0], name);
  }
  if (names.size() != kHandPointCount || by_number.size() != kHandPointCount ||
      by_number.begin()->first != 0 || by_number.rbegin()->first != kHandPointCount - 1) {
    return {};
  }
  GuessedNames guessed;
  for (const auto& [number, name] : by_number)
    guessed.emplace_back(name, fmt::format("{}_{}", name_of(hand), parts[number]));
  return guessed;
}

}  // namespace

GuessedNames guess_points(const std::vector<std::string>& names, Side hand) {
  NamesOfSide points[2];  // right, left
  bool any_assigned = false;
  const std::vector<NameSide> sides = sides_of_names(names);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string& name = names[k];
    const PointAssignment assignment = classify_point(name, sides[k], hand);
    NamesOfSide& side = points[assignment.left];
    any_assigned = any_assigned || assignment.part != PointPart::none;
    if (assignment.part == PointPart::finger) {
      side.by_finger_joint.emplace(assignment.finger_joint, name);
    } else if (assignment.part != PointPart::none) {
      side.by_part[assignment.part].push_back(name);
    }
  }
  if (!any_assigned) return numbered_hand(names, hand);
  const auto has = [&](PointPart part, std::size_t count) {
    return points[0].count(part) >= count || points[1].count(part) >= count;
  };
  const bool markers = has(PointPart::upper_arm, kMinClusterMarkers) ||
                       has(PointPart::forearm, kMinClusterMarkers) ||
                       (has(PointPart::elbow_outer, 1) && has(PointPart::elbow_inner, 1));
  GuessedNames guessed;
  for (const bool left : {false, true}) {
    if (markers) {
      add_markers(points[left], left ? 'L' : 'R', guessed);
    } else {
      add_joints(points[left], left ? "left_" : "right_", guessed);
    }
  }
  return guessed;
}

}  // namespace morphe::imports
