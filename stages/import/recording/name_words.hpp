#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// A word of a file's, a folder's or a marker's name.
struct NameWord {
  std::string text;     ///< in lower case; a number without its leading zeros
  std::size_t end = 0;  ///< behind its last byte in the name
  bool number = false;
  bool operator==(const NameWord& other) const { return text == other.text; }
};

/// The words of a name: runs of letters and runs of digits, and what begins with a capital behind a
/// small letter. "ADL001DR2" is adl 1 dr 2, "RElbow" is r elbow, "T-pose 01" is t pose 1.
std::vector<NameWord> words_of(std::string_view name);

/// What the name of a static trial tells. Static trials are called static, calib, cal, tpose,
/// neutral and the like.
struct StaticName {
  bool is_static = false;
  std::vector<NameWord> whose;  ///< "ADL001" of "ADL001_static"; nothing of "Static 01"
};
StaticName read_static_name(std::string_view name);

/// A folder of sessions, of trials, of raw data: one that names nobody.
bool names_nobody(std::string_view folder);

/// Natural order: 2 before 10.
bool comes_before(std::string_view a, std::string_view b);

}  // namespace morphe::imports
