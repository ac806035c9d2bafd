#pragma once

#include <tuple>

#include "core/humanlike/chain_position_term.hpp"
#include "core/humanlike/custom_terms.hpp"
#include "core/humanlike/finger_joint_distance_term.hpp"
#include "core/humanlike/hand_orientation_term.hpp"
#include "core/humanlike/hull_volume_term.hpp"
#include "core/humanlike/joint_angle_term.hpp"
#include "core/humanlike/joint_distance_term.hpp"
#include "core/humanlike/natural_posture_term.hpp"
#include "core/humanlike/pad_direction_term.hpp"
#include "core/humanlike/palm_direction_term.hpp"
#include "core/humanlike/thumb_distance_term.hpp"
#include "core/humanlike/tip_orientation_term.hpp"
#include "core/humanlike/tip_position_term.hpp"
#include "core/humanlike/triangle_area_term.hpp"

namespace morphe::humanlike {

/// All terms, in the order in which their keys appear in a config. Terms of frames are summed in
/// this order, then those of joints.
using Terms = std::tuple<TipPosition,          //
                         TipOrientation,       //
                         PadDirection,         //
                         PalmDirection,        //
                         ThumbDistance,        //
                         HandOrientation,      //
                         JointDistance,        //
                         FingerJointDistance,  //
                         TriangleArea,         //
                         HullVolume,           //
                         NaturalPosture,       //
                         ChainPosition,        //
                         JointAngle,           //
                         CustomTerms>;

}  // namespace morphe::humanlike
