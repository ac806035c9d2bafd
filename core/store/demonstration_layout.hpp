#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "core/motion/demonstration.hpp"
#include "core/store/layout.hpp"
#include "core/store/scene_layout.hpp"

namespace morphe::store {

/// A group that is there if the stream is; reading makes the stream.
template <class Io, class Stream, class Body>
void lay_out_stream(Io& io, const char* name, Stream& stream, const Body& body) {
  io.group_if(stream.has_value(), name, [&](Io& inner) {
    if constexpr (Io::reading) stream.emplace();
    body(inner, *stream);
  });
}

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
    in.maybe_true("rebuilt", stream.rebuilt);
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

inline bool any(const Streams& s) {
  return s.markers || s.sensors || s.skeleton || s.arm_angles || s.hand;
}

/// /demonstrations/<name> of docs/formats.md. What a file of others may leave out keeps its
/// default.
template <class Io, class T>
void lay_out_demonstration(Io& io, T& demo) {
  io.maybe("subject", demo.subject);
  io.maybe("task", demo.task);
  io.maybe("hand", demo.hand);
  io.maybe("source", demo.source);
  io.maybe("licence", demo.licence);
  io.maybe("upper_arm", demo.upper_arm);
  io.maybe("forearm", demo.forearm);
  io.maybe("hand_length", demo.hand_length);
  io.maybe("hand_breadth", demo.hand_breadth);
  lay_out_streams(io, demo.streams);
  io.group_if(any(demo.calibration) || demo.sensor_offsets.has_value(), "calibration", [&](Io& in) {
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
  io.names_if_any("reports", demo.reports);
}

}  // namespace morphe::store
