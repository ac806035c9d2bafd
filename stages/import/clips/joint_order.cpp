#include "stages/import/clips/joint_order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinHandSimilarity = 0.85;    ///< of joints that form a hand
constexpr double kMinSimilarityMargin = 0.10;  ///< to the next best order
/// Of joints in the order that their file states, if no other order fits. Of 80 random orders of
/// the joints of two hands, 72 have at most 0.69.
constexpr double kMinStatedSimilarity = 0.75;
/// Conditions that are needed to judge a stated order, of 61 if all joints are seen: a wrist and
/// fingertips alone have fewer.
constexpr double kMinTestedPerFrame = 20;
constexpr double kMinBendCosine = -0.6;  ///< of two successive bones, at the sharpest bend
constexpr std::size_t kMaxTestedFrames = 50;
constexpr std::string_view kNonKeypointWords[] = {"palm", "forearm"};

/// Returns the names of the orders of `count` joints, or of all orders if `count` is 0.
std::string order_names(std::size_t count) {
  std::vector<std::string_view> names;
  for (const KeypointOrder& order : keypoint_orders()) {
    if (count == 0 || order.joints == count) names.push_back(order.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// An order of as many joints as a recording has, and how well they form a hand in it.
struct Candidate {
  const KeypointOrder* order;
  double similarity;
};

/// Returns the different orders of as many joints, the one with the most similar hand first.
std::vector<Candidate> candidates_of(const Array2D<Vec3>& joints) {
  std::vector<Candidate> candidates;
  for (const KeypointOrder& order : keypoint_orders()) {
    const auto is_same = [&](const Candidate& other) { return other.order->joint == order.joint; };
    if (order.joints == joints.cols && std::ranges::none_of(candidates, is_same))
      candidates.push_back({&order, hand_similarity(joints, order.joint)});
  }
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::similarity);
  return candidates;
}

[[noreturn]] void throw_unknown_order(const std::string& file, const std::string& key,
                                      const std::string& why, std::size_t count,
                                      std::string_view likely) {
  UnresolvedConvention unresolved(
      "joint_order", fmt::format("{}: {}: {}; give --joint-order or `joint_order:`: one of {}",
                                 file, key, why, order_names(count)));
  unresolved.likely_value = likely;
  throw unresolved;
}

struct ConditionCount {
  double tested = 0, satisfied = 0, frames = 0;

  double similarity() const { return tested > 0 ? satisfied / tested : 0; }

  /// Counts the condition smaller < larger, if both are known.
  void count(double smaller, double larger) {
    if (!std::isfinite(smaller) || !std::isfinite(larger)) return;
    ++tested;
    satisfied += smaller < larger;
  }
};

/// Counts the conditions for a human hand. Lengths are relative, so that the unit does not matter.
void count_conditions(const std::array<Vec3, kKeypointCount>& hand, ConditionCount& conditions) {
  const auto distance = [&](int a, int b) { return (hand[a] - hand[b]).norm(); };
  const double palm = (distance(0, 5) + distance(0, 9) + distance(0, 13)) / 3;
  const double size = std::isfinite(palm) ? palm : 4 * distance(5, 9);
  const auto count_bend = [&](int a, int b, int c) {
    const Vec3 before = (hand[b] - hand[a]).normalized(), after = (hand[c] - hand[b]).normalized();
    conditions.count(kMinBendCosine, before.dot(after));
  };
  const auto count_bone = [&](int joint) {
    const double bone = distance(joint, joint + 1);
    conditions.count(0.08 * size, bone);
    conditions.count(bone, 0.75 * size);
  };
  for (int base = 5; base < kKeypointCount; base += 4) {
    conditions.count(0.5 * size, distance(0, base));
    count_bend(0, base, base + 1);
    count_bend(base, base + 1, base + 2);
    count_bend(base + 1, base + 2, base + 3);
    conditions.count(distance(base + 2, base + 3), 1.15 * distance(base, base + 1));
    conditions.count(distance(base + 1, base + 2), 1.15 * distance(base, base + 1));
    for (int joint = base; joint < base + 3; ++joint) count_bone(joint);
    if (base + 4 < kKeypointCount) conditions.count(distance(base, base + 4), 0.4 * size);
  }
  conditions.count(distance(5, 9), distance(5, 13));
  conditions.count(distance(5, 13), distance(5, 17));
  conditions.count(distance(9, 13), distance(9, 17));
  count_bone(2);
  count_bone(3);
  count_bend(2, 3, 4);
  conditions.count(distance(0, 2), distance(0, 9));
  conditions.count(distance(2, 5), distance(2, 17));
}

/// Returns the finger's joint that a word denotes: 0 for its base … 3 for its tip; -1 for a joint
/// that is not a keypoint; no value for another word.
std::optional<int> finger_joint_index(std::string_view word, bool thumb, bool has_metacarpal) {
  if (word == "tip") return 3;
  if (thumb) {
    if (word == "cmc" || word == "metacarpal") return 0;
    if (word == "proximal") return has_metacarpal ? 1 : 0;
    if (word == "mcp" || word == "intermediate") return 1;
    if (word == "ip" || word == "dip" || word == "distal") return 2;
    return std::nullopt;
  }
  if (word == "metacarpal" || word == "cmc") return -1;
  if (word == "mcp" || word == "proximal") return 0;
  if (word == "pip" || word == "intermediate" || word == "middle") return 1;
  if (word == "dip" || word == "distal") return 2;
  return std::nullopt;
}

std::optional<std::size_t> finger_of(std::string_view word) {
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    if (word == kFingerNames[finger]) return finger;
  }
  return word == "pinky" ? std::optional(kLittle) : std::nullopt;
}

/// Returns the keypoint that a name denotes; -1 for another joint of the arm; otherwise no value.
std::optional<int> keypoint_from_name(const std::string& name, bool has_metacarpal) {
  std::optional<std::size_t> finger;
  std::optional<int> joint;
  for (const NameWord& word : split_name(name)) {
    if (word.text == "wrist") return 0;
    if (std::ranges::find(kNonKeypointWords, word.text) != std::end(kNonKeypointWords)) return -1;
    if (!finger) {
      finger = finger_of(word.text);
    } else if (!joint) {
      joint = finger_joint_index(word.text, *finger == kThumb, has_metacarpal);
    }
  }
  if (!finger || !joint) return std::nullopt;
  return *joint < 0 ? -1 : static_cast<int>(1 + 4 * *finger) + *joint;
}

}  // namespace

JointOrder order_by_names(const std::vector<std::string>& names,
                          std::vector<std::string>& unknown) {
  const bool has_metacarpal = std::ranges::any_of(names, [](const std::string& name) {
    const auto words = split_name(name);
    const auto has = [&](const char* word) {
      return std::ranges::find(words, word, &NameWord::text) != words.end();
    };
    return has("thumb") && (has("metacarpal") || has("cmc"));
  });
  JointOrder order;
  order.joint.fill(-1);
  order.because = "joint order from the joint names";
  for (int j = 0; j < std::ssize(names); ++j) {
    const std::optional<int> keypoint = keypoint_from_name(names[j], has_metacarpal);
    if (!keypoint || (*keypoint >= 0 && order.joint[*keypoint] >= 0)) {
      unknown.push_back(names[j]);
    } else if (*keypoint >= 0) {
      order.joint[*keypoint] = j;
    }
  }
  return order;
}

namespace {

ConditionCount conditions_in_order(const Array2D<Vec3>& joints,
                                   const std::array<int, kKeypointCount>& order) {
  ConditionCount conditions;
  const std::size_t step = std::max<std::size_t>(1, joints.rows / kMaxTestedFrames);
  for (std::size_t row = 0; row < joints.rows; row += step) {
    std::array<Vec3, kKeypointCount> hand;
    for (int k = 0; k < kKeypointCount; ++k)
      hand[k] = order[k] < 0 ? unknown_point() : joints(row, order[k]);
    count_conditions(hand, conditions);
    ++conditions.frames;
  }
  return conditions;
}

}  // namespace

double hand_similarity(const Array2D<Vec3>& joints, const std::array<int, kKeypointCount>& order) {
  return conditions_in_order(joints, order).similarity();
}

void expect_hand_in_order(const Array2D<Vec3>& joints, const JointOrder& stated,
                          const std::string& file, const std::string& key) {
  const ConditionCount conditions = conditions_in_order(joints, stated.joint);
  const double similarity = conditions.similarity();
  if (similarity >= kMinHandSimilarity ||
      conditions.tested < kMinTestedPerFrame * conditions.frames)
    return;
  const std::vector<Candidate> candidates = candidates_of(joints);
  if (candidates.empty()) return;
  const Candidate& best = candidates.front();
  const bool is_better = best.similarity - similarity >= kMinSimilarityMargin;
  if (is_better && best.similarity >= kMinHandSimilarity) {
    throw_unknown_order(
        file, key,
        fmt::format("the bones contradict the joint order of the file, in which {:.0f} % of the "
                    "proportions are those of a hand; they fit {} ({:.0f} %)",
                    100 * similarity, best.order->name, 100 * best.similarity),
        joints.cols, best.order->name);
  }
  if (similarity >= kMinStatedSimilarity) return;
  throw_unknown_order(file, key,
                      fmt::format("the joints do not look like a hand in the order of the file: "
                                  "only {:.0f} % of the proportions are those of a hand",
                                  100 * similarity),
                      joints.cols, best.order->name);
}

JointOrder joint_order_of(const Array2D<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key) {
  const std::size_t count = joints.cols;
  const std::string& given = conventions.joint_order.empty() ? in_file : conventions.joint_order;
  if (!given.empty()) {
    const KeypointOrder* const order = keypoint_order(given);
    if (order == nullptr) {
      throw InputError(fmt::format("{}: joint_order: unknown order '{}'; known: {}", file, given,
                                   order_names(0)));
    }
    if (order->joints != count) {
      throw InputError(fmt::format("{}: {}: has {} joints, but the order {} has {}", file, key,
                                   count, given, order->joints));
    }
    const JointOrder stated{order->joint, fmt::format("joint order {}, as given", given)};
    if (conventions.joint_order.empty() && conventions.plausibility_checks)
      expect_hand_in_order(joints, stated, file, key);
    return stated;
  }
  const std::vector<Candidate> candidates = candidates_of(joints);
  const std::string_view likely = candidates.empty() ? "openpose" : candidates[0].order->name;
  const auto throw_unresolved = [&](const std::string& why) {
    throw_unknown_order(file, key, why, candidates.empty() ? 0 : count, likely);
  };
  if (candidates.empty())
    throw_unresolved(
        fmt::format("no known order has {} joints; name them in {}_names", count, key));
  const JointOrder order{
      candidates[0].order->joint,
      fmt::format("joint order {}, recognised by the number and positions of the joints", likely)};
  if (!conventions.plausibility_checks) return order;
  const double similarity = candidates[0].similarity;
  if (similarity < kMinHandSimilarity) {
    throw_unresolved(fmt::format(
        "the {} joints do not look like a hand in any known order (best match, {:.0f} %: {})",
        count, 100 * similarity, likely));
  }
  if (candidates.size() > 1 && similarity - candidates[1].similarity < kMinSimilarityMargin) {
    throw_unresolved(fmt::format("the {} joints look like a hand in both orders {} and {}", count,
                                 likely, candidates[1].order->name));
  }
  return order;
}

}  // namespace morphe::imports
