#pragma once

#include <tuple>

#include "pipeline/humanlike/chain_position_term.hpp"
#include "pipeline/humanlike/finger_joint_distance_term.hpp"
#include "pipeline/humanlike/given_terms.hpp"
#include "pipeline/humanlike/hand_orientation_term.hpp"
#include "pipeline/humanlike/hull_volume_term.hpp"
#include "pipeline/humanlike/joint_angle_term.hpp"
#include "pipeline/humanlike/joint_distance_term.hpp"
#include "pipeline/humanlike/natural_posture_term.hpp"
#include "pipeline/humanlike/pad_direction_term.hpp"
#include "pipeline/humanlike/thumb_distance_term.hpp"
#include "pipeline/humanlike/tip_orientation_term.hpp"
#include "pipeline/humanlike/tip_position_term.hpp"
#include "pipeline/humanlike/triangle_area_term.hpp"

namespace morphe::humanlike {

/// Every term there is, in the order in which they are summed and in which a config names them.
using Terms = std::tuple<TipPosition,          //
                         TipOrientation,       //
                         PadDirection,         //
                         ThumbDistance,        //
                         HandOrientation,      //
                         JointDistance,        //
                         FingerJointDistance,  //
                         TriangleArea,         //
                         HullVolume,           //
                         NaturalPosture,       //
                         ChainPosition,        //
                         JointAngle,           //
                         GivenTerms>;

}  // namespace morphe::humanlike
