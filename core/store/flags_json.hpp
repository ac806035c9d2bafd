#pragma once

#include <vector>

#include "core/motion/recording_flag.hpp"
#include "core/store/flag_layout.hpp"
#include "core/store/json_layout.hpp"

namespace morphe::store {

/// Returns the flags as a list of objects, with the columns of plans.h5 as keys.
inline JsonWriter::Json flags_json(const std::vector<RecordingFlag>& flags) {
  JsonWriter io;
  lay_out_flags(io, flags);
  return flags.empty() ? JsonWriter::Json::array() : io.json.at("flags");
}

}  // namespace morphe::store
