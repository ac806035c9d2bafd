#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::imports {

/// The source of the forward direction: the body, regardless of the recorded axes, or the axes.
enum class ForwardSource : std::uint8_t { body, recorded };
/// Returns the names of the sources.
constexpr std::array<std::string_view, 2> names_of(ForwardSource) { return {"body", "recorded"}; }

/// Conventions that a recording's file may not contain, from the command line or a manifest.
struct Conventions {
  /// The recorded axes that point to the subject's right, forward and up: "x y z", "-z -x y".
  std::string axes;
  std::string unit;  ///< of lengths, as length_unit() reads it, or metres per unit
  std::optional<double> rate_hz;
  std::string joint_order = {};                 ///< of a clip's hands: KeypointOrder::name
  bool plausibility_checks = true;              ///< false while a recording is only inspected
  ForwardSource forward = ForwardSource::body;  ///< for align_heading()
};

/// A convention that is neither in the file nor in Conventions, or that has an implausible value.
struct UnresolvedConvention : InputError {
  UnresolvedConvention(std::string key_, const std::string& message)
      : InputError(message), key(std::move(key_)) {}
  std::string key;  ///< field of Conventions: "axes", "unit", "rate" or "joint_order"
  /// The joint order that fits best; the usual axes of the format; or "".
  std::string likely_value;
};

/// Returns the rotation from recorded coordinates to the world (X right, Y forward, Z up), or a
/// reflection if the recorded frame is left-handed; row k selects the axis that the k-th word of
/// `axes` names. Throws InputError, prefixed by `source`, unless the words are three different
/// axes.
Eigen::Matrix3d world_from_points(const std::string& axes, const std::string& source);

/// Returns the same for a recording with orientations, which a reflection cannot transform. Throws
/// InputError also if the frame is left-handed.
Eigen::Matrix3d world_from_recorded(const std::string& axes, const std::string& source);

/// Throws UnresolvedConvention "axes" for the file `source`. The message contains `why`, ", and …".
/// `usual` are the axes to propose if the recording does not tell.
[[noreturn]] void throw_unknown_axes(const std::string& source, const std::string& why = "",
                                     const std::string& usual = "");

/// Returns the coordinate axis nearest to a direction, as a word of `axes`, such as "-y".
std::string axis_word(const Vec3& direction);

/// Returns the metres in one unit. Throws InputError prefixed by `source` if the unit is unknown.
double metres_per_unit(const std::string& unit, const std::string& source);

/// Returns the metres in one unit: that of `conventions` or, without, `in_file` ("" if absent). A
/// difference is reported. Throws UnresolvedConvention, prefixed by `source`, if the first is
/// absent and the second absent or unknown.
double resolve_unit_m(const std::string& in_file, const Conventions& conventions,
                      const std::string& source, std::vector<std::string>& reports);
/// Returns the frames per second of a file in the same way; `in_file` is 0 if absent.
double resolve_rate_hz(double in_file, const Conventions& conventions, const std::string& source,
                       std::vector<std::string>& reports);

}  // namespace morphe::imports
