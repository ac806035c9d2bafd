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
  std::string unit;  ///< unit of lengths: m, cm, mm, in, ft, or metres per unit as a number
  std::optional<double> rate_hz;  ///< frames per second
  std::string joint_order = {};   ///< joint order of a clip's hands: a name of keypoint_orders()
  /// True if sizes must be a person's; false while a recording is only inspected.
  bool plausibility_checks = true;
  ForwardSource forward = ForwardSource::body;  ///< heading.hpp
};

/// A convention that is neither in the file nor in Conventions, or that has an implausible value.
struct UnresolvedConvention : InputError {
  /// Creates the error for a field of Conventions.
  UnresolvedConvention(std::string key_, const std::string& message)
      : InputError(message), key(std::move(key_)) {}
  std::string key;           ///< field of Conventions: "axes", "unit", "rate" or "joint_order"
  std::string likely_value;  ///< for joint_order, the likeliest
};

/// Returns the rotation from recorded coordinates to the world (X right, Y forward, Z up); row k
/// selects the recorded axis that the k-th word of `axes` names. Throws InputError, prefixed by
/// `source` (a file, or the origin of the axes), unless the words are three different axes of a
/// right-handed frame.
Eigen::Matrix3d world_from_recorded(const std::string& axes, const std::string& source);

/// Returns the coordinate axis with the largest share of a direction, as a word of `axes`: "-y".
std::string axis_word(const Vec3& direction);

/// Returns the number of metres in one unit of the given name. Throws InputError prefixed by
/// `source` if the unit is unknown.
double metres_per_unit(const std::string& unit, const std::string& source);

/// Returns unit and rate of a file. Given conventions take precedence over those of the file ("" or
/// 0 if absent), which is reported if they differ. Throws InputError prefixed by `source` if
/// neither is available.
double resolve_unit_m(const std::string& in_file, const Conventions& conventions,
                      const std::string& source, std::vector<std::string>& reports);
double resolve_rate_hz(double in_file, const Conventions& conventions, const std::string& source,
                       std::vector<std::string>& reports);

}  // namespace morphe::imports
