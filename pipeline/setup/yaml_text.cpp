#include "pipeline/setup/yaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace morphe::setup {
namespace {

std::string with_decimals(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string yaml_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string yaml_name(const std::string& name) {
  static constexpr std::array kWords = {"true", "false", "yes", "no", "on",
                                        "off",  "null",  "y",   "n"};
  const bool plain =
      !name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) || name[0] == '_') &&
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (plain && std::ranges::find(kWords, lower_case(name)) == kWords.end()) return name;
  return yaml_text(name);
}

std::string yaml_number(double value) { return with_decimals(value, 6); }

std::string yaml_vector(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", yaml_number(v.x()), yaml_number(v.y()), yaml_number(v.z()));
}

std::string yaml_mount(const Pose& pose) {
  Quat q(pose.linear());
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const auto digits = [](double value) { return with_decimals(value, 10); };
  return fmt::format("{{position: {}, quaternion: [{}, {}, {}, {}]}}",
                     yaml_vector(pose.translation()), digits(q.w()), digits(q.x()), digits(q.y()),
                     digits(q.z()));
}

}  // namespace morphe::setup
