#include "pipeline/setup/find_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/robot/tree.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

/// Least ratio of the lengths of upper arm and forearm. Of the public arms compared, from 0.56
/// (NAO) to 1.1, the least is far from the hand bones of arms with a twisting wrist (0.25, UR5e).
constexpr double kMinBoneRatio = 0.3;
constexpr double kMinBone_m = 0.03;  ///< less than half of the shortest one compared (NAO, 0.06)
/// A twist of the upper arm passes the elbow's axis within this share of the bone: 0.25 (Panda).
constexpr double kMaxTwistOffset = 0.5;
/// The first axis passes a shoulder of the two others within this share of the upper arm: Sawyer
/// 0.52, Talos 0.50; the yaw of a humanoid's waist is farther, from 0.63 (H1).
constexpr double kMaxFirstAxisOffset = 0.58;
/// Axes of a shoulder that follow each other differ by at least 45 degrees.
constexpr double kMaxShoulderCosine = 0.7;
constexpr int kMinLimbJoints = 3;

/// An elbow and what follows from it. Candidates of the lowest rank are preferred.
struct Candidate {
  int place = -1;  ///< of the elbow on the path
  std::vector<int> shoulder;
  ArmCentres centres;
  int rank = 0;
};

struct ArmSearch {
  const Kinematics& robot;
  const std::vector<int>& path;
  const std::optional<Vec3>& end;
  int first;  ///< place of the first frame that can belong to the arm

  bool turns(int place) const { return place >= first && !robot.frame(path[place]).prismatic; }
  Line axis(int place) const { return robot.axis(path[place]); }
  /// Returns true if two axes can follow each other in a shoulder.
  bool swing_apart(int one, int other) const {
    return turns(one) && turns(other) &&
           std::abs(axis(one).direction.dot(axis(other).direction)) < kMaxShoulderCosine;
  }
  bool twists_upper_arm(int elbow) const {
    return swing_apart(elbow - 2, elbow - 1) &&
           distance(axis(elbow - 1), axis(elbow)) <
               kMaxTwistOffset * distance(axis(elbow - 2), axis(elbow));
  }
  bool has_name(int place, std::initializer_list<const char*> words) const {
    const std::string name = lower_case(robot.frame(path[place]).name);
    return std::ranges::any_of(
        words, [&](const char* word) { return name.find(word) != std::string::npos; });
  }
  std::vector<int> frames(int from, int to) const {
    return {path.begin() + from, path.begin() + to};
  }
};

/// Extends a shoulder by the axis before it, if it passes near enough.
void add_first_axis(const ArmSearch& search, int elbow, int& begin) {
  if (!search.swing_apart(begin - 1, begin)) return;
  const Vec3 shoulder =
      position_in_base(search.robot, shoulder_centre(search.robot, search.frames(begin, elbow)));
  const double upper_arm_m = distance(search.axis(elbow), shoulder);
  const double offset_m = elbow - begin > 1 ? distance(search.axis(begin - 1), shoulder)
                                            : distance(search.axis(begin - 1), search.axis(begin));
  if (offset_m <= kMaxFirstAxisOffset * upper_arm_m) --begin;
}

/// The kinds of shoulders, by rank.
constexpr int kCompleteShoulder = 0, kShoulderWithoutTwist = 4, kOneAxisShoulder = 8;

/// Finds the place of the first frame of the shoulder before an elbow. Returns its kind.
int find_shoulder(const ArmSearch& search, int elbow, int& begin) {
  if (are_parallel(search.axis(elbow - 1), search.axis(elbow))) {
    begin = elbow - 1;
    add_first_axis(search, elbow, begin);
    return begin < elbow - 1 ? kCompleteShoulder : kOneAxisShoulder;
  }
  if (search.twists_upper_arm(elbow)) {
    begin = elbow - 2;
    add_first_axis(search, elbow, begin);
    return kCompleteShoulder;
  }
  begin = search.swing_apart(elbow - 2, elbow - 1) ? elbow - 2 : elbow - 1;
  return begin < elbow - 1 ? kShoulderWithoutTwist : kOneAxisShoulder;
}

/// Returns true if a hinge folds two bones to a shoulder and a wrist, and does not twist one.
bool folds_bones(const Line& hinge, const Vec3& shoulder, const Vec3& wrist) {
  const double upper_arm_m = distance(hinge, shoulder), forearm_m = distance(hinge, wrist);
  const auto [shorter_m, longer_m] = std::minmax(upper_arm_m, forearm_m);
  return shorter_m > std::max(kMinBone_m, kMinBoneRatio * longer_m) &&
         std::abs((wrist - shoulder).dot(hinge.direction)) < longer_m;
}

/// Returns the arm with an elbow, or nullopt if it has not the proportions of one. An elbow that a
/// person named needs none.
std::optional<Candidate> candidate_at(const ArmSearch& search, int elbow, bool named) {
  if (!search.turns(elbow) || !search.turns(elbow - 1)) return std::nullopt;
  Candidate found;
  found.place = elbow;
  int begin = 0;
  const int kind = find_shoulder(search, elbow, begin);
  const bool parallel = are_parallel(search.axis(elbow - 1), search.axis(elbow));
  if (kind == kOneAxisShoulder && !parallel && !named) return std::nullopt;  // its place is unknown
  found.shoulder = search.frames(begin, elbow);
  ArmCentres& centres = found.centres;
  centres.shoulder = shoulder_centre(search.robot, found.shoulder);
  const Vec3 shoulder = position_in_base(search.robot, centres.shoulder);
  centres.elbow = elbow_centre(search.robot, search.path[elbow], shoulder);
  centres.wrist =
      wrist_centre(search.robot, search.path[elbow],
                   search.frames(elbow + 1, static_cast<int>(search.path.size())), search.end);
  const Vec3 wrist = position_in_base(search.robot, centres.wrist);
  if (distance(search.axis(elbow), wrist) < kMinBone_m) return std::nullopt;
  if (!named && !folds_bones(search.axis(elbow), shoulder, wrist)) return std::nullopt;
  const bool trunk = std::ranges::any_of(found.shoulder, [&](int frame) {
    const auto place = std::ranges::find(search.path, frame) - search.path.begin();
    return search.has_name(static_cast<int>(place), {"waist", "torso", "trunk", "spine", "chest"});
  });
  found.rank = kind + (centres.wrist.sure == Provenance::derived ? 0 : 2) + (trunk ? 3 : 0) -
               (search.has_name(elbow, {"elbow"}) ? 3 : 0);
  return found;
}

/// Returns the place behind the last sliding joint before an elbow: all before it is trunk.
int place_behind_lifts(const Kinematics& robot, const std::vector<int>& path, int from) {
  int first = from;
  for (int k = from; k < std::ssize(path); ++k) {
    const auto further = std::count_if(path.begin() + k, path.end(),
                                       [&](int f) { return !robot.frame(f).prismatic; });
    if (robot.frame(path[k]).prismatic && further >= 3) first = k + 1;
  }
  return first;
}

/// Returns the greatest number of joints in a row on a branch.
int joints_in_a_row(const Kinematics& robot, int frame, std::set<int> seen) {
  int own = 0;
  if (robot.moves(frame)) own = seen.insert(robot.frame(frame).joint).second ? 1 : 0;
  int further = 0;
  for (const int child : robot.children[frame])
    further = std::max(further, joints_in_a_row(robot, child, seen));
  return own + further;
}

}  // namespace

int trunk_length(const Kinematics& robot, const std::vector<int>& path) {
  std::set<int> own;  // joints of the path may also move levers beside it
  for (const int frame : path) own.insert(robot.frame(frame).joint);
  for (int frame = path.back(), child = -1; frame >= 0;
       child = frame, frame = robot.frame(frame).parent) {
    if (child < 0) continue;
    const bool carries = std::ranges::any_of(robot.children[frame], [&](int other) {
      return other != child && joints_in_a_row(robot, other, own) >= kMinLimbJoints;
    });
    if (!carries) continue;
    return static_cast<int>(std::ranges::count_if(
        path, [&](int f) { return robot::is_in_subtree(robot.table(), frame, f); }));
  }
  return 0;
}

std::optional<Arm> find_arm(const Kinematics& robot, const std::vector<int>& path,
                            const std::optional<Vec3>& end, const ArmAnswers& answers) {
  const auto place_of = [&](int frame) {
    return static_cast<int>(std::ranges::find(path, frame) - path.begin());
  };
  int first = place_behind_lifts(robot, path, trunk_length(robot, path));
  if (answers.first >= 0) first = std::max(first, place_of(answers.first));
  const ArmSearch search{robot, path, end, first};
  std::vector<Candidate> candidates;
  for (int place = static_cast<int>(path.size()) - 1; place > first; --place) {
    if (answers.elbow >= 0 && path[place] != answers.elbow) continue;
    if (auto candidate = candidate_at(search, place, answers.elbow >= 0))
      candidates.push_back(*candidate);
  }
  const auto best = std::ranges::min_element(candidates, {}, &Candidate::rank);
  if (best == candidates.end()) return std::nullopt;
  Arm arm;
  const int begin = answers.first >= 0 ? place_of(answers.first) : place_of(best->shoulder.front());
  arm.trunk = {path.begin(), path.begin() + begin};
  arm.frames = {path.begin() + begin, path.end()};
  arm.shoulder = best->shoulder;
  arm.elbow = path[best->place];
  arm.centres = best->centres;
  for (const Candidate& other : candidates)
    if (other.place != best->place && other.rank == best->rank)
      arm.other_elbows.push_back(path[other.place]);
  return arm;
}

}  // namespace morphe::setup
