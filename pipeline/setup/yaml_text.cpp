#include "pipeline/setup/yaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace morphe::setup {

std::string yaml_name(const std::string& name) {
  static constexpr std::array kWords = {"true", "false", "yes", "no", "on",
                                        "off",  "null",  "y",   "n"};
  std::string lower = name;
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool plain =
      !name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) || name[0] == '_') &&
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (plain && std::ranges::find(kWords, lower) == kWords.end()) return name;
  std::string quoted = "'";
  for (const char c : name) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string yaml_number(double value) {
  std::string text = fmt::format("{:.6f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string yaml_vector(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", yaml_number(v.x()), yaml_number(v.y()), yaml_number(v.z()));
}

std::string yaml_mount(const Pose& pose) {
  Quat q(pose.linear());
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const auto digits = [](double value) {
    std::string text = fmt::format("{:.10f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? std::string("0") : text;
  };
  return fmt::format("{{position: {}, quaternion: [{}, {}, {}, {}]}}",
                     yaml_vector(pose.translation()), digits(q.w()), digits(q.x()), digits(q.y()),
                     digits(q.z()));
}

}  // namespace morphe::setup
