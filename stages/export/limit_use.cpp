#include "stages/export/limit_use.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace morphe::exports {

MotionLimitUse limit_use(const RobotModel& robot, const Trajectory& motion) {
  return {math::limit_report(robot, motion), math::cubic_limit_report(robot, motion)};
}

bool exceeds_limit(const math::LimitUse& use) {
  constexpr double kRelativeRounding = 1e-6;
  return use.ratio > 1 + kRelativeRounding;
}

bool cubic_holds(const MotionLimitUse& use) {
  return !exceeds_limit(use.cubic.velocity) && !exceeds_limit(use.cubic.acceleration);
}

void WorstLimitUse::update(Use& worst, const math::LimitUse& use, const std::string& plan) {
  if (worst.use.sample < 0 || use.ratio > worst.use.ratio) worst = {use, plan};
}

void WorstLimitUse::add(const MotionLimitUse& use, const std::string& plan) {
  update(velocity_, use.quintic.velocity, plan);
  update(acceleration_, use.quintic.acceleration, plan);
  update(jerk_, use.quintic.jerk, plan);
  update(cubic_velocity_, use.cubic.velocity, plan);
  update(cubic_acceleration_, use.cubic.acceleration, plan);
}

std::string WorstLimitUse::sentence(double rate_hz) const {
  if (velocity_.use.sample < 0) return "";
  const auto percent = [](const Use& worst) {
    return fmt::format("{:.4g} %", 100 * worst.use.ratio);
  };
  return fmt::format(
      "between points at {:g} Hz quintics use {} of the velocity, {} of the acceleration and {} of "
      "the jerk limits, cubic Hermite pieces {} of the velocity and {} of the acceleration limits",
      rate_hz, percent(velocity_), percent(acceleration_), percent(jerk_), percent(cubic_velocity_),
      percent(cubic_acceleration_));
}

std::string WorstLimitUse::excess_sentence(const RobotModel& robot, double rate_hz) const {
  const std::array<std::pair<const char*, const Use*>, 3> quintic{
      {{"velocity", &velocity_}, {"acceleration", &acceleration_}, {"jerk", &jerk_}}};
  const std::array<std::pair<const char*, const Use*>, 2> cubic{
      {{"velocity", &cubic_velocity_}, {"acceleration", &cubic_acceleration_}}};
  const auto worst_of = [&](const auto& uses) {
    auto worst = uses.front();
    for (const auto& each : uses)
      if (each.second->use.ratio > worst.second->use.ratio) worst = each;
    if (!exceeds_limit(worst.second->use)) return std::string();
    const auto& [limit, found] = worst;
    return fmt::format(" reaches up to {:.6g} times the {} limit ({}, joint {})", found->use.ratio,
                       limit, found->plan, robot.joint_names[found->use.joint]);
  };
  const std::string by_quintics = worst_of(quintic), by_cubics = worst_of(cubic);
  std::string text;
  if (!by_quintics.empty())
    text += fmt::format("a controller that interpolates the points with quintics{}", by_quintics);
  if (!by_cubics.empty())
    text +=
        fmt::format("{}{} with cubic Hermite pieces{}", text.empty() ? "" : "; ",
                    text.empty() ? "a controller that interpolates the points" : "one", by_cubics);
  if (text.empty()) return "";
  return fmt::format(
      "at {:g} Hz {}. The points are on the certified curve; without --rate its samples are among "
      "them, and the least rate is taken at which both interpolations hold, if there is one",
      rate_hz, text);
}

}  // namespace morphe::exports
