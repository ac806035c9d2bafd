#pragma once

#include "core/human/anthropometry.hpp"
#include "pipeline/synthesize/hand_postures.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A person at a table (top z = 0, origin at its near edge in front of the middle of the body).
struct Subject {
  /// The measures of the body.
  human::Anthropometry body;
  /// human_hand() of the person.
  RobotModel hand;
  /// The postures of the hand.
  HandPostures postures;
  /// The position of the shoulder [m].
  Vec3 shoulder = Vec3::Zero();
};
/// Draws a subject. Measures are correlated with stature: z = 0.8 z_stature + 0.6 of an independent
/// value.
Subject draw_subject(const SyntheticSubject& options, math::RandomStream& random);

}  // namespace morphe::synthesize
