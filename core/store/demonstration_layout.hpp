#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "core/motion/demonstration.hpp"
#include "core/store/assumption_layout.hpp"
#include "core/store/flag_layout.hpp"
#include "core/store/layout.hpp"
#include "core/store/scene_layout.hpp"

namespace morphe::store {

/// Lays out a group that is present if the stream is; reading creates the stream.
template <class Io, class Stream, class Body>
void lay_out_stream(Io& io, const char* name, Stream& stream, const Body& body) {
  io.group_if(stream.has_value(), name, [&](Io& inner) {
    if constexpr (Io::reading) stream.emplace();
    body(inner, *stream);
  });
}

/// Lays out the streams of a recording.
template <class Io, class T>
void lay_out_streams(Io& io, T& streams) {
  const std::string world = "world";
  lay_out_stream(io, "markers", streams.markers, [&](Io& in, auto& stream) {
    in.attribute("names", stream.names);
    in.dataset("time", stream.time, {"s", "", ""});
    in.dataset("position", stream.position, {"m", world, ""});
  });
  const auto bodies = [&](Io& in, auto& stream) {
    in.attribute("names", stream.names);
    in.dataset("time", stream.time, {"s", "", ""});
    in.dataset("position", stream.position, {"m", world, ""});
    in.dataset("orientation", stream.orientation, {"1", world, ""});
    in.dataset_if(stream.confidence.rows > 0, "confidence", stream.confidence, {"1", "", ""});
  };
  lay_out_stream(io, "sensors", streams.sensors, bodies);
  lay_out_stream(io, "skeleton", streams.skeleton, [&](Io& in, auto& stream) {
    in.attribute("parents", stream.parents);
    in.optional_flag("reconstructed", stream.reconstructed);
    bodies(in, stream);
  });
  lay_out_stream(io, "arm_angles", streams.arm_angles, [&](Io& in, auto& stream) {
    in.attribute("joints", stream.joints);
    in.dataset("time", stream.time, {"s", "", ""});
    in.dataset("angles", stream.angles, {"rad", "", ""});
  });
  lay_out_stream(io, "hand", streams.hand, [&](Io& in, auto& stream) {
    in.attribute("kind", stream.kind);
    in.dataset("time", stream.time, {"s", "", ""});
    if (stream.kind == HandKind::glove) in.attribute("sensors", stream.names);
    if (stream.kind == HandKind::joint_angles) in.attribute("joints", stream.names);
    if (stream.kind == HandKind::glove || stream.kind == HandKind::joint_angles) {
      in.dataset("angles", stream.angles, {"rad", "", ""});
    } else {
      in.dataset("position", stream.position, {"m", world, ""});
    }
  });
}

/// Returns true if at least one stream is present.
inline bool has_streams(const Streams& s) {
  return s.markers || s.sensors || s.skeleton || s.arm_angles || s.hand;
}

/// Lays out /demonstrations/<name> of docs/formats.md. Items that files of other programs omit keep
/// their defaults.
template <class Io, class T>
void lay_out_demonstration(Io& io, T& demo) {
  io.optional_attribute("subject", demo.subject);
  io.optional_attribute("task", demo.task);
  io.optional_attribute("hand", demo.hand);
  io.optional_attribute("source", demo.source);
  io.optional_attribute("licence", demo.licence);
  io.optional_attribute("upper_arm", demo.upper_arm);
  io.optional_attribute("forearm", demo.forearm);
  io.optional_attribute("hand_length", demo.hand_length);
  io.optional_attribute("hand_breadth", demo.hand_breadth);
  lay_out_streams(io, demo.streams);
  io.group_if(has_streams(demo.calibration) || demo.sensor_offsets.has_value(), "calibration",
              [&](Io& in) {
                lay_out_streams(in, demo.calibration);
                lay_out_stream(in, "offsets", demo.sensor_offsets, [](Io& inner, auto& offsets) {
                  inner.attribute("sensors", offsets.sensors);
                  inner.dataset("position", offsets.joint_in_sensor, {"m", "sensor", ""});
                  inner.dataset("orientation", offsets.sensor_from_segment, {"1", "sensor", ""});
                });
              });
  io.group_if(!demo.objects.empty(), "objects", [&](Io& in) {
    in.each(demo.objects, [](Io& inner, auto& object) { lay_out_object(inner, object, "world"); });
  });
  io.group_if(!demo.labels.empty(), "labels", [&](Io& in) {
    in.column("begin_s", demo.labels, &Label::begin_s, {"s", "", ""});
    in.column("end_s", demo.labels, &Label::end_s, {"s", "", ""});
    in.column("phase", demo.labels, &Label::phase, {});
  });
  lay_out_flags(io, demo.flags);
  io.group_if(!demo.accepted_flags.empty(), "accepted_flags",
              [&](Io& in) { in.column("code", demo.accepted_flags, &AcceptedFlag::code, {}); });
  io.optional_names("import_notes", demo.import_notes);
  lay_out_assumptions(io, demo.assumptions);
}

}  // namespace morphe::store
