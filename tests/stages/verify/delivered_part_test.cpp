#include "stages/verify/delivered_part.hpp"

#include <gtest/gtest.h>

#include <set>

#include "stages/verify/phases.hpp"

namespace morphe::verify {
namespace {

/// A task to its end; the cup is put down at 4 s, and the hand has let go at 4.5 s.
Plan partial_plan(PhaseKind until, double end_s) {
  Plan plan;
  plan.reason = Reason::no_path;
  plan.delivered = {until, 6};
  plan.movement = {0, 1, end_s, {}, "cup"};
  plan.movement.phases = {{PhaseKind::reach, 1, 2},          {PhaseKind::grasp, 2, 2.2},
                          {PhaseKind::transport, 2.2, 3},    {PhaseKind::hold, 3, 3.2},
                          {PhaseKind::transport, 3.2, 4},    {PhaseKind::hold, 4, 4.2},
                          {PhaseKind::return_phase, 4.2, 6}, {PhaseKind::lift, 2.2, 2.4},
                          {PhaseKind::place, 3.8, 4},        {PhaseKind::release, 4, 4.5},
                          {PhaseKind::retreat, 4.5, 5},      {PhaseKind::home, 5, 6}};
  return plan;
}

std::set<std::string> faults(const Plan& plan, PartialPlans allowed = PartialPlans::at_rest) {
  PlanRequest request;
  request.partial = allowed;
  ViolationLog log("");
  verify_delivered_part(plan, &request, log);
  std::set<std::string> subjects;
  for (const Violation& violation : log.finish()) subjects.insert(violation.subject);
  return subjects;
}

const std::set<std::string> kNone, kUntil{"delivered_until"};

TEST(DeliveredPart, EndsWithAPhaseAfterWhichTheObjectRests) {
  using enum PhaseKind;
  for (const auto& [until, end_s] :
       {std::pair{grasp, 2.2}, {transport, 4.0}, {place, 4.0}, {release, 4.5}, {retreat, 5.0}})
    EXPECT_EQ(faults(partial_plan(until, end_s)), kNone) << name_of(until);
  EXPECT_EQ(faults(partial_plan(release, 4.4)), kUntil) << "not its end";
  EXPECT_EQ(faults(partial_plan(hold, 4.2)), kUntil) << "ends no plan";
  EXPECT_EQ(faults(partial_plan(reach, 2.0)), kUntil) << "the hand takes something";
  EXPECT_EQ(faults(partial_plan(lift, 2.4)), kUntil) << "in the air";
  EXPECT_EQ(faults(partial_plan(lift, 2.4), PartialPlans::in_air), kNone);
  EXPECT_EQ(faults(partial_plan(grasp, 2.2), PartialPlans::never), kUntil);
}

TEST(DeliveredPart, AThingThatIsNeverLeftMayBeInTheAir) {
  Plan plan = partial_plan(PhaseKind::transport, 4);
  std::erase_if(plan.movement.phases, [](const Phase& phase) { return phase.begin_s > 4.1; });
  EXPECT_EQ(faults(plan), kUntil);
  EXPECT_EQ(faults(plan, PartialPlans::in_air), kNone);
}

TEST(DeliveredPart, AReachIsOneWithoutAGrasp) {
  Plan plan = partial_plan(PhaseKind::reach, 2);
  plan.movement.phases = {{PhaseKind::reach, 1, 2}, {PhaseKind::hold, 2, 2.5}};
  EXPECT_EQ(faults(plan), kNone);
}

TEST(DeliveredPart, IsShorterThanTheMovement) {
  Plan plan = partial_plan(PhaseKind::grasp, 2.2);
  plan.delivered->requested_end_s = 2.2;
  EXPECT_EQ(faults(plan), std::set<std::string>{"requested_end_s"});
}

TEST(DeliveredPart, PlansEndWhereTheirKindSays) {
  Movement movement = partial_plan(PhaseKind::grasp, 2.2).movement;
  for (const PhaseKind kind : {PhaseKind::lift, PhaseKind::place, PhaseKind::release,
                               PhaseKind::return_phase, PhaseKind::transport, PhaseKind::grasp})
    EXPECT_EQ(planned_end_s(movement, kind), planned_end(movement, kind)->end_s) << name_of(kind);
  std::erase_if(movement.phases,
                [](const Phase& phase) { return phase.kind > PhaseKind::approach; });
  EXPECT_EQ(planned_end_s(movement, PhaseKind::place), 4);
  EXPECT_EQ(planned_end_s(movement, PhaseKind::home), 6);
  std::erase_if(movement.phases, [](const Phase& phase) { return phase.begin_s > 2; });
  EXPECT_EQ(planned_end_s(movement, PhaseKind::home), 2.2);
}

TEST(RefiningPhases, LieWhereTransportAndReturnAre) {
  const auto phase_faults = [](const auto& forge) {
    Plan plan = partial_plan(PhaseKind::release, 4.5);
    for (Phase& phase : plan.movement.phases) forge(phase);
    ViolationLog log("");
    verify_phases(plan, log);
    std::set<std::string> subjects;
    for (const Violation& violation : log.finish()) subjects.insert(violation.subject);
    return subjects;
  };
  EXPECT_EQ(phase_faults([](Phase&) {}), kNone);
  for (const PhaseKind kind : {PhaseKind::lift, PhaseKind::place, PhaseKind::release,
                               PhaseKind::retreat, PhaseKind::home}) {
    const auto moved = [&](double by_s) {
      return phase_faults([&](Phase& phase) {
        if (phase.kind != kind) return;
        phase.begin_s += by_s;
        phase.end_s += by_s;
      });
    };
    EXPECT_TRUE(moved(-0.7).contains(std::string(name_of(kind)))) << name_of(kind);
    EXPECT_FALSE(moved(1.2).empty()) << name_of(kind);
  }
}

}  // namespace
}  // namespace morphe::verify
