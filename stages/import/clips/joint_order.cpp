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

constexpr double kIsAHand = 0.85;    ///< share of what must be true
constexpr double kDecided = 0.10;    ///< by which the next best must be worse
constexpr double kFoldsBack = -0.6;  ///< cosine of a bend that no joint makes
constexpr std::size_t kLooks = 50;   ///< frames that are looked at
constexpr std::string_view kNoKeypoints[] = {"palm", "forearm"};

std::string orders_with(std::size_t count) {
  std::vector<std::string_view> names;
  for (const KeypointOrder& order : keypoint_orders()) {
    if (count == 0 || order.joints == count) names.push_back(order.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Votes of one frame for an order: how many conditions could be judged, and how many held.
struct Votes {
  double asked = 0, held = 0;
  void ask(double smaller, double larger) {
    if (!std::isfinite(smaller) || !std::isfinite(larger)) return;
    ++asked;
    held += smaller < larger;
  }
};

using Hand = std::array<Vec3, kKeypoints>;

double apart(const Hand& hand, std::size_t a, std::size_t b) { return (hand[a] - hand[b]).norm(); }

/// Cosine of the angle by which the way from a over b to c turns.
double bend(const Hand& hand, std::size_t a, std::size_t b, std::size_t c) {
  return (hand[b] - hand[a]).normalized().dot((hand[c] - hand[b]).normalized());
}

/// All lengths are measured by the hand's own: nothing depends on the unit.
void judge(const Hand& hand, Votes& votes) {
  const double palm = (apart(hand, 0, 5) + apart(hand, 0, 9) + apart(hand, 0, 13)) / 3;
  const double size = std::isfinite(palm) ? palm : 4 * apart(hand, 5, 9);
  for (std::size_t finger = 1; finger < kFingers; ++finger) {
    const std::size_t base = 1 + 4 * finger;
    votes.ask(0.5 * size, apart(hand, 0, base));
    votes.ask(kFoldsBack, bend(hand, 0, base, base + 1));
    votes.ask(kFoldsBack, bend(hand, base, base + 1, base + 2));
    votes.ask(kFoldsBack, bend(hand, base + 1, base + 2, base + 3));
    votes.ask(apart(hand, base + 2, base + 3), 1.15 * apart(hand, base, base + 1));
    votes.ask(apart(hand, base + 1, base + 2), 1.15 * apart(hand, base, base + 1));
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const double bone = apart(hand, base + joint, base + joint + 1);
      votes.ask(0.08 * size, bone);
      votes.ask(bone, 0.75 * size);
    }
    if (finger + 1 < kFingers) votes.ask(apart(hand, base, base + 4), 0.4 * size);
  }
  votes.ask(apart(hand, 5, 9), apart(hand, 5, 13));
  votes.ask(apart(hand, 5, 13), apart(hand, 5, 17));
  votes.ask(apart(hand, 9, 13), apart(hand, 9, 17));
  for (std::size_t joint = 2; joint < 4; ++joint) {
    const double bone = apart(hand, joint, joint + 1);
    votes.ask(0.08 * size, bone);
    votes.ask(bone, 0.75 * size);
  }
  votes.ask(kFoldsBack, bend(hand, 2, 3, 4));
  votes.ask(apart(hand, 0, 2), apart(hand, 0, 9));
  votes.ask(apart(hand, 2, 5), apart(hand, 2, 17));
}

/// The part of a finger's joint that a word names: 0 = its base … 3 = its tip; -1 = no keypoint.
std::optional<int> part_of(std::string_view word, bool thumb, bool has_metacarpal) {
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
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    if (word == kFingerNames[finger]) return finger;
  }
  return word == "pinky" ? std::optional(kLittle) : std::nullopt;
}

/// The keypoint that a name says, -1 = one that is no keypoint.
std::optional<int> keypoint_called(const std::string& name, bool has_metacarpal) {
  std::optional<std::size_t> finger;
  std::optional<int> part;
  for (const NameWord& word : words_of(name)) {
    if (word.text == "wrist") return 0;
    if (std::ranges::find(kNoKeypoints, word.text) != std::end(kNoKeypoints)) return -1;
    if (!finger) {
      finger = finger_of(word.text);
    } else if (!part) {
      part = part_of(word.text, *finger == kThumb, has_metacarpal);
    }
  }
  if (!finger || !part) return std::nullopt;
  return *part < 0 ? -1 : static_cast<int>(1 + 4 * *finger) + *part;
}

[[noreturn]] void ask(const std::string& file, const std::string& key, const std::string& why,
                      std::size_t count, std::string likely) {
  NotSaid question("joint_order",
                   fmt::format("{}: {}: {}; give --joint-order or `joint_order:`, one of {}", file,
                               key, why, orders_with(count)));
  question.likely = std::move(likely);
  throw question;
}

}  // namespace

JointOrder order_by_names(const std::vector<std::string>& names,
                          std::vector<std::string>& unknown) {
  const bool has_metacarpal = std::ranges::any_of(names, [](const std::string& name) {
    const auto words = words_of(name);
    const auto has = [&](const char* word) {
      return std::ranges::find(words, word, &NameWord::text) != words.end();
    };
    return has("thumb") && (has("metacarpal") || has("cmc"));
  });
  JointOrder order;
  order.joint.fill(-1);
  order.because = "by the joints' names";
  for (std::size_t j = 0; j < names.size(); ++j) {
    const std::optional<int> keypoint = keypoint_called(names[j], has_metacarpal);
    if (!keypoint || (*keypoint >= 0 && order.joint[static_cast<std::size_t>(*keypoint)] >= 0)) {
      unknown.push_back(names[j]);
    } else if (*keypoint >= 0) {
      order.joint[static_cast<std::size_t>(*keypoint)] = static_cast<int>(j);
    }
  }
  return order;
}

double likeness_to_a_hand(const Table<Vec3>& joints, const std::array<int, kKeypoints>& order) {
  Votes votes;
  const std::size_t step = std::max<std::size_t>(1, joints.rows / kLooks);
  for (std::size_t row = 0; row < joints.rows; row += step) {
    Hand hand;
    for (std::size_t k = 0; k < kKeypoints; ++k) {
      hand[k] = order[k] < 0 ? unseen_point() : joints(row, static_cast<std::size_t>(order[k]));
    }
    judge(hand, votes);
  }
  return votes.asked > 0 ? votes.held / votes.asked : 0;
}

JointOrder joint_order_of(const Table<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key) {
  const std::string& said = conventions.joint_order.empty() ? in_file : conventions.joint_order;
  if (!said.empty()) {
    const KeypointOrder* const order = keypoint_order(said);
    if (order == nullptr) {
      throw InputError(
          fmt::format("{}: joint_order: '{}' is none; there are {}", file, said, orders_with(0)));
    }
    if (order->joints != joints.cols) {
      throw InputError(fmt::format("{}: {}: holds {} joints, the order {} has {}", file, key,
                                   joints.cols, said, order->joints));
    }
    return {order->joint, fmt::format("the order {}, as was said", said)};
  }
  const KeypointOrder *best = nullptr, *next = nullptr;
  double best_share = 0, next_share = 0;
  for (const KeypointOrder& order : keypoint_orders()) {
    if (order.joints != joints.cols || (best != nullptr && order.joint == best->joint)) continue;
    const double share = likeness_to_a_hand(joints, order.joint);
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
    ask(file, key, fmt::format("no order has {} joints: name them in {}_names", joints.cols, key),
        0, "openpose");
  }
  const JointOrder found{best->joint, fmt::format("the order {}, by the number of joints and how "
                                                  "they lie",
                                                  best->name)};
  if (!conventions.judged) return found;
  if (best_share < kIsAHand) {
    ask(file, key,
        fmt::format("{} joints, which are a hand in no order of as many (most like one, by {:.0f} "
                    "%: {})",
                    joints.cols, 100 * best_share, best->name),
        joints.cols, std::string(best->name));
  }
  if (next != nullptr && best_share - next_share < kDecided) {
    ask(file, key,
        fmt::format("{} joints, which are a hand in the order {} as in {}", joints.cols, best->name,
                    next->name),
        joints.cols, std::string(best->name));
  }
  return found;
}

}  // namespace morphe::imports
