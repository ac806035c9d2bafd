#pragma once

#include <algorithm>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The range that ancestors() returns.
class AncestorRange {
 public:
  /// The range from `frame` up to the base.
  AncestorRange(const RobotModel& robot, int frame) : robot_(robot), first_(frame) {}

  /// Moves from a frame to its parent.
  struct Iterator {
    const RobotModel& robot;
    int frame;
    int operator*() const { return frame; }
    Iterator& operator++() {
      frame = robot.frames[frame].parent;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return frame != other.frame; }
  };
  Iterator begin() const { return {robot_, first_}; }
  Iterator end() const { return {robot_, -1}; }

 private:
  const RobotModel& robot_;
  int first_;
};

/// Returns a frame and its ancestors up to the base, which is excluded.
inline AncestorRange ancestors(const RobotModel& robot, int frame) { return {robot, frame}; }

/// Returns the joint that moves a frame relative to its parent, -1 if there is no such joint.
inline int joint_of(const RobotModel& robot, int frame) { return robot.frames[frame].joint; }

/// Returns true if a frame equals `ancestor` or is a descendant of it. All frames are descendants
/// of the base (-1).
inline bool is_in_subtree(const RobotModel& robot, int frame, int ancestor) {
  while (frame > ancestor) frame = robot.frames[frame].parent;
  return frame == ancestor;  // parents precede their children
}

/// Returns the frame itself if a joint moves it, else its nearest ancestor that a joint moves, to
/// which it is rigidly connected; -1 = the base.
inline int moving_frame_of(const RobotModel& robot, int frame) {
  while (frame >= 0 && joint_of(robot, frame) < 0) frame = robot.frames[frame].parent;
  return frame;
}

/// Returns true if a joint's position is a length, because the first of its frames is prismatic.
inline bool is_prismatic(const RobotModel& robot, int joint) {
  const auto first = std::ranges::find(robot.frames, joint, &RobotModel::Frame::joint);
  return first != robot.frames.end() && first->prismatic;
}

/// Returns true if a joint moves a frame or one of its ancestors, directly or by a coupling.
inline bool joint_moves_frame(const RobotModel& robot, int joint, int frame) {
  for (const int f : ancestors(robot, frame)) {
    if (joint_of(robot, f) == joint) return true;
  }
  return false;
}

/// Returns the last frame on the way from the base to both frames; -1 = the base.
inline int common_ancestor(const RobotModel& robot, int frame, int other) {
  while (frame != other) {
    int& later = frame > other ? frame : other;  // is not an ancestor of the other one
    later = robot.frames[later].parent;
  }
  return frame;
}

}  // namespace morphe::robot
