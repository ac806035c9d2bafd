#include "pipeline/setup/hand_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>
#include <set>

#include "core/robot/tree.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kMinSideways_m = 0.05;  ///< of a hand that is beside the body
constexpr double kMirrorTolerance_m = 0.02;

/// Returns the words of a name: it is divided at each character that is no letter or digit, and
/// before a capital letter that follows a small one. Digits stay, since l7 is no left seventh.
std::set<std::string> words_of(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  char before = 0;
  for (const char c : name + "_") {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    const bool begins = std::isupper(static_cast<unsigned char>(c)) != 0 &&
                        std::islower(static_cast<unsigned char>(before)) != 0;
    if (!letter || begins) {
      if (!word.empty()) words.insert(lower_case(word));
      word.clear();
    }
    if (letter) word += c;
    before = c;
  }
  return words;
}

std::optional<Side> side_of_name(const std::string& name) {
  const std::set<std::string> words = words_of(name);
  const auto has = [&](const char* whole, const char* letter, const char* letters) {
    return words.contains(letter) || words.contains(letters) ||
           std::ranges::any_of(words, [&](const std::string& w) { return w.starts_with(whole); });
  };
  const bool left = has("left", "l", "lh"), right = has("right", "r", "rh");
  if (left == right) return std::nullopt;
  return left ? Side::left : Side::right;
}

struct Named {
  std::optional<Side> side;
  std::string name;
};

/// Searches the names from the hand's root to the base, then the robot's.
Named side_by_names(const Kinematics& robot, const Hand& hand) {
  for (const int f : robot::ancestors(robot.table(), hand.root))
    for (const std::string& name : {robot.link[f], robot.frame(f).name})
      if (const auto side = side_of_name(name)) return {side, name};
  return {side_of_name(robot.model->name), robot.model->name};
}

/// Returns the side of the base frame on which the hand stands (y to the left, REP 103), if another
/// frame stands at the mirror image of its root.
std::optional<Side> side_of_body(const Kinematics& robot, const Hand& hand) {
  const Vec3 root = robot.pose(hand.root).translation();
  if (std::abs(root.y()) < kMinSideways_m) return std::nullopt;
  const Vec3 twin(root.x(), -root.y(), root.z());
  const bool found = std::ranges::any_of(robot.base_from_frame, [&](const Pose& pose) {
    return (pose.translation() - twin).norm() < kMirrorTolerance_m;
  });
  if (!found) return std::nullopt;
  return root.y() > 0 ? Side::left : Side::right;
}

}  // namespace

void find_side(const Kinematics& robot, Palm& palm, Hand& hand) {
  const Named named = side_by_names(robot, hand);
  if (!hand.gripper) {
    hand.side = palm.side;
    if (named.side && named.side != palm.side)
      hand.side_evidence =
          fmt::format("by its thumb, although {} says {}", named.name, name_of(*named.side));
    return;
  }
  if (named.side) {
    hand.side = named.side;
    hand.side_evidence = fmt::format("named so: {}", named.name);
  } else if (const auto side = side_of_body(robot, hand)) {
    hand.side = side;
    hand.side_evidence = "by the side of the body where it stands, if y is to the left";
  }
  if (hand.side != Side::left) return;
  palm.side = Side::left;
  palm.root_from_palm.rotate(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()));
}

}  // namespace morphe::setup
