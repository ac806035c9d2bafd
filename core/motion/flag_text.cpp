#include "core/motion/flag_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/motion/interval_text.hpp"

namespace morphe {

std::string sentence(const RecordingFlag& flag) {
  const std::string response =
      flag.response == FlagResponse::flagged ? "" : fmt::format(" ({})", name_of(flag.response));
  const std::string interval = std::isnan(flag.begin_s) || std::isnan(flag.end_s)
                                   ? ""
                                   : ", " + interval_text(flag.begin_s, flag.end_s);
  return fmt::format("{}{}{}: {}", name_of(flag.code), response, interval, flag.text);
}

}  // namespace morphe
