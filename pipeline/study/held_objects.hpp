#pragma once

#include <optional>
#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/study/known_contacts.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::study {

/// An object of known shape and pose, with the contacts of thumb, index and middle finger.
struct HeldObject {
  /// The object with one pose (K = 1), at that instant.
  SceneObject object;
  /// The contacts of the fingers.
  std::vector<KnownContact> contacts;
};

/// Samples an object whose surface lies exactly pad_depth_m from the tips of thumb, index and
/// middle finger, with tip + pad_depth * normal on it:
///   sphere    about a point at equal distance from the three tips
///   cylinder  of any direction, its axis through the centre of the circle on which the tips lie
///             in the projection along the axis
///   box       two parallel faces, one at the thumb, one at index and middle finger, rotated about
///             their normal and with sampled lengths
/// Samples are drawn until the object can be grasped: 24 to 80 mm wide, the normals of the fingers
/// within 60 degrees of the opposite of the thumb's, above the table (z = 0), and at least
/// pad_depth_m from `clear_points`. Returns an empty value if 500 samples are rejected.
std::optional<HeldObject> sample_held_object(Shape shape, const ObservedHand& hand,
                                             const std::vector<Vec3>& clear_points,
                                             double pad_depth_m, math::RandomStream& random);

/// A synthetic recording with the object grasped by its one hand, and the contacts.
struct KnownGrasp {
  /// The recording with the object.
  Demonstration recorded;
  /// The contacts of the fingers.
  std::vector<KnownContact> contacts;
};
/// The name of the object in the recording.
inline constexpr const char* kHeldObjectName = "held";

/// Puts an object of the given shape into the hand of a synthetic recording, based on its ground
/// truth at the middle of the first grasp. The object rests before the grasp, is then carried with
/// the hand, and stays at the pose at which the hand releases it. Returns an empty value if there
/// is no grasp or if no such object is found.
std::optional<KnownGrasp> add_held_object(const synthesize::SyntheticRecording& recording,
                                          Shape shape, double pad_depth_m,
                                          math::RandomStream& random);

}  // namespace morphe::study
