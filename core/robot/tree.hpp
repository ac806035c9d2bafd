#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The range that ancestors() returns.
class AncestorRange {
 public:
  /// The frames from `frame` up to the base.
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

/// Returns the frames from one up to the base, which is excluded: for (const int f :
/// ancestors(robot, 7)).
inline AncestorRange ancestors(const RobotModel& robot, int frame) { return {robot, frame}; }

/// Returns the joint that moves a frame directly, or -1 if there is no such joint.
inline int joint_of(const RobotModel& robot, int frame) { return robot.frames[frame].joint; }

/// Returns true if a frame equals `ancestor` or is a descendant of it. All frames are descendants
/// of the base (-1).
inline bool is_in_subtree(const RobotModel& robot, int frame, int ancestor) {
  while (frame > ancestor) frame = robot.frames[frame].parent;
  return frame == ancestor;  // parents precede their children
}

/// Returns the nearest frame that a joint moves, the frame itself included, to which it is rigidly
/// connected; -1 = the base.
inline int moving_frame_of(const RobotModel& robot, int frame) {
  while (frame >= 0 && joint_of(robot, frame) < 0) {
    frame = robot.frames[frame].parent;
  }
  return frame;
}

/// Returns true if a joint's own value is a length, because the first of its frames is prismatic.
inline bool is_prismatic(const RobotModel& robot, int joint) {
  for (const RobotModel::Frame& frame : robot.frames) {
    if (frame.joint == joint) return frame.prismatic;
  }
  return false;
}

/// Returns true if a joint moves a frame, directly or through a coupling.
inline bool joint_moves_frame(const RobotModel& robot, int joint, int frame) {
  for (const int f : ancestors(robot, frame)) {
    if (joint_of(robot, f) == joint) return true;
  }
  return false;
}

/// Returns the last frame with which both frames move; -1 = the base.
inline int common_ancestor(const RobotModel& robot, int frame, int other) {
  while (frame != other) {
    int& lower = frame > other ? frame : other;
    lower = robot.frames[lower].parent;
  }
  return frame;
}

}  // namespace morphe::robot
