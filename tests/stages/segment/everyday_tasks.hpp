#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {

/// A person at a table who drinks, combs the hair or touches a place; every person and trial is
/// drawn anew. The table is z = 0; the shoulder, head and mouth are where a seated person's are.
struct EverydayTask {
  SyntheticHand hand;
  Vec3 shoulder;
  double grasp_s = 0;  ///< middle of the time between reach and transport; drinks only

  HumanMotion motion() const {
    HumanMotion motion = hand.motion();
    for (const Vec3& wrist : motion.wrist) {
      motion.shoulder.push_back(shoulder);
      const double half_m = 0.5 * (wrist - shoulder).norm();
      const double down_m = std::sqrt(std::max(0.0, 0.27 * 0.27 - half_m * half_m));
      motion.elbow.push_back(0.5 * (shoulder + wrist) - down_m * Vec3::UnitZ());
    }
    return motion;
  }
};

/// Closing of the hand at the cup [m] and stop there [s]; an `overlap_s` begins the transport
/// before the reach has ended.
struct DrinkStyle {
  double closing_m = 0.02, stop_s = 0.2, overlap_s = 0;
};

class EverydayTasks {
 public:
  explicit EverydayTasks(unsigned seed) : random_(seed) {}

  EverydayTask drink(const DrinkStyle& style) {
    EverydayTask task = begin();
    const Vec3 cup = place(0.09, 0.35), mouth = at_head(0.16, 0.2);
    const Vec3 put_down = cup + offset(draw(0, 0.03));
    const double reach_end = stroke(task, cup, draw(0.6, 1.3));
    const double opened = rest_m_ + draw(0.2, 1) * style.closing_m + draw(0, 0.03);
    const double held = opened - style.closing_m;
    finger(task, reach_end - draw(0.1, 0.4), opened);
    now_ = reach_end + style.stop_s - style.overlap_s;
    finger(task, std::max(now_, reach_end), held);
    task.grasp_s = 0.5 * (reach_end + now_);
    now_ = stroke(task, mouth, draw(0.8, 1.6)) + draw(0, 1);
    const double put_end = stroke(task, put_down, draw(0.8, 1.6));
    now_ = put_end + style.stop_s - style.overlap_s;
    finger(task, now_, held);
    finger(task, now_ + 0.25, held + draw(0, 0.02));
    return finish(std::move(task));
  }

  /// Strokes through the hair, which may end where they began; the hand takes nothing.
  EverydayTask comb() {
    EverydayTask task = begin();
    const Vec3 top = at_head(0.2, 0.3);
    now_ = stroke(task, top, draw(0.7, 1.3)) + draw(0, 0.3);
    finger(task, now_, rest_m_ + draw(-0.02, 0.03));
    const int strokes = std::uniform_int_distribution<int>(1, 4)(random_);
    for (int k = 0; k < strokes; ++k) {
      now_ = stroke(task, top + Vec3(draw(-0.05, 0.05), draw(-0.15, 0), draw(-0.2, -0.08)),
                    draw(0.3, 0.9)) +
             draw(0, 0.1);
      finger(task, now_, rest_m_ + draw(-0.02, 0.03));
      if (k + 1 == strokes) break;
      now_ = stroke(task, top + offset(0.02), draw(0.3, 0.9)) + draw(0, 0.1);
      finger(task, now_, rest_m_ + draw(-0.02, 0.03));
    }
    return finish(std::move(task));
  }

  /// A finger touches a place, and the hand goes home or stays there; it may form a pointing hand.
  EverydayTask touch(bool returns) {
    EverydayTask task = begin();
    const double end = stroke(task, place(0.12, 0.4), draw(0.6, 1.3));
    finger(task, end - draw(0, 0.3), rest_m_ + draw(-0.02, 0.03));
    now_ = end + draw(0.1, 1.5);
    finger(task, now_, rest_m_ + draw(-0.02, 0.03));
    return returns ? finish(std::move(task)) : end_recording(std::move(task));
  }

 private:
  double draw(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  Vec3 offset(double length) {
    const Vec3 direction(draw(-1, 1), draw(-1, 1), draw(-0.3, 0.3));
    return length * direction.normalized();
  }
  Vec3 place(double nearest, double farthest) {
    const double angle = draw(-1, 1), distance = draw(nearest, farthest);
    return home_ + distance * Vec3(std::sin(angle), std::cos(angle), draw(0, 0.3));
  }
  Vec3 at_head(double lowest, double highest) {
    return shoulder_ + Vec3(-0.18 + draw(-0.03, 0.03), draw(0, 0.12), draw(lowest, highest));
  }
  EverydayTask begin() {
    EverydayTask task;
    shoulder_ = task.shoulder = Vec3(0.2, 0, draw(0.28, 0.42));
    home_ = at_ = task.hand.start = Vec3(draw(0.1, 0.3), draw(0.2, 0.3), 0.02);
    rest_m_ = draw(0.05, 0.11);
    task.hand.opening = {{0, rest_m_}};
    task.hand.noise_m = draw(0.0001, 0.001);
    now_ = draw(0.4, 1);
    task.hand.opening.emplace_back(now_ + draw(0, 0.2), rest_m_);
    return task;
  }
  /// Returns the end of a stroke that begins now.
  double stroke(EverydayTask& task, const Vec3& to, double length_s) {
    task.hand.strokes.push_back({now_, length_s, to - at_});
    at_ = to;
    return now_ + length_s;
  }
  void finger(EverydayTask& task, double until_s, double opening) {
    const double last_s = task.hand.opening.back().first;
    task.hand.opening.emplace_back(std::max(until_s, last_s + 0.01), opening);
  }
  EverydayTask finish(EverydayTask task) {
    now_ = stroke(task, home_ + offset(draw(0, 0.015)), draw(0.6, 1.3));
    finger(task, now_, rest_m_ + draw(-0.01, 0.01));
    return end_recording(std::move(task));
  }
  EverydayTask end_recording(EverydayTask task) {
    task.hand.length_s = now_ + draw(0.4, 1.5);
    return task;
  }

  std::mt19937 random_;
  Vec3 shoulder_ = Vec3::Zero(), home_ = Vec3::Zero(), at_ = Vec3::Zero();
  double rest_m_ = 0.08, now_ = 0;
};

}  // namespace morphe::segment
