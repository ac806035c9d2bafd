#pragma once

#include <fmt/format.h>

#include <string>

namespace morphe {

/// Returns "1.85–2.81 s", or "at 1.85 s" if both ends are the same in print.
inline std::string interval_text(double begin_s, double end_s) {
  const std::string begin = fmt::format("{:.2f}", begin_s);
  const std::string end = fmt::format("{:.2f}", end_s);
  return begin == end ? "at " + begin + " s" : begin + "–" + end + " s";
}

}  // namespace morphe
