#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// The confidence in a guess.
enum class Confidence : std::uint8_t { guessed, likely, sure };
/// Returns the names of the levels.
constexpr std::array<std::string_view, 3> names_of(Confidence) {
  return {"a guess", "likely", "sure"};
}

/// A value that was computed from the data, with its confidence and reason.
struct Guess {
  std::string value;  ///< "" if the data do not determine it
  Confidence confidence = Confidence::guessed;
  std::string reason;  ///< half a sentence
};

/// The handedness of recorded axes; data in left-handed ones are the mirror image of a body.
enum class Handedness : std::uint8_t { right, left };

/// Guesses the recorded axes that point right, forward and up, as in Conventions::axes: of the 24
/// choices of this handedness the one that agrees best with the cues of trunk and arms
/// (body_cues.hpp).
Guess guess_axes(const RecordedPoints& points, Handedness handedness = Handedness::right);

/// The agreement of the axes that guess_axes() finds for either handedness: the weighted mean of
/// the cosines between the recorded cues and their usual directions, up to 1; NaN if there are no
/// cues.
struct AxesAgreement {
  double right_handed = kUnknown, left_handed = kUnknown;
};

/// Computes the agreement of the best axes.
AxesAgreement axes_agreement(const RecordedPoints& points);

/// The vertical of a recorded body.
struct BodyVertical {
  Vec3 up = unknown_point();    ///< unit vector in the recorded axes; unseen without two cues
  double agreement = kUnknown;  ///< of the rotation, as of AxesAgreement
  bool trunk_known = false;     ///< true if a cue is the trunk's, not only an arm's
};

/// Returns the direction that is up for the rotation, not only of whole axes, that agrees best with
/// the directed cues of trunk and arms.
BodyVertical body_vertical(const RecordedPoints& points);

/// Guesses the unit of length, as in Conventions::unit: the one of mm, cm, m, in and ft with which
/// upper arm, forearm, shoulders, hand and fingers have usual lengths; if none fits them all, the
/// one that fits most of them, and the reason says that the names cannot be right. Without such
/// lengths, it is the one of mm, cm and m that fits the extent of all points.
Guess guess_unit(const RecordedPoints& points);

/// Guesses the frames per second: the usual rate with which the fastest points of 5 % of the frames
/// exceed 1 m/s. Times are not used; `unit_m` is the length of one recorded unit [m].
Guess guess_rate(const RecordedPoints& points, double unit_m);

}  // namespace morphe::imports
