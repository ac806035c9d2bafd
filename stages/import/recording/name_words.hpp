#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// A word in the name of a file, a folder or a marker.
struct NameWord {
  std::string text;     ///< in lower case; a number without its leading zeros
  std::size_t end = 0;  ///< end of the word in the name: index after its last byte
  /// True for a run of digits.
  bool number = false;
  /// Compares the texts only.
  bool operator==(const NameWord& other) const { return text == other.text; }
};

/// Splits a name into words: runs of letters and runs of digits; a capital after a small letter
/// starts a new word. "ADL001DR2" is adl 1 dr 2, "RElbow" is r elbow, "T-pose 01" is t pose 1.
std::vector<NameWord> split_name(std::string_view name);

/// The name of a static trial. Static trials are called static, calib, cal, tpose, neutral and the
/// like.
struct StaticTrialName {
  bool is_static = false;              ///< true if it is that of a static trial
  std::vector<NameWord> person_words;  ///< "ADL001" of "ADL001_static"; empty for "Static 01"
};
/// Parses the name of a file or folder as that of a static trial.
StaticTrialName parse_static_name(std::string_view name);

/// Returns true for a folder of sessions, trials or raw data, which does not name a person.
bool is_generic_folder_name(std::string_view folder);

/// Compares names in natural order: 2 before 10.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace morphe::imports
