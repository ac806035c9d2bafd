#include "stages/import/clips/joint_order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinHandSimilarity = 0.85;    ///< least share of satisfied conditions
constexpr double kMinSimilarityMargin = 0.10;  ///< least margin to the next best order
constexpr double kMinBendCosine = -0.6;        ///< least cosine of a bend that a joint can make
constexpr std::size_t kMaxTestedFrames = 50;   ///< number of frames that are tested
constexpr std::string_view kNonKeypointWords[] = {"palm", "forearm"};

std::string order_names(std::size_t count) {
  std::vector<std::string_view> names;
  for (const KeypointOrder& order : keypoint_orders()) {
    if (count == 0 || order.joints == count) names.push_back(order.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The conditions of one frame for an order: the numbers of tested and of satisfied conditions.
struct ConditionCount {
  double tested_count = 0, satisfied_count = 0;
  void test(double smaller, double larger) {
    if (!std::isfinite(smaller) || !std::isfinite(larger)) return;
    ++tested_count;
    satisfied_count += smaller < larger;
  }
};

using Hand = std::array<Vec3, kKeypointCount>;

double keypoint_distance(const Hand& hand, std::size_t a, std::size_t b) {
  return (hand[a] - hand[b]).norm();
}

/// Returns the cosine of the angle between the directions from a to b and from b to c.
double bend_cosine(const Hand& hand, std::size_t a, std::size_t b, std::size_t c) {
  return (hand[b] - hand[a]).normalized().dot((hand[c] - hand[b]).normalized());
}

/// Tests conditions whose lengths are relative to the hand's own, so that they are independent of
/// the unit.
void test_hand_proportions(const Hand& hand, ConditionCount& votes) {
  const double palm = (keypoint_distance(hand, 0, 5) + keypoint_distance(hand, 0, 9) +
                       keypoint_distance(hand, 0, 13)) /
                      3;
  const double size = std::isfinite(palm) ? palm : 4 * keypoint_distance(hand, 5, 9);
  for (std::size_t finger = 1; finger < kFingerCount; ++finger) {
    const std::size_t base = 1 + 4 * finger;
    votes.test(0.5 * size, keypoint_distance(hand, 0, base));
    votes.test(kMinBendCosine, bend_cosine(hand, 0, base, base + 1));
    votes.test(kMinBendCosine, bend_cosine(hand, base, base + 1, base + 2));
    votes.test(kMinBendCosine, bend_cosine(hand, base + 1, base + 2, base + 3));
    votes.test(keypoint_distance(hand, base + 2, base + 3),
               1.15 * keypoint_distance(hand, base, base + 1));
    votes.test(keypoint_distance(hand, base + 1, base + 2),
               1.15 * keypoint_distance(hand, base, base + 1));
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const double bone = keypoint_distance(hand, base + joint, base + joint + 1);
      votes.test(0.08 * size, bone);
      votes.test(bone, 0.75 * size);
    }
    if (finger + 1 < kFingerCount) votes.test(keypoint_distance(hand, base, base + 4), 0.4 * size);
  }
  votes.test(keypoint_distance(hand, 5, 9), keypoint_distance(hand, 5, 13));
  votes.test(keypoint_distance(hand, 5, 13), keypoint_distance(hand, 5, 17));
  votes.test(keypoint_distance(hand, 9, 13), keypoint_distance(hand, 9, 17));
  for (std::size_t joint = 2; joint < 4; ++joint) {
    const double bone = keypoint_distance(hand, joint, joint + 1);
    votes.test(0.08 * size, bone);
    votes.test(bone, 0.75 * size);
  }
  votes.test(kMinBendCosine, bend_cosine(hand, 2, 3, 4));
  votes.test(keypoint_distance(hand, 0, 2), keypoint_distance(hand, 0, 9));
  votes.test(keypoint_distance(hand, 2, 5), keypoint_distance(hand, 2, 17));
}

/// Returns the part of a finger's joint that a word names: 0 for its base … 3 for its tip; -1 if it
/// is not a keypoint.
std::optional<int> finger_joint_index(std::string_view word, bool thumb, bool has_metacarpal) {
  if (word == "tip") return 3;
  if (thumb) {
    if (word == "cmc" || word == "metacarpal") return 0;
    if (word == "mcp") return 1;
    if (word == "ip" || word == "dip" || word == "distal") return 2;
    if (word == "proximal") return has_metacarpal ? 1 : 0;
    if (word == "intermediate") return 1;
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

/// Returns the keypoint that a name denotes, -1 for a joint that is not a keypoint.
std::optional<int> keypoint_from_name(const std::string& name, bool has_metacarpal) {
  std::optional<std::size_t> finger;
  std::optional<int> part;
  for (const NameWord& word : split_name(name)) {
    if (word.text == "wrist") return 0;
    if (std::ranges::find(kNonKeypointWords, word.text) != std::end(kNonKeypointWords)) return -1;
    if (!finger) {
      finger = finger_of(word.text);
    } else if (!part) {
      part = finger_joint_index(word.text, *finger == kThumb, has_metacarpal);
    }
  }
  if (!finger || !part) return std::nullopt;
  return *part < 0 ? -1 : static_cast<int>(1 + 4 * *finger) + *part;
}

[[noreturn]] void test(const std::string& file, const std::string& key, const std::string& why,
                       std::size_t count, std::string likely) {
  UnresolvedConvention question(
      "joint_order", fmt::format("{}: {}: {}; give --joint-order or `joint_order:`: one of {}",
                                 file, key, why, order_names(count)));
  question.likely_value = std::move(likely);
  throw question;
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
  for (std::size_t j = 0; j < names.size(); ++j) {
    const std::optional<int> keypoint = keypoint_from_name(names[j], has_metacarpal);
    if (!keypoint || (*keypoint >= 0 && order.joint[*keypoint] >= 0)) {
      unknown.push_back(names[j]);
    } else if (*keypoint >= 0) {
      order.joint[*keypoint] = static_cast<int>(j);
    }
  }
  return order;
}

double hand_similarity(const Array2D<Vec3>& joints, const std::array<int, kKeypointCount>& order) {
  ConditionCount votes;
  const std::size_t step = std::max<std::size_t>(1, joints.rows / kMaxTestedFrames);
  for (std::size_t row = 0; row < joints.rows; row += step) {
    Hand hand;
    for (std::size_t k = 0; k < kKeypointCount; ++k) {
      hand[k] = order[k] < 0 ? unknown_point() : joints(row, order[k]);
    }
    test_hand_proportions(hand, votes);
  }
  return votes.tested_count > 0 ? votes.satisfied_count / votes.tested_count : 0;
}

JointOrder joint_order_of(const Array2D<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key) {
  const std::string& said = conventions.joint_order.empty() ? in_file : conventions.joint_order;
  if (!said.empty()) {
    const KeypointOrder* const order = keypoint_order(said);
    if (order == nullptr) {
      throw InputError(fmt::format("{}: joint_order: unknown order '{}'; known: {}", file, said,
                                   order_names(0)));
    }
    if (order->joints != joints.cols) {
      throw InputError(fmt::format("{}: {}: has {} joints, but the order {} has {}", file, key,
                                   joints.cols, said, order->joints));
    }
    return {order->joint, fmt::format("joint order {}, as given", said)};
  }
  const KeypointOrder *best = nullptr, *next = nullptr;
  double best_share = 0, next_share = 0;
  for (const KeypointOrder& order : keypoint_orders()) {
    if (order.joints != joints.cols || (best != nullptr && order.joint == best->joint)) continue;
    const double share = hand_similarity(joints, order.joint);
    if (best == nullptr || share > best_share) {
      next = best;
      next_share = best_share;
      best = &order;
      best_share = share;
    } else if (next == nullptr || share > next_share) {
      next = &order;
      next_share = share;
    }
  }
  if (best == nullptr) {
    test(file, key,
         fmt::format("no known order has {} joints; name them in {}_names", joints.cols, key), 0,
         "openpose");
  }
  const JointOrder found{
      best->joint,
      fmt::format("joint order {}, recognised by the number and positions of the joints",
                  best->name)};
  if (!conventions.plausibility_checks) return found;
  if (best_share < kMinHandSimilarity) {
    test(file, key,
         fmt::format(
             "the {} joints do not look like a hand in any known order (best match, {:.0f} %: {})",
             joints.cols, 100 * best_share, best->name),
         joints.cols, std::string(best->name));
  }
  if (next != nullptr && best_share - next_share < kMinSimilarityMargin) {
    test(file, key,
         fmt::format("the {} joints look like a hand in both orders {} and {}", joints.cols,
                     best->name, next->name),
         joints.cols, std::string(best->name));
  }
  return found;
}

}  // namespace morphe::imports
