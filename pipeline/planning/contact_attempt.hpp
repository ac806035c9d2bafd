#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::planning {

/// A movement for which contacts with its target are planned. All references must outlive it.
struct ContactContext {
  const PlanningInputs& planner;
  const collision::CollisionWorld& world;  ///< of the whole scene, with a target
  const SceneObject& target;               ///< the same target, in the plan's scene
  std::uint64_t seed;
  const std::vector<grasp::DesiredContact>& demonstrated;  ///< contacts before any is moved

  /// Returns the target's solid.
  collision::Solid solid() const { return collision::solid_at(world, world.target); }
};

/// The contacts that an attempt requests, and the results of earlier relaxations.
struct ContactRequest {
  std::vector<grasp::DesiredContact> contacts;
  std::vector<std::string> given_up;      ///< tips that have lost their contact
  std::vector<std::size_t> kept_outside;  ///< tips whose goals are kept outside of the target
  std::vector<std::string> moved;         ///< tips whose contact has been moved
  int moves = 0;                          ///< number of times that contacts were moved
};

/// A plan for a request.
struct ContactAttempt {
  Plan plan;
  /// The contacts of the request and those of fingers that close.
  std::vector<grasp::DesiredContact> contacts;
  std::vector<std::string> notes;  ///< one sentence each
  /// [n] positions that joints keep while the hand holds the target, NaN for those that are free;
  /// empty before the fingers have closed.
  JointVector held;
  PlanningFailure failure;  ///< set if the path still has findings
};

/// Plans the contacts of a request, starting from the plan `by_tips`, which follows the tips:
///   1. goals for the pads with contacts replace those of their tips
///   2. the fingers without goals close, if the config says so
///   3. if the movement carries the target, the hand keeps its posture until the release, and the
///      arm follows the target (held_path.hpp)
///   4. the path is optimised locally in the whole scene
///   5. if it is nearly free then, it is solved again with high weights
/// There is no global search, because pad goals are close to tip goals, and so are the paths.
ContactAttempt try_contacts(const ContactContext& context, const ContactRequest& request,
                            const Plan& by_tips);

/// Returns the first frame at or after `hold.begin_s`, which must be known; frames() without one.
std::size_t frame_of_grasp(const Goals& goals, const grasp::HoldInterval& hold);

}  // namespace morphe::planning
