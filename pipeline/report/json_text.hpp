#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace morphe::report {

/// JSON that may stand inside an HTML script element: no '<', '>' or '&' but as \u escapes. What is
/// no UTF-8 is replaced; a number that is not finite is null.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace morphe::report
