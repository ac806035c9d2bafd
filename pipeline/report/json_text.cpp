#include "pipeline/report/json_text.hpp"

namespace morphe::report {

std::string json_text(const nlohmann::ordered_json& json) {
  using nlohmann::ordered_json;
  std::string text;
  // These three characters occur in JSON only inside strings.
  for (const char c : json.dump(-1, ' ', false, ordered_json::error_handler_t::replace)) {
    if (c == '<')
      text += "\\u003c";
    else if (c == '>')
      text += "\\u003e";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  }
  return text;
}

}  // namespace morphe::report
