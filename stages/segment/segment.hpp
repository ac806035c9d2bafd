#pragma once

#include <string_view>
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
/// unit that comes home is the return, as are the units after a recorded object has come to rest.
/// Those in between are transports, and the pauses are holds. Without a grasp the phases are reach,
/// hold, return. `begin_s` and `end_s` span the planned interval, which ends with the phase
/// `plan_until`. If that is missing, the interval ends with the grasp; without a grasp, it ends
/// within the hold after the reach, at most `hold_after_touch_s` after its begin. `target` is the
/// recorded object that moves with this hand, otherwise the one that its fingertips hold, otherwise
/// "". Objects that the other hand moves are no evidence (interaction.hpp).
///
/// The confidence of a boundary is clamp(1 − v / (dip_share · p), 0, 1) / (1 + (δ / 40 ms)²) / (1 +
/// r²), with v the slowest speed in the pause at the boundary, p the smaller of the peaks on both
/// sides, δ the noise over the slope of the speed there, and r the rise of the speed within 0.3 s
/// outside the boundary over the speed at it. A boundary cut off by the recording has 0; the begin
/// of the preshape has ReachAperture::confidence. The confidence of a phase is the mean of those of
/// its boundaries times the share of its frames in which the hand was seen.
///
/// With `whole_recording` the result is one movement without phases, from the first to the last
/// frame in which wrist or fingertips were seen. Otherwise there are no movements if the recording
/// is too short or motionless, or if the wrist was never seen. `task` is the recording's, if it was
/// stated. Never throws.
std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects = {},
                              std::string_view task = {});

}  // namespace morphe::segment
