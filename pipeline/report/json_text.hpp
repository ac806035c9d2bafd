#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace morphe::report {

/// Returns JSON that can be placed inside an HTML script element: '<', '>' and '&' are written as
/// \u escapes. Invalid UTF-8 is replaced; a number that is not finite becomes null.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace morphe::report
