#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "core/motion/scene.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Lays out a time that may be unknown: a missing attribute in the file, NaN in memory.
template <class Io, class Time>
void lay_out_time(Io& io, const char* name, Time& time_s) {
  std::optional<double> known;
  if (!Io::reading && !std::isnan(time_s)) known = time_s;
  io.optional_attribute(name, known);
  if constexpr (Io::reading) time_s = known.value_or(kUnknown);
}

/// Lays out the origin of a pose or shape: a missing attribute in the file if it is unknown.
template <class Io, class Origin>
void lay_out_origin(Io& io, const char* name, Origin& origin) {
  std::optional<ObjectOrigin> known;
  if (!Io::reading && origin != ObjectOrigin::unknown) known = origin;
  io.optional_attribute(name, known);
  if constexpr (Io::reading) origin = known.value_or(ObjectOrigin::unknown);
}

/// Lays out objects/<name>/ and scene/<object>/ of docs/formats.md, with poses in `frame`.
template <class Io, class T>
void lay_out_object(Io& io, T& object, const std::string& frame) {
  io.attribute("shape", object.shape);
  const bool mesh = object.shape == Shape::mesh;
  if (!mesh) io.attribute("size", object.size);
  io.dataset("time", object.time, {"s", "", ""});
  io.dataset("position", object.position, {"m", frame, ""});
  io.dataset("orientation", object.orientation, {"1", frame, ""});
  if (mesh) {
    io.dataset("vertices", object.vertices, {"m", "object", ""});
    io.dataset("triangles", object.triangles, {"1", "", ""});
  }
  if (Io::reading || !object.attached_frame.empty())
    io.optional_attribute("attached_frame", object.attached_frame);
  lay_out_time(io, "attach_s", object.attach_s);
  lay_out_time(io, "release_s", object.release_s);
  lay_out_origin(io, "pose_origin", object.pose_origin);
  lay_out_origin(io, "shape_origin", object.shape_origin);
}

}  // namespace morphe::store
