#pragma once

#include "core/human/anthropometry.hpp"
#include "pipeline/synthesize/hand_postures.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// One person at a table (top z = 0, origin on its near edge before the middle of the body).
struct Subject {
  human::Anthropometry body;
  RobotTable hand;  ///< human_hand()
  HandPostures postures;
  Vec3 shoulder = Vec3::Zero();
};
/// Measures go with stature as far as one person's do: z = 0.8 z_stature + 0.6 of its own.
Subject draw_subject(const SyntheticSubject& options, math::RandomStream& random);

}  // namespace morphe::synthesize
