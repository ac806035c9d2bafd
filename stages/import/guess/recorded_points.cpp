#include "stages/import/guess/recorded_points.hpp"

#include <fmt/format.h>

#include <cctype>
#include <functional>
#include <set>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/recorded_words.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// Returns the part for landmarks of the trunk in the usual marker sets; "" for any other name.
std::string trunk_part(const std::string& name) {
  std::string own = name.substr(name.rfind(':') + 1);
  for (char& c : own) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  static const std::set<std::string, std::less<>> chest = {"STRN", "STER", "CLAV", "MANU", "XIPH"},
                                                  back = {"C7", "T4", "T8", "T10", "T12"},
                                                  iliac = {"ASI", "ASIS", "PSI", "PSIS"};
  if (chest.contains(own)) return "chest";
  if (back.contains(own)) return "back";
  for (const bool first : {true, false}) {
    if (own.size() < 2) break;
    const char side = first ? own.front() : own.back();
    const std::string rest = first ? own.substr(1) : own.substr(0, own.size() - 1);
    if (iliac.contains(rest) && (side == 'L' || side == 'R')) {
      return side == 'L' ? "left hip" : "right hip";
    }
  }
  return "";
}

/// Returns a part that is not on an arm, but determines up and forward.
std::string body_part_of_name(const std::string& name) {
  if (std::string part = body_part(name); !part.empty()) return part;
  if (std::string part = trunk_part(name); !part.empty()) return part;
  const RecordedWords words = parse_recorded_name(name);
  const std::string side = words.has(BodyWord::right)  ? "right "
                           : words.has(BodyWord::left) ? "left "
                                                       : "";
  if (words.has(BodyWord::toe)) return side + "toe";
  if (words.has(BodyWord::ankle) || words.has(BodyWord::foot)) return side + "ankle";
  if (words.has(BodyWord::head)) return "head";
  if (words.has(BodyWord::pelvis)) return "pelvis";
  return "";
}

void add_columns(const std::vector<std::string>& names, const std::vector<double>& time,
                 const Array2D<Vec3>& position, RecordedPoints& points) {
  const bool same_rows = points.time == time;
  if (!points.names.empty() && !same_rows) return;
  points.time = time;
  Array2D<Vec3> joined(time.size(), points.names.size() + names.size(), unknown_point());
  for (std::size_t i = 0; i < time.size(); ++i) {
    for (std::size_t k = 0; k < points.names.size(); ++k) joined(i, k) = points.position(i, k);
    for (std::size_t k = 0; k < names.size(); ++k) {
      joined(i, points.names.size() + k) = position(i, k);
    }
  }
  points.position = std::move(joined);
  for (const std::string& name : names) {
    points.names.push_back(name);
    points.parts.push_back(body_part_of_name(name));
  }
}

std::vector<std::string> hand_point_names(HandKind kind, const std::string& side) {
  std::vector<std::string> names;
  if (kind == HandKind::keypoints) names.push_back(side + "_wrist");
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const std::vector<std::string> joints = finger_joint_names(finger);
    for (std::size_t j = kind == HandKind::keypoints ? 0 : 3; j < 4; ++j) {
      names.push_back(fmt::format("{}_{}", side, joints[j]));
    }
  }
  return names;
}

}  // namespace

RecordedPoints recorded_points(const Streams& streams, Side hand) {
  RecordedPoints points;
  const std::string side(name_of(hand));
  if (streams.markers) {
    add_columns(streams.markers->names, streams.markers->time, streams.markers->position, points);
  }
  if (streams.skeleton) {
    points.parents.resize(points.names.size());
    add_columns(streams.skeleton->names, streams.skeleton->time, streams.skeleton->position,
                points);
    points.parents.insert(points.parents.end(), streams.skeleton->parents.begin(),
                          streams.skeleton->parents.end());
  }
  if (streams.sensors && points.names.empty()) {
    std::vector<std::string> names = streams.sensors->names;
    for (std::string& name : names) name = fmt::format("{}_{}", side, name);
    add_columns(names, streams.sensors->time, streams.sensors->position, points);
  }
  // Keypoints beside an arm are a hand's shape in a frame of its own.
  const auto& kept = streams.hand;
  if (kept && kept->position.rows > 0 &&
      (points.names.empty() || (kept->kind == HandKind::fingertips && streams.sensors))) {
    add_columns(hand_point_names(streams.hand->kind, side), streams.hand->time,
                streams.hand->position, points);
  }
  return points;
}

std::vector<Vec3> mean_track(const RecordedPoints& points, std::string_view part) {
  std::vector<Vec3> track(points.time.size(), unknown_point());
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < points.parts.size(); ++k) {
    if (points.parts[k].starts_with(part)) columns.push_back(k);
  }
  for (std::size_t i = 0; i < track.size(); ++i) {
    std::vector<Vec3> here;
    for (const std::size_t k : columns) here.push_back(points.position(i, k));
    track[i] = mean_of(here);
  }
  return track;
}

Vec3 mean_of(const std::vector<Vec3>& track) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Vec3& point : track) {
    if (!is_known(point)) continue;
    sum += point;
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : unknown_point();
}

}  // namespace morphe::imports
