#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "stages/segment/segment_options.hpp"

namespace morphe::segment {

/// Segments a recording into movements in order of time, each an out-and-back cycle of movement
/// units:
///
///   reach (preshape inside it) · grasp · transport · hold · transport · … · return
///
/// Units are found from the speed (movement_units.hpp), movements from the positions between them,
/// the aperture of the hand and the recorded objects (cycles.hpp). The first unit is the reach. The
/// unit that comes home is the return, as are the units after a recorded object has come to rest;
/// those in between are transports, and the pauses are holds. Without a grasp the phases are reach,
/// hold, return. `begin_s` and `end_s` span the planned interval (`plan_until`); if that phase is
/// missing, it ends with the grasp, and without a grasp `hold_after_touch_s` after the reach.
/// `target` is the recorded object that moves with this hand, otherwise the one that its fingertips
/// hold; objects moved by the other hand are no evidence here (interaction.hpp).
///
/// The confidence of a boundary is 1 − v / (dip_share · p), within 0 … 1, times 1 / (1 + (δ / 40
/// ms)²) and 1 / (1 + r²), with v the slowest speed in the pause at the boundary, p the smaller of
/// the peaks on both sides, δ the noise over the slope of the speed there, and r the rise of the
/// speed within 0.3 s outside the boundary relative to the speed at it. It is 0 if the recording
/// begins or ends in motion. The confidence of a phase is the mean of its two boundaries times the
/// share of its frames in which the hand was seen.
///
/// With `whole` there is one movement from the first to the last frame in which wrist or fingertips
/// were seen: these are gestures, which contain no reach.
///
/// Returns no movements if the recording is too short or motionless, or if the wrist was never
/// seen. Never throws.
std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects = {});

}  // namespace morphe::segment
