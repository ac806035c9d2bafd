#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "stages/reconstruct/reconstruct_options.hpp"

namespace morphe::reconstruct {

/// Reconstructs a demonstration on one clock: positions of shoulder, elbow, wrist and fingertips
/// and the orientation of the hand, low-passed, as a right hand (a left one is mirrored,
/// mirror.hpp). Never throws: values that cannot be reconstructed are NaN and reported in
/// `reconstruction_notes`.
///
/// Markers (right arm: clusters RUAR1-4, RLAR1-4, RHAN1-4; tips RTHUM, RFTP; in the static trial
/// also RGTH shoulder, RLEP and RMEP epicondyles, RSPR and RSPU styloids, RFB finger base): every
/// cluster is registered to the static trial and carries the landmarks. The elbow is blended from
/// the clusters of upper arm and forearm, the wrist from those of forearm and hand; how far the two
/// disagree is in `residuals`. Both bones keep the lengths of the static trial.
///
/// Sensors (`wrist`, and `shoulder`, `elbow` if tracked): each pose is transformed to the joint
/// centre by its calibrated offset before filtering; upper arm and forearm keep their median
/// lengths; the arm's angles follow in closed form. A shoulder or elbow that was not tracked is
/// estimated and listed in `estimated`. Recorded fingertips are used unchanged; a glove's angles
/// become fingers (core/human/hand.hpp) after correction of its clock (align_clocks).
HumanMotion reconstruct(const Demonstration& demonstration, const ReconstructOptions& options,
                        const HumanOptions& human);

}  // namespace morphe::reconstruct
