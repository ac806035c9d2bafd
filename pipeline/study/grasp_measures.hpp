#pragma once

#include <optional>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/study/known_contacts.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::study {

/// A robot's finger at the object, in the object's frame.
struct RobotFinger {
  Vec3 touched = unseen_point();       ///< the surface's nearest point to its pad [m]
  Vec3 tip = unseen_point();           ///< [m]
  Vec3 pad = unseen_point();           ///< centre of its pad's ball [m]
  Vec3 middle_joint = unseen_point();  ///< its centre of metric A [m]
  double gap = kNotSeen;               ///< between pad and surface, < 0: it lies inside [m]
  double pad_angle = kNotSeen;         ///< between the pad's middle and the inward normal [rad]
};

/// What one finger makes of a contact that is known.
struct ContactError {
  double distance = kNotSeen;   ///< |touched - point|, on one surface [m]
  double pad_angle = kNotSeen;  ///< [rad]
  double gap = kNotSeen;        ///< [m]
  /// TopoRetarget's (arXiv:2606.16272, A.3): |(h_r - o) - (h_s - o)|, o the same point of the
  /// object for both, h_s the person's fingertip and h_r the robot's, or the centre of its pad,
  /// which takes the tip's place where a contact is asked for [m].
  double precision = kNotSeen, pad_precision = kNotSeen;
  /// Theirs, too: the angle between the two bones from the finger's middle joint to its tip [rad].
  double alignment = kNotSeen;
};
ContactError contact_error(const KnownContact& known, const RobotFinger& finger);

/// How deep links lie in the target at any of the samples, 0 if none does [m].
struct Penetration {
  double pads = 0, others = 0;
};
Penetration deepest_penetration(const collision::CollisionWorld& world,
                                const Trajectory& trajectory);

/// The tip that follows a person's finger itself, none where it follows a point between fingers.
std::optional<std::size_t> tip_of_finger(const RobotTable& robot, std::size_t finger);

/// One plan of a movement, as far as the study looks at it.
struct GraspScore {
  bool runs = false, executable = false;      ///< it has a trajectory, that reaches its goals
  double humanlikeness = kNotSeen;            ///< metric A, of the trajectory [m²]
  double duration_s = kNotSeen;               ///< of the trajectory
  std::vector<ContactError> errors;           ///< a known contact each
  Penetration penetration;                    ///< likewise
  std::size_t demonstrated = 0, touched = 0;  ///< contacts in the plan's table; that touch
  std::size_t closed = 0, closed_touch = 0;   ///< likewise of fingers that were closed
};
GraspScore score_grasp(const robot::Robot& robot, const Plan& plan,
                       const std::vector<KnownContact>& known);

/// How many contacts the demonstration of a movement asks for, by the plan without contacts, whose
/// goals are the person's own tips.
std::size_t contacts_asked(const robot::Robot& robot, const Plan& by_tips,
                           const grasp::GraspOptions& options);

}  // namespace morphe::study
