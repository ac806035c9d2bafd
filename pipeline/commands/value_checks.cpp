#include "pipeline/commands/value_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/config/spelling_hint.hpp"

namespace morphe::commands {
namespace {

template <class Whole>
std::string whole_number_error(const std::string& text) {
  Whole value{};
  if (CLI::detail::lexical_cast(text, value)) return "";
  const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
  if (digits)
    return fmt::format("must be at most {}, not '{}'", std::numeric_limits<Whole>::max(), text);
  return fmt::format("must be a whole number{}, not '{}'",
                     std::is_unsigned_v<Whole> ? " without sign" : "", text);
}

std::string number_error(const std::string& text) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return "";
  return fmt::format("must be a number, not '{}'", text);
}

std::string value_error(const std::string& type, const std::string& text) {
  if (text.empty()) return "must not be empty";
  if (type.starts_with("INT")) return whole_number_error<int>(text);
  if (type.starts_with("UINT")) return whole_number_error<std::uint64_t>(text);
  return type.starts_with("FLOAT") ? number_error(text) : "";
}

std::string flag_error(const std::string& text) {
  return text == "true" ? "" : fmt::format("takes no value, not '{}'", text);
}

}  // namespace

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& value) -> std::string {
    if (std::ranges::find(names, value) != names.end()) return "";
    return fmt::format("must be {} or {}, not '{}'{}",
                       fmt::join(names.begin(), names.end() - 1, ", "), names.back(), value,
                       config::spelling_hint(value, names));
  };
  return {check, fmt::format("{{{}}}", fmt::join(names, ","))};
}

CLI::Validator within(const KeyBounds& bounds) {
  const auto check = [bounds](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && bounds.contain(value)) return "";
    return fmt::format("must be {}, not '{}'", text_of(bounds), text);
  };
  return {check, fmt::format("{}{} to {}{}{}", bounds.lower_open ? "above " : "", bounds.lower,
                             bounds.upper, *bounds.unit ? " " : "", bounds.unit)};
}

void check_values(CLI::App& app) {
  for (CLI::Option* const option : app.get_options()) {
    const bool flag = option->get_expected_max() == 0;
    const std::string type = option->get_type_name();
    option->transform(CLI::Validator(
        [flag, type](std::string& text) {
          return flag ? flag_error(text) : value_error(type, text);
        },
        ""));
  }
  for (CLI::App* const command : app.get_subcommands({})) check_values(*command);
}

}  // namespace morphe::commands
