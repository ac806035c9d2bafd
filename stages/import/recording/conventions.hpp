#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/named.hpp"

namespace morphe::imports {

/// What decides which way is forward: the body, whatever the axes were recorded as, or the axes.
enum class ForwardBy : std::uint8_t { body, recorded };
constexpr std::array<std::string_view, 2> names_of(ForwardBy) { return {"body", "recorded"}; }

/// What a recording's file may leave unsaid, from the command line or a manifest.
struct Conventions {
  /// The recorded axes that point to the subject's right, forward and up: "x y z", "-z -x y".
  std::string axes;
  std::string unit;               ///< of lengths: m, cm, mm, in, ft, or metres per unit as a number
  std::optional<double> rate_hz;  ///< frames a second
  std::string joint_order = {};   ///< of a clip's hands: a name of keypoint_orders()
  bool judged = true;  ///< sizes must be a person's; not so while a recording is looked at
  ForwardBy forward = ForwardBy::body;  ///< facing.hpp
};

/// Something that neither the file nor Conventions says, or says such that it cannot be right.
struct NotSaid : InputError {
  NotSaid(std::string key_, const std::string& message)
      : InputError(message), key(std::move(key_)) {}
  std::string key;     ///< of Conventions: "axes", "unit", "rate" or "joint_order"
  std::string likely;  ///< of joint_order: the likeliest
};

/// Rotation that brings a recorded point into the world (X right, Y forward, Z up); row k picks the
/// recorded axis that the k-th word of `axes` names. InputError, with `source` (a file, or what
/// gave the axes) in front, unless the words are three different axes of a right-handed frame.
Eigen::Matrix3d world_from_recorded(const std::string& axes, const std::string& source);

/// The coordinate axis with the largest share of a direction, as a word of `axes`: "-y".
std::string axis_word(const Vec3& direction);

/// Metres in one unit of the given name; InputError with `source` in front if it is none.
double metres_per_unit(const std::string& unit, const std::string& source);

/// Unit and rate of a file: what was given comes before what the file says ("" or 0 = nothing),
/// and is reported if it differs. InputError with `source` in front if neither says it.
double metres_of(const std::string& in_file, const Conventions& conventions,
                 const std::string& source, std::vector<std::string>& reports);
double rate_of(double in_file, const Conventions& conventions, const std::string& source,
               std::vector<std::string>& reports);

}  // namespace morphe::imports
