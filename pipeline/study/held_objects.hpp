#pragma once

#include <optional>
#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/study/known_contacts.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::study {

/// An object in a hand at one instant, with the contacts of thumb, index and middle finger.
struct HeldObject {
  SceneObject object;  ///< with its pose at that instant
  std::vector<KnownContact> contacts;
};

/// Draws an object whose surface contains tip + pad_depth_m * inward normal of thumb, index and
/// middle finger of `hand`, which is given in the world frame:
///   sphere    about a point at equal distance from the three tips
///   cylinder  of any direction, its axis through the centre of the circle on which the tips lie
///             in the projection along the axis
///   box       two parallel faces, one at the thumb, one at index and middle finger; a random
///             rotation about their normal and random lengths along them
/// An object is rejected unless it is 24 to 80 mm wide, the mean normal of the fingers is within 60
/// degrees of the opposite of the thumb's, it is above the table (z = 0), and its surface is at
/// least pad_depth_m away from `clear_points`, outside. Returns no object if 500 are rejected.
std::optional<HeldObject> draw_held_object(Shape shape, const ObservedHand& hand,
                                           const std::vector<Vec3>& clear_points,
                                           double pad_depth_m, math::RandomStream& random);

/// A synthetic recording with the object that its hand grasps, and the contacts.
struct KnownGrasp {
  Demonstration recorded;  ///< with the object
  std::vector<KnownContact> contacts;
};
/// The name of the object in the recording.
inline constexpr const char* kHeldObjectName = "held";

/// Puts an object of the given shape into the hand of a synthetic recording, based on its ground
/// truth at the middle of the first grasp. The object rests before the grasp, is then carried with
/// the hand, and stays where the hand releases it. Empty if the recording has no grasp or no
/// release, or if draw_held_object() finds no object.
std::optional<KnownGrasp> add_held_object(const synthesize::SyntheticRecording& recording,
                                          Shape shape, double pad_depth_m,
                                          math::RandomStream& random);

}  // namespace morphe::study
