#pragma once

#include "core/human/anthropometry.hpp"
#include "pipeline/synthesize/hand_postures.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A person at a table (top z = 0, origin at its near edge in front of the middle of the body).
struct Subject {
  human::Anthropometry body;
  RobotModel hand;  ///< human_hand()
  HandPostures postures;
  Vec3 shoulder = Vec3::Zero();  ///< at rest [m]
};
/// Draws a subject. Its other measures have the standard scores z = 0.8 z_stature + 0.6 z_own,
/// within the percentiles of the options.
Subject draw_subject(const SyntheticSubject& options, math::RandomStream& random);

}  // namespace morphe::synthesize
