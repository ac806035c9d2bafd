#include "stages/import/recording/name_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace morphe::imports {
namespace {

constexpr std::array<std::string_view, 11> kStaticWords{
    "stat",     "cal",        "tpose",    "apose",     "npose",   "neutral",
    "anatomic", "anatomical", "standing", "reference", "statisch"};
/// Prefixes of "pose", as in "T pose" and "rest pose".
constexpr std::array<std::string_view, 5> kPosePrefixes{"t", "a", "n", "rest", "i"};
/// Words that also count as parts of longer ones: "adlstatic", "calibration".
constexpr std::array<std::string_view, 2> kStaticSubstrings{"static", "calib"};
constexpr std::array<std::string_view, 14> kCounterWords{
    "trial", "trials",  "take", "capture", "cap", "rec",   "recording",
    "file",  "session", "ses",  "sess",    "day", "visit", "block"};
constexpr std::array<std::string_view, 18> kGenericWords{
    "data",   "raw",     "csv",   "c3d",  "trc",       "bvh", "mocap",   "vicon",      "motion",
    "export", "exports", "right", "left", "condition", "run", "dynamic", "recordings", "processed"};

template <std::size_t N>
bool is_listed(const std::array<std::string_view, N>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

enum class CharClass { other, small, capital, digit };

/// Returns the class of a character; bytes of other alphabets count as small letters.
CharClass letter_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x80) return CharClass::small;
  if (std::isdigit(byte) != 0) return CharClass::digit;
  if (std::isupper(byte) != 0) return CharClass::capital;
  return std::islower(byte) != 0 ? CharClass::small : CharClass::other;
}

/// Returns true if a word ends before index i of the name.
bool ends_before(std::string_view name, std::size_t i) {
  const CharClass before = letter_of(name[i - 1]), here = letter_of(name[i]);
  if (here == CharClass::other) return true;
  if ((before == CharClass::digit) != (here == CharClass::digit)) return true;
  if (before == CharClass::small && here == CharClass::capital) return true;
  return before == CharClass::capital && here == CharClass::capital && i + 1 < name.size() &&
         letter_of(name[i + 1]) == CharClass::small;
}

NameWord make_word(std::string_view text, std::size_t end) {
  NameWord word{std::string(text), end, letter_of(text[0]) == CharClass::digit};
  if (word.number) {
    word.text.erase(0, std::min(word.text.find_first_not_of('0'), word.text.size() - 1));
  }
  std::ranges::transform(word.text, word.text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return word;
}

/// Removes counters such as "trial 3", which are not part of a person's name.
void remove_counters(std::vector<NameWord>& words) {
  for (std::size_t i = 0; i < words.size();) {
    if (!is_listed(kCounterWords, words[i].text)) {
      ++i;
      continue;
    }
    const auto here = words.begin() + i;
    words.erase(here, i + 1 < words.size() && words[i + 1].number ? here + 2 : here + 1);
  }
}

}  // namespace

std::vector<NameWord> split_name(std::string_view name) {
  std::vector<NameWord> words;
  for (std::size_t begin = 0; begin < name.size();) {
    if (letter_of(name[begin]) == CharClass::other) {
      ++begin;
      continue;
    }
    std::size_t end = begin + 1;
    while (end < name.size() && !ends_before(name, end)) ++end;
    words.push_back(make_word(name.substr(begin, end - begin), end));
    begin = end;
  }
  return words;
}

StaticTrialName parse_static_name(std::string_view name) {
  const std::vector<NameWord> words = split_name(name);
  StaticTrialName found;
  std::size_t at = 0;
  std::size_t behind = words.size();
  for (; at < words.size() && !found.is_static; ++at) {
    const std::string& word = words[at].text;
    const bool pose =
        at + 1 < words.size() && words[at + 1].text == "pose" && is_listed(kPosePrefixes, word);
    std::size_t part = std::string::npos;
    for (const std::string_view one : kStaticSubstrings) part = std::min(part, word.find(one));
    if (!pose && part == std::string::npos && !is_listed(kStaticWords, word)) {
      found.person_words.push_back(words[at]);
      continue;
    }
    found.is_static = true;
    behind = at + (pose ? 2 : 1);
    if (part != std::string::npos && part > 0) {
      found.person_words.push_back(
          {word.substr(0, part), words[at].end - word.size() + part, false});
    }
  }
  remove_counters(found.person_words);
  if (!found.is_static || !found.person_words.empty()) return found;
  // The number in "Static 01" is a counter.
  while (behind < words.size() && words[behind].number) ++behind;
  found.person_words.assign(words.begin() + behind, words.end());
  remove_counters(found.person_words);
  return found;
}

bool is_generic_folder_name(std::string_view folder) {
  const std::vector<NameWord> words = split_name(folder);
  return std::ranges::all_of(words, [](const NameWord& word) {
    return word.number || is_listed(kGenericWords, word.text) ||
           is_listed(kCounterWords, word.text);
  });
}

bool natural_less(std::string_view a, std::string_view b) {
  const std::vector<NameWord> first = split_name(a), second = split_name(b);
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    const NameWord &one = first[i], &other = second[i];
    if (one == other) continue;
    if (one.number && other.number && one.text.size() != other.text.size()) {
      return one.text.size() < other.text.size();
    }
    return one.text < other.text;
  }
  return first.size() != second.size() ? first.size() < second.size() : a < b;
}

}  // namespace morphe::imports
