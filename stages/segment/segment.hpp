#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "stages/segment/segment_options.hpp"

namespace morphe::segment {

/// The movements of a recording in order of time, each an out-and-back cycle of bouts of motion:
///
///   reach (preshape inside it) · grasp · transport · hold · transport · … · return
///
/// Bouts are found in the speed (bouts.hpp), movements in the places between them, the opening of
/// the hand and the recorded objects (cycles.hpp). The first bout is the reach, the one that comes
/// home the return, as is what follows after a recorded object has come to rest; those between are
/// transport and the pauses hold. Without a grasp the phases are reach, hold, return. `begin_s`,
/// `end_s` span what is planned (`plan_until`); if that phase is missing, up to the grasp, and
/// without a grasp to `touch_hold` after the reach. `target` is the recorded object that moves with
/// this hand, else the one that its fingertips hold; what another hand moves is no evidence here
/// (contact.hpp).
///
/// A boundary's confidence is 1 − v / (dip_share · p), within 0 … 1, times 1 / (1 + (δ / 40 ms)²)
/// and 1 / (1 + r²): v the slowest speed in the pause at the boundary, p the smaller of the peaks
/// on its sides, δ the noise over the slope of speed there, r by how much the speed rises again
/// within 0.3 s of the boundary, over the speed at it; 0 where the recording begins or ends in
/// motion. A phase has the mean of its two boundaries, times the share of its frames in which the
/// hand was seen.
///
/// With `whole` one movement from the first to the last frame in which wrist or fingertips were
/// seen: gestures, of which none is a reach.
///
/// Too short, motionless, or the wrist never seen: no movements. Never throws.
std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects = {});

}  // namespace morphe::segment
