#include "pipeline/planning/close_hand.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/math/seed.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/planning/constants.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/constants.hpp"
#include "stages/grasp/measure.hpp"

namespace morphe::planning {
namespace {

/// A hand that closes in one frame.
struct ClosingHand {
  const map::MappingProblem& problem;
  std::size_t frame;
  const map::MapOptions& options;
  std::uint64_t seed;

  const robot::Robot& robot() const { return *problem.robot; }
  double time_s() const { return problem.time[frame]; }
};

/// Returns the joints between the palm and a tip.
std::vector<int> joints_of_finger(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> joints;
  for (int joint = 0; joint < static_cast<int>(robot.joints()); ++joint) {
    const bool of_arm = std::ranges::find(robot.arm_joints, joint) != robot.arm_joints.end();
    if (!of_arm && robot::joint_moves_frame(robot, joint, robot.tips[tip].frame))
      joints.push_back(joint);
  }
  return joints;
}

/// Returns weights with which only the finger of a tip moves.
JointVector stay_weights_except_finger(const robot::Robot& robot, std::size_t tip) {
  JointVector stay =
      JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), kHeldHandWeight);
  for (const int joint : joints_of_finger(robot, tip)) stay[joint] = 0;
  return stay;
}

bool has_contact(const ContactPosture& posture, std::size_t tip) {
  return std::ranges::find(posture.contacts, tip, &grasp::DesiredContact::tip) !=
         posture.contacts.end();
}

/// Returns the angle between pad and surface of the contact of a tip, or infinity if the pad does
/// not touch.
double angle_if_touching(const ClosingHand& hand, const ContactPosture& posture, std::size_t tip) {
  const std::vector<PadContact> contacts =
      grasp::measure_contacts(*hand.problem.world, posture.contacts, posture.q, hand.time_s());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (posture.contacts[k].tip == tip && contacts[k].state == ContactState::touching)
      return contacts[k].pad_angle;
  }
  return kInfinity;
}

/// Returns `from`, in which the finger of a tip alone has slid along the surface until its pad
/// faces it as well as it can.
ContactPosture face_surface(const ClosingHand& hand, std::size_t tip, const ContactPosture& from) {
  return solve_contact_posture(hand.problem, hand.frame, from.contacts, from.q,
                               stay_weights_except_finger(hand.robot(), tip), hand.options,
                               hand.seed);
}

/// Returns `open` with the finger of a tip in other postures: as it is, and spread over its limits.
std::vector<JointVector> finger_starts(const ClosingHand& hand, std::size_t tip,
                                       const JointVector& open) {
  std::vector<JointVector> starts{open};
  for (const JointVector& spread :
       map::spread_starts(hand.robot(), kClosingStarts, math::seed_from(hand.seed, "closing"))) {
    starts.push_back(open);
    for (const int joint : joints_of_finger(hand.robot(), tip))
      starts.back()[joint] = spread[joint];
  }
  return starts;
}

/// Returns `closed` without the contact of a tip, and with its finger as in `open`.
ContactPosture reopen_finger(const ClosingHand& hand, std::size_t tip, const JointVector& open,
                             ContactPosture closed) {
  for (const int joint : joints_of_finger(hand.robot(), tip)) closed.q[joint] = open[joint];
  std::erase_if(closed.contacts, [&](const auto& contact) { return contact.tip == tip; });
  return closed;
}

/// Lets an open finger slide to the surface from postures of its own (finger_starts), and close
/// what then remains of the gap, until it touches within kGoodPadAngle_rad. Returns the posture
/// with the least pad angle to which the finger closes freely, or `open` without one.
ContactPosture close_from_starts(const ClosingHand& hand, const grasp::FingerInHand& finger,
                                 const ContactPosture& open) {
  const collision::CollisionWorld& world = *hand.problem.world;
  ContactPosture best = open;
  double best_angle = grasp::kMaxContactAngle_rad;
  for (const JointVector& start : finger_starts(hand, finger.tip, open.q)) {
    ContactPosture facing{start, open.contacts};
    facing.contacts.push_back({finger.tip, ContactOrigin::auto_closed});
    facing = face_surface(hand, finger.tip, facing);
    const std::optional<grasp::FingerClosure> closing =
        grasp::close_straight(world, hand.time_s(), finger, facing.q);
    if (!closing || closing->pad_angle_rad >= best_angle) continue;
    facing.q += closing->turn;
    facing.contacts.back() = closing->contact;
    if (!grasp::closes_freely(world, hand.time_s(), finger, open.q, facing.q)) continue;
    best_angle = closing->pad_angle_rad;
    best = std::move(facing);
    if (best_angle <= grasp::kGoodPadAngle_rad) break;
  }
  return best;
}

/// Takes the best of the postures in which a finger touches: as it is, slid from there, and, if its
/// pad is still off, from postures of its own. `open` is the hand before it closed.
void close_well(const ClosingHand& hand, const grasp::FingerInHand& finger, const JointVector& open,
                ContactPosture& touching) {
  double angle = angle_if_touching(hand, touching, finger.tip);
  const auto take_if_better = [&](ContactPosture other) {
    const double other_angle = angle_if_touching(hand, other, finger.tip);
    if (!(other_angle < angle)) return;
    angle = other_angle;
    touching = std::move(other);
  };
  if (has_contact(touching, finger.tip)) take_if_better(face_surface(hand, finger.tip, touching));
  if (angle <= grasp::kGoodPadAngle_rad) return;
  take_if_better(close_from_starts(hand, finger, reopen_finger(hand, finger.tip, open, touching)));
}

}  // namespace

std::vector<std::string> close_hand(const map::MappingProblem& problem, std::size_t frame,
                                    const std::vector<std::size_t>& tips,
                                    const map::MapOptions& options, std::uint64_t seed,
                                    ContactPosture& touching) {
  const ClosingHand hand{problem, frame, options, seed};
  const robot::Robot& robot = hand.robot();
  const JointVector open = touching.q;
  grasp::FingerClosures closed = grasp::close_fingers(*problem.world, hand.time_s(), tips, open);
  std::vector<std::size_t> unclosed;
  for (const grasp::OpenFinger& finger : closed.open) unclosed.push_back(finger.tip);
  for (const grasp::FingerClosure& closing : closed.closings) {
    touching.contacts.push_back(closing.contact);
    touching.q += closing.turn;
  }
  touching.q = touching.q.cwiseMax(robot.lower).cwiseMin(robot.upper);
  for (const grasp::FingerClosure& closing : closed.closings)
    close_well(hand, {closing.contact.tip, unclosed}, open, touching);
  std::vector<std::string> notes;
  for (const grasp::OpenFinger& finger : closed.open) {
    std::erase(unclosed, finger.tip);
    close_well(hand, {finger.tip, unclosed}, open, touching);
    if (!has_contact(touching, finger.tip))
      notes.push_back(robot.tips[finger.tip].name + " stays open: " + finger.reason);
  }
  return notes;
}

}  // namespace morphe::planning
