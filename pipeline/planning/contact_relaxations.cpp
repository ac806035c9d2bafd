#include "pipeline/planning/contact_relaxations.hpp"

#include <algorithm>
#include <iterator>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/constants.hpp"
#include "stages/grasp/constants.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"

namespace morphe::planning {
namespace {

using Request = std::optional<ContactRequest>;

template <class Range, class Value>
bool contains(const Range& range, const Value& value) {
  return std::ranges::find(range, value) != range.end();
}

/// Returns true if a tip is at fault: it is away from its goals, or the link of its pad collides.
bool is_at_fault(const robot::Robot& robot, std::size_t tip, const std::vector<Finding>& findings) {
  const std::string& name = robot.tips[tip].name;
  const int pad = robot.pads[tip].capsule;
  const std::string link = pad < 0 ? "" : robot.capsules[pad].name;
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.subject == name ||
           (pad >= 0 && (finding.subject == link || finding.other_body == link));
  });
}

Request move_contacts(const ContactContext& context, const ContactAttempt& attempt,
                      ContactRequest request) {
  const Plan& plan = attempt.plan;
  const robot::Robot& robot = context.planner.robot;
  const std::size_t frame = frame_of_grasp(plan.goals, grasp::hold_interval(plan.movement));
  if (frame == plan.goals.frames() || request.moves == kMaxContactMoves) return {};
  if (std::ranges::any_of(plan.remaining_findings, is_collision, &Finding::cause)) return {};
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, plan.path.position.row(frame).transpose(), base_from_frame);
  const Pose target_from_base = recorded_pose(context.target, plan.goals.time[frame]).inverse();
  bool any = false;
  for (grasp::DesiredContact& contact : request.contacts) {
    const std::string& tip = robot.tips[contact.tip].name;
    if (std::ranges::find(plan.remaining_findings, tip, &Finding::subject) ==
        plan.remaining_findings.end())
      continue;
    const Vec3 pad = robot::tracked_point(robot, base_from_frame, contact.tip, 1);
    const grasp::DesiredContact at_pad =
        grasp::project_contact(robot, context.solid(), target_from_base * pad, contact);
    if ((at_pad.point - contact.demonstrated).norm() > grasp::kMaxSlide_m) continue;
    if (!contains(request.moved, tip)) request.moved.push_back(tip);
    contact = at_pad;
    any = true;
  }
  ++request.moves;
  return any ? Request(std::move(request)) : Request();
}

Request keep_more_outside(const ContactContext& context, const ContactAttempt& attempt,
                          ContactRequest request) {
  const robot::Robot& robot = context.planner.robot;
  bool any = false;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const auto touches = [&](const grasp::DesiredContact& contact) { return contact.tip == tip; };
    if (std::ranges::any_of(attempt.contacts, touches) || contains(request.kept_outside, tip) ||
        !is_at_fault(robot, tip, attempt.plan.remaining_findings))
      continue;
    request.kept_outside.push_back(tip);
    any = true;
  }
  return any ? Request(std::move(request)) : Request();
}

Request give_up(const ContactContext& context, const ContactAttempt& attempt,
                ContactRequest request) {
  const robot::Robot& robot = context.planner.robot;
  std::vector<std::string> tips;
  for (const grasp::DesiredContact& contact : attempt.contacts) {
    if (is_at_fault(robot, contact.tip, attempt.plan.remaining_findings))
      tips.push_back(robot.tips[contact.tip].name);
  }
  std::erase_if(request.contacts, [&](const grasp::DesiredContact& contact) {
    return contains(tips, robot.tips[contact.tip].name);
  });
  std::erase_if(request.moved, [&](const std::string& tip) { return contains(tips, tip); });
  std::ranges::copy(tips, std::back_inserter(request.given_up));
  return tips.empty() || request.contacts.empty() ? Request() : Request(std::move(request));
}

}  // namespace

Request relax_contacts(const ContactContext& context, const ContactAttempt& attempt,
                       const ContactRequest& request) {
  for (const auto relaxation : {move_contacts, keep_more_outside, give_up}) {
    if (Request relaxed = relaxation(context, attempt, request)) return relaxed;
  }
  return {};
}

}  // namespace morphe::planning
