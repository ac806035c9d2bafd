#include "stages/import/recording/column_label.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "stages/import/recording/unit_words.hpp"

namespace morphe::imports {
std::string to_lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string trim(std::string_view text, std::string_view characters) {
  const std::size_t first = text.find_first_not_of(characters);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(characters) - first + 1));
}

namespace {

constexpr std::string_view kSeparators = " _.:-/";
/// Returns the unit of length or time that a word denotes; "" for any other word.
std::string unit_of_word(std::string_view word) {
  const std::string length = length_unit(word);
  return length.empty() ? time_unit(word) : length;
}

/// Returns 0 … 3 for the letters x, y, z, w, also followed by a number; -1 for any other word.
int axis_of_word(const std::string& word) {
  constexpr std::array<char, 4> kAxes = {'x', 'y', 'z', 'w'};
  const std::string letter = to_lower(word);
  if (letter.find_first_not_of("0123456789", 1) != std::string::npos) return -1;
  for (int axis = 0; axis < std::ssize(kAxes); ++axis) {
    if (letter.starts_with(kAxes[axis])) return axis;
  }
  return -1;
}

}  // namespace

ColumnLabel split_unit(std::string label) {
  ColumnLabel result;
  for (const char* brackets : {"()", "[]"}) {
    const std::size_t open = label.find(brackets[0]);
    const std::size_t close = label.find(brackets[1], std::min(open, label.size()));
    if (close == std::string::npos) continue;
    const std::string unit = unit_of_word(label.substr(open + 1, close - open - 1));
    if (unit.empty()) continue;
    result.unit = unit;
    label.erase(open, close - open + 1);
  }
  label = trim(label, kSeparators);
  const std::size_t end = label.find_last_of(kSeparators);
  const std::string unit = end == std::string::npos ? "" : unit_of_word(label.substr(end + 1));
  if (result.unit.empty() && !unit.empty()) {
    result.unit = unit;
    label.erase(end);
  }
  result.text = trim(label, kSeparators);
  return result;
}

std::array<AxisReading, 3> readings_of(const std::string& label) {
  std::array<AxisReading, 3> readings;
  if (label.size() > 1)
    readings[2] = {label.substr(0, label.size() - 1), axis_of_word(label.substr(label.size() - 1))};
  const std::size_t first = label.find_first_of(kSeparators);
  if (first == std::string::npos) {
    if (const int axis = axis_of_word(label); axis >= 0)
      readings[0] = {label.size() > 1 ? label.substr(1) : "point", axis};
    return readings;
  }
  const std::size_t last = label.find_last_of(kSeparators);
  readings[0] = {trim(label.substr(0, last), kSeparators), axis_of_word(label.substr(last + 1))};
  readings[1] = {trim(label.substr(first + 1), kSeparators), axis_of_word(label.substr(0, first))};
  return readings;
}

bool is_other_quantity(const std::string& name) {
  static const std::set<std::string> kWords = {
      "rot",    "rotation", "euler",    "quat",    "quaternion", "orientation",  "angle",
      "angles", "vel",      "velocity", "acc",     "accel",      "acceleration", "force",
      "moment", "torque",   "forces",   "moments", "torques",    "power",        "powers",
      "gyro",   "omega",    "normal",   "mag",     "ang",        "angular"};
  std::string word;
  for (const char c : to_lower(name) + " ") {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      word += c;
    } else {
      if (kWords.contains(word)) return true;
      word.clear();
    }
  }
  return false;
}

bool is_time_label(const std::string& label) {
  static const std::set<std::string> kNames = {"time", "t",     "timestamp",  "seconds", "sec",
                                               "zeit", "temps", "time stamp", "times"};
  return kNames.contains(to_lower(trim(label, kSeparators)));
}

bool is_frame_label(const std::string& label) {
  static const std::set<std::string> kNames = {
      "frame",        "frame#",      "frames", "sample", "samples", "frame number",
      "frame_number", "framenumber", "bild",   "image",  "nr"};
  return kNames.contains(to_lower(trim(label, " ")));
}

}  // namespace morphe::imports
