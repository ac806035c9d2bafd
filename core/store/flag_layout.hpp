#pragma once

#include <string>
#include <vector>

#include "core/motion/recording_flag.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Lays out the flags of a recording or of a movement, in a group of their own.
template <class Io, class T>
void lay_out_flags(Io& io, T& flags) {
  io.group_if(!flags.empty(), "flags", [&](Io& in) {
    in.column("code", flags, &RecordingFlag::code, {});
    in.column("response", flags, &RecordingFlag::response, {});
    in.column("begin_s", flags, &RecordingFlag::begin_s, {"s", "", ""});
    in.column("end_s", flags, &RecordingFlag::end_s, {"s", "", ""});
    in.column("subject", flags, &RecordingFlag::subject, {});
    in.column("value", flags, &RecordingFlag::value, {"unit of the row", "", ""});
    in.column("limit", flags, &RecordingFlag::limit, {"unit of the row", "", ""});
    in.column("unit", flags, &RecordingFlag::unit, {});
    in.column("text", flags, &RecordingFlag::text, {});
  });
}

}  // namespace morphe::store
