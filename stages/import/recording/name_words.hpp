#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// The class of a byte of a UTF-8 name; bytes of letters outside ASCII count as small letters.
enum class CharClass { other, small, capital, digit };
CharClass char_class(char c);

/// A word in the name of a file, a folder or a marker.
struct NameWord {
  std::string text;     ///< in lower case; a number without its leading zeros
  std::size_t end = 0;  ///< index in the name after the word's last byte
  bool number = false;  ///< true for a run of digits
  bool operator==(const NameWord& other) const { return text == other.text; }
};

/// Splits a name into runs of letters and of digits. A capital begins a new word after a small
/// letter, and before one. "ADL001DR2" is adl 1 dr 2, "RElbow" r elbow, "T-pose 01" t pose 1.
std::vector<NameWord> split_name(std::string_view name);

/// The interpretation of a name that may be that of a static trial.
struct StaticTrialName {
  bool is_static = false;  ///< true if it has a word such as static, calib, cal, tpose or neutral
  std::vector<NameWord> person_words;  ///< adl 1 for "ADL001_static"; empty for "Static 01"
};
/// Parses the name of a file or folder as that of a static trial.
StaticTrialName parse_static_name(std::string_view name);

/// Returns true for the name of a folder of sessions, trials or raw data, which names no person.
bool is_generic_folder_name(std::string_view folder);

/// Returns true if a precedes b in natural order, in which 2 precedes 10.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace morphe::imports
