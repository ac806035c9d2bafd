#include "stages/import/formats/mot_columns.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

/// The words or ends of names that show a quantity. OpenSim's own names, and those of the scripts
/// that write its files.
struct Quantity {
  const char* name;
  std::vector<std::string_view> words;  ///< between separators or at the borders of the name
  std::vector<std::string_view> ends;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {"muscle states",
       {"activation", "activations", "excitation", "excitations", "emg", "fiber", "fibre", "tendon",
        "muscle", "pennation"},
       {"fiber_length", "fiber_velocity", "activations"}},
      {"forces and moments",
       {"force", "forces", "torque", "torques", "moment", "moments", "grf", "grm", "reaction",
        "reserve", "residual", "power", "powers", "work"},
       {"_fx", "_fy", "_fz", "_mx", "_my", "_mz"}},
      {"speeds",
       {"speed", "speeds", "velocity", "velocities", "acceleration", "accelerations", "vel", "acc"},
       {"_u", "_dot"}},
      {"translations",
       {"trans", "translation", "translations", "tx", "ty", "tz"},
       {"_tx", "_ty", "_tz", "trans", "transx", "transy", "transz"}},
      {"positions",
       {"cop", "com", "position", "positions", "center_of_mass"},
       {"_px", "_py", "_pz", "_copx", "_copy", "_copz"}},
      {"rotations of bodies", {"ox", "oy", "oz"}, {}},
  };
  return all;
}

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (std::string_view("_/.|: -").find(c) != std::string_view::npos) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace

std::string mot_contents(std::string_view title) {
  static constexpr std::array<std::array<std::string_view, 2>, 10> kTitles = {{
      {"static optimization", "muscle forces or activations"},
      {"static optimisation", "muscle forces or activations"},
      {"inverse dynamics", "forces and moments"},
      {"joint reaction", "forces and moments"},
      {"modelcontrols", "muscle excitations"},
      {"controls", "muscle excitations"},
      {"accelerations", "accelerations"},
      {"speeds", "speeds"},
      {"bodykinematics", "positions of bodies"},
      {"positions", "positions of bodies"},
  }};
  const std::string lower = to_lower(title);
  for (const auto& [word, contents] : kTitles) {
    if (lower.find(word) != std::string::npos) return std::string(contents);
  }
  return "";
}

std::string mot_quantity(std::string_view column) {
  const std::string name = to_lower(column);
  const std::vector<std::string> words = words_of(name);
  for (const Quantity& quantity : quantities()) {
    const bool has_word = std::ranges::any_of(words, [&](const std::string& word) {
      return std::ranges::find(quantity.words, word) != quantity.words.end();
    });
    const bool has_end = std::ranges::any_of(
        quantity.ends, [&](std::string_view end) { return name.ends_with(end); });
    if (has_word || has_end) return quantity.name;
  }
  return "";
}

std::string mot_joint(const std::string& column) {
  const std::size_t value = column.rfind("/value");
  if (value == std::string::npos || value + 6 != column.size()) return column;
  const std::size_t slash = column.rfind('/', value - 1);
  return column.substr(slash + 1, value - slash - 1);  // npos + 1 is 0
}

}  // namespace morphe::imports
