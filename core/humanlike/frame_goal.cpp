#include "core/humanlike/frame_goal.hpp"

namespace morphe::humanlike {

FrameGoal frame_goal(const Goals& goals, std::size_t frame) {
  FrameGoal goal;
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
    goal.tip_position.push_back(goals.tip_position(frame, tip));
    goal.tip_orientation.push_back(goals.tip_orientation(frame, tip));
    if (goals.tip_to_pad_share.rows > 0)
      goal.tip_to_pad_share.push_back(goals.tip_to_pad_share(frame, tip));
  }
  goal.closes_by_itself = goals.auto_closed;
  goal.hand_scale = goals.hand_scale;
  goal.hand = goals.wrist_orientation[frame];
  goal.shoulder = goals.shoulder_position[frame];
  goal.wrist = goals.wrist_position[frame];
  goal.elbow = goals.elbow_position[frame];
  for (std::size_t finger = 0; finger < kFingerCount; ++finger)
    goal.finger_joint[finger] = goals.finger_joint_position(frame, finger);
  return goal;
}

}  // namespace morphe::humanlike
