#pragma once

#include <optional>
#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/study/known_contacts.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::study {

/// An object of known shape and place, and where thumb, index and middle finger touch it.
struct HeldObject {
  SceneObject object;  ///< K = 1: where it is at that instant
  std::vector<KnownContact> contacts;
};

/// An object whose surface lies exactly pad_depth_m from the tips of thumb, index and middle
/// finger, with tip + pad_depth * normal on it:
///   sphere    about a point as far from the three tips
///   cylinder  of any direction, its axis through the middle of the circle on which the tips lie if
///             one looks along it
///   box       two parallel faces, one before the thumb, one before index and middle finger; turned
///             about their normal and as long as drawn
/// Drawn until it can be grasped: 24 to 80 mm wide, the fingers' normals within 60 degrees of
/// opposite to the thumb's, above the table (z = 0), clear of `clear_points` by pad_depth_m. None
/// if 500 draws bring none.
std::optional<HeldObject> hold_object(Shape shape, const SeenHand& hand,
                                      const std::vector<Vec3>& clear_points, double pad_depth_m,
                                      math::RandomStream& random);

/// A synthetic recording with the object that its one hand takes hold of, and its contacts.
struct KnownGrasp {
  Demonstration recorded;
  std::vector<KnownContact> contacts;
};
inline constexpr const char* kHeldName = "held";

/// Puts an object of that shape into the hand of a synthetic recording, by its truth at the middle
/// of the first grasp: still before, then carried as the hand goes, and left where the hand lets
/// go. None where nothing is grasped or no such object is found.
std::optional<KnownGrasp> known_grasp(const synthesize::SyntheticRecording& recording, Shape shape,
                                      double pad_depth_m, math::RandomStream& random);

}  // namespace morphe::study
