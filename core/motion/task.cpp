#include "core/motion/task.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

namespace morphe {
namespace {

/// Stems of words for tasks in which the hand takes a thing and carries it.
constexpr std::string_view kTaking[] = {"carr",  "drink", "drank",    "eat", "fetch", "grab",
                                        "grasp", "grip",  "lift",     "mov", "pick",  "pinch",
                                        "plac",  "pour",  "put",      "sip", "stack", "tak",
                                        "throw", "took",  "transport"};
/// Stems of words for tasks in which the hand touches a place, or its own body, or gestures.
constexpr std::string_view kTouching[] = {"brush", "comb", "gestur", "point", "press", "push",
                                          "reach", "tap",  "touch",  "wave",  "waving"};
/// Limbs: who lifts an arm takes nothing.
constexpr std::string_view kLimbs[] = {"arm",  "elbow", "finger", "foot", "hand",
                                       "head", "knee",  "leg",    "palm", "shoulder"};
constexpr std::string_view kArticles[] = {"a",   "an", "both",  "her", "his", "left",
                                          "one", "my", "right", "the", "your"};
/// Endings of a stem: "drink", "drinks", "drinking", "carried", "grasped", "picked".
constexpr std::string_view kEndings[] = {"",    "s",    "e",    "es",  "ed",   "ing", "y",   "ies",
                                         "ied", "ying", "ping", "ped", "bing", "bed", "ting"};

bool is_form_of(std::string_view word, std::string_view stem) {
  return word.starts_with(stem) &&
         std::ranges::find(kEndings, word.substr(stem.size())) != std::end(kEndings);
}

template <std::size_t N>
bool is_form_of_any(std::string_view word, const std::string_view (&stems)[N]) {
  return std::ranges::any_of(stems, [&](std::string_view stem) { return is_form_of(word, stem); });
}

}  // namespace

TaskKind kind_of_task(std::string_view task) {
  TaskKind kind = TaskKind::unknown;
  bool takes = false;  // the last word but articles takes something
  std::string word;
  for (std::size_t i = 0; i <= task.size(); ++i) {
    const auto c = static_cast<unsigned char>(i < task.size() ? task[i] : ' ');
    if (std::isalpha(c) != 0) {
      word += static_cast<char>(std::tolower(c));
      continue;
    }
    const bool article = word.empty() || std::ranges::find(kArticles, word) != std::end(kArticles);
    if (takes && !article && !is_form_of_any(word, kLimbs)) return TaskKind::takes_object;
    if (!article) takes = is_form_of_any(word, kTaking);
    if (is_form_of_any(word, kTouching)) kind = TaskKind::touches;
    word.clear();
  }
  return takes ? TaskKind::takes_object : kind;
}

bool contains_word(std::string_view task, std::string_view word) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; !word.empty() && i + word.size() <= task.size(); ++i) {
    const std::size_t end = i + word.size();
    const bool bounded =
        (i == 0 || !is_letter(task[i - 1])) && (end == task.size() || !is_letter(task[end]));
    if (bounded && std::ranges::equal(task.substr(i, word.size()), word, {}, lower, lower))
      return true;
  }
  return false;
}

}  // namespace morphe
