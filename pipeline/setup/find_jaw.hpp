#pragma once

#include <optional>

#include "pipeline/setup/finger_bodies.hpp"

namespace morphe::setup {

/// Returns the end of the jaw that stands opposite a moving one, on the link that carries this: the
/// gripper has one joint, which moves one jaw. The evidence, in the base frame at rest:
///   - the moving jaw swings or slides across the arm,
///   - the carrying body, or a frame fixed to it, reaches at least 0.6 times as far beyond the
///   jaw's
///     joint, away from the arm, as the jaw itself,
///   - the jaw comes to that body at one end of its range, not in the middle of it as a wrist does;
///     a gripper's name in joint or link replaces this.
/// nullopt without this evidence. `jaw.frames` ends with the moving frame.
std::optional<BodyPoint> find_fixed_jaw(const Kinematics& robot, const Finger& jaw,
                                        const BodyPoints& points);

/// Returns the end of the carrying body beyond the jaw's joint, nullopt if it has no such end.
std::optional<BodyPoint> farthest_beside(const Kinematics& robot, const Finger& jaw,
                                         const BodyPoints& points);

/// Returns true if the joint or link of a frame is named as a part of a gripper.
bool named_as_gripper(const Kinematics& robot, int frame);

}  // namespace morphe::setup
