#include "stages/import/recording/name_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr std::array<std::string_view, 11> kStaticWords{
    "stat",     "cal",        "tpose",    "apose",     "npose",   "neutral",
    "anatomic", "anatomical", "standing", "reference", "statisch"};
/// Words that make a static trial of a following "pose": "T pose", "rest pose".
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

/// Returns true if a word ends before index i of the name.
bool ends_before(std::string_view name, std::size_t i) {
  const CharClass before = char_class(name[i - 1]), here = char_class(name[i]);
  if (here == CharClass::other) return true;
  if ((before == CharClass::digit) != (here == CharClass::digit)) return true;
  if (before == CharClass::small && here == CharClass::capital) return true;
  return before == CharClass::capital && here == CharClass::capital && i + 1 < name.size() &&
         char_class(name[i + 1]) == CharClass::small;
}

NameWord make_word(std::string_view text, std::size_t end) {
  NameWord word{to_lower(text), end, char_class(text[0]) == CharClass::digit};
  if (word.number)
    word.text.erase(0, std::min(word.text.find_first_not_of('0'), word.text.size() - 1));
  return word;
}

/// Removes counters such as "trial 3", which are not part of a person's name.
void remove_counters(std::vector<NameWord>& words) {
  for (std::size_t i = 0; i < words.size();) {
    if (!is_listed(kCounterWords, words[i].text)) {
      ++i;
      continue;
    }
    const auto counter = words.begin() + i;
    words.erase(counter, i + 1 < words.size() && words[i + 1].number ? counter + 2 : counter + 1);
  }
}

}  // namespace

CharClass char_class(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x80 || std::islower(byte) != 0) return CharClass::small;
  if (std::isdigit(byte) != 0) return CharClass::digit;
  return std::isupper(byte) != 0 ? CharClass::capital : CharClass::other;
}

std::vector<NameWord> split_name(std::string_view name) {
  std::vector<NameWord> words;
  for (std::size_t begin = 0; begin < name.size();) {
    if (char_class(name[begin]) == CharClass::other) {
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
  StaticTrialName result;
  auto word = words.begin();
  for (; word != words.end() && !result.is_static; ++word) {
    const std::string& text = word->text;
    const bool pose =
        word + 1 != words.end() && word[1].text == "pose" && is_listed(kPosePrefixes, text);
    std::size_t cut = std::string::npos;  // index of "static" or "calib" in text
    for (const std::string_view part : kStaticSubstrings) cut = std::min(cut, text.find(part));
    result.is_static = pose || cut != std::string::npos || is_listed(kStaticWords, text);
    if (!result.is_static) result.person_words.push_back(*word);
    if (cut != std::string::npos && cut > 0)
      result.person_words.push_back({text.substr(0, cut), word->end - text.size() + cut, false});
    if (pose) ++word;
  }
  remove_counters(result.person_words);
  if (!result.is_static || !result.person_words.empty()) return result;
  // The number in "Static 01" is a counter.
  result.person_words.assign(
      std::find_if_not(word, words.end(), [](const NameWord& behind) { return behind.number; }),
      words.end());
  remove_counters(result.person_words);
  return result;
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
    if (one.number && other.number && one.text.size() != other.text.size())
      return one.text.size() < other.text.size();
    return one.text < other.text;
  }
  return first.size() != second.size() ? first.size() < second.size() : a < b;
}

}  // namespace morphe::imports
