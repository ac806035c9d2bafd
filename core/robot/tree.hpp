#pragma once

#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// What upwards() goes through.
class Upwards {
 public:
  Upwards(const RobotTable& robot, int frame) : robot_(robot), first_(frame) {}

  struct Iterator {
    const RobotTable& robot;
    int frame;
    int operator*() const { return frame; }
    Iterator& operator++() {
      frame = robot.frames[static_cast<std::size_t>(frame)].parent;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return frame != other.frame; }
  };
  Iterator begin() const { return {robot_, first_}; }
  Iterator end() const { return {robot_, -1}; }

 private:
  const RobotTable& robot_;
  int first_;
};

/// The frames from one up to the base, which is none itself: for (const int f : upwards(robot, 7)).
inline Upwards upwards(const RobotTable& robot, int frame) { return {robot, frame}; }

/// The joint that turns a frame itself, -1: none.
inline int joint_of(const RobotTable& robot, int frame) {
  return robot.frames[static_cast<std::size_t>(frame)].joint;
}

/// Whether a frame moves with another: it is that one, or hangs on it. All hang on the base (-1).
inline bool hangs_on(const RobotTable& robot, int frame, int ancestor) {
  while (frame > ancestor) frame = robot.frames[static_cast<std::size_t>(frame)].parent;
  return frame == ancestor;  // parents come first
}

/// The frame that a joint moves at or above one, with which it is rigid; -1 = the base.
inline int body_of(const RobotTable& robot, int frame) {
  while (frame >= 0 && joint_of(robot, frame) < 0) {
    frame = robot.frames[static_cast<std::size_t>(frame)].parent;
  }
  return frame;
}

/// Whether a joint's own value is a length: the first of its frames slides.
inline bool slides(const RobotTable& robot, int joint) {
  for (const RobotTable::Frame& frame : robot.frames) {
    if (frame.joint == joint) return frame.slides;
  }
  return false;
}

/// Whether a joint moves a frame, directly or through a coupling.
inline bool moves(const RobotTable& robot, int joint, int frame) {
  for (const int f : upwards(robot, frame)) {
    if (joint_of(robot, f) == joint) return true;
  }
  return false;
}

/// The last frame that both move with, directly or not; -1 = the base.
inline int common_ancestor(const RobotTable& robot, int frame, int other) {
  while (frame != other) {
    int& lower = frame > other ? frame : other;
    lower = robot.frames[static_cast<std::size_t>(lower)].parent;
  }
  return frame;
}

}  // namespace morphe::robot
