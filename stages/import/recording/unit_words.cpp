#include "stages/import/recording/unit_words.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

using Synonyms = std::map<std::string, std::set<std::string, std::less<>>>;

/// Returns the key whose words, or plurals of them with s, contain the word; "" if none does.
std::string unit_in(const Synonyms& synonyms, std::string_view word) {
  const std::string lower = to_lower(trim(word, " \t.,;:()[]{}\"'"));
  const std::string_view singular = lower.size() > 3 && lower.ends_with('s')
                                        ? std::string_view(lower).substr(0, lower.size() - 1)
                                        : std::string_view(lower);
  for (const auto& [unit, words] : synonyms) {
    if (lower == unit || words.contains(lower) || words.contains(singular)) return unit;
  }
  return "";
}

}  // namespace

std::string length_unit(std::string_view word) {
  static const Synonyms kLengths = {
      {"m", {"meter", "metre", "mtr", "metro"}},
      {"dm", {"decimeter", "decimetre"}},
      {"cm", {"centimeter", "centimetre", "zentimeter", "centimetro", "cms"}},
      {"mm", {"millimeter", "millimetre", "milimeter", "milimetre", "millimetro", "mms"}},
      {"um", {"µm", "μm", "micrometer", "micrometre", "micron"}},
      {"in", {"inch", "inches"}},
      {"ft", {"foot", "feet"}}};
  return unit_in(kLengths, word);
}

std::string time_unit(std::string_view word) {
  static const Synonyms kTimes = {
      {"s", {"sec", "second", "sekunde", "sekunden", "seconde", "segundo"}},
      {"ms", {"msec", "millisec", "millisecond", "milliseconde", "millisekunde", "millisekunden"}},
      {"us", {"µs", "μs", "usec", "microsec", "microsecond"}},
      {"ns", {"nsec", "nanosec", "nanosecond"}}};
  return unit_in(kTimes, word);
}

}  // namespace morphe::imports
