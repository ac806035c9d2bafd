#include "stages/import/guess/recorded_points.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/recorded_name.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// Returns the part that a landmark of the trunk in the usual marker sets denotes; otherwise "".
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
    if (iliac.contains(rest) && (side == 'L' || side == 'R'))
      return side == 'L' ? "left hip" : "right hip";
  }
  return "";
}

/// Returns the part of an arm, or a part that helps to find up and forward; otherwise "".
std::string body_part_of_name(const std::string& name) {
  if (std::string part = body_part(name); !part.empty()) return part;
  if (std::string part = trunk_part(name); !part.empty()) return part;
  const RecordedName parsed = parse_recorded_name(name);
  const std::string side = parsed.has(BodyTerm::right)  ? "right "
                           : parsed.has(BodyTerm::left) ? "left "
                                                        : "";
  if (parsed.has(BodyTerm::toe)) return side + "toe";
  if (parsed.has(BodyTerm::ankle) || parsed.has(BodyTerm::foot)) return side + "ankle";
  if (parsed.has(BodyTerm::head)) return "head";
  if (parsed.has(BodyTerm::pelvis)) return "pelvis";
  return "";
}

void add_columns(const std::vector<std::string>& names, const std::vector<double>& time,
                 const Array2D<Vec3>& position, RecordedPoints& points) {
  if (!points.names.empty() && points.time != time) return;  // points share one clock
  points.time = time;
  const std::size_t before = points.names.size();
  Array2D<Vec3> joined(time.size(), before + names.size(), unknown_point());
  for (std::size_t i = 0; i < time.size(); ++i) {
    for (std::size_t k = 0; k < before; ++k) joined(i, k) = points.position(i, k);
    for (std::size_t k = 0; k < names.size(); ++k) joined(i, before + k) = position(i, k);
  }
  points.position = std::move(joined);
  for (const std::string& name : names) {
    points.names.push_back(name);
    points.parts.push_back(body_part_of_name(name));
  }
}

}  // namespace

std::vector<std::string> hand_point_names(HandKind kind, const std::string& side) {
  std::vector<std::string> names;
  if (kind == HandKind::keypoints) names.push_back(side + "_wrist");
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const std::vector<std::string> joints = finger_joint_names(finger);
    for (int j = kind == HandKind::keypoints ? 0 : 3; j < 4; ++j)
      names.push_back(fmt::format("{}_{}", side, joints[j]));
  }
  return names;
}

RecordedPoints recorded_points(const Streams& streams, Side hand) {
  RecordedPoints points;
  const std::string side(name_of(hand));
  if (streams.markers)
    add_columns(streams.markers->names, streams.markers->time, streams.markers->position, points);
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
  // Keypoints recorded together with an arm are in the frame of the hand, not in the world.
  const auto& shape = streams.hand;
  if (shape && shape->position.rows > 0 &&
      (points.names.empty() || (shape->kind == HandKind::fingertips && streams.sensors))) {
    add_columns(hand_point_names(shape->kind, side), shape->time, shape->position, points);
  }
  return points;
}

std::vector<Vec3> mean_track(const RecordedPoints& points, std::string_view part_prefix) {
  std::vector<Vec3> track(points.time.size(), unknown_point());
  std::vector<int> columns;
  for (int k = 0; k < std::ssize(points.parts); ++k) {
    if (points.parts[k].starts_with(part_prefix)) columns.push_back(k);
  }
  std::vector<Vec3> row(columns.size());
  for (int i = 0; i < std::ssize(track) && !columns.empty(); ++i) {
    for (int m = 0; m < std::ssize(columns); ++m) row[m] = points.position(i, columns[m]);
    track[i] = mean_of(row);
  }
  return track;
}

Eigen::Matrix3d scatter_of(const std::vector<Vec3>& points) {
  const Vec3 mean = mean_of(points);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points) {
    if (is_known(point)) scatter += (point - mean) * (point - mean).transpose();
  }
  return scatter;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Vec3& point : points) {
    if (!is_known(point)) continue;
    sum += point;
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : unknown_point();
}

}  // namespace morphe::imports
