#include "pipeline/explain/reasons.hpp"

namespace morphe::explain {
namespace {

constexpr FixedAdvice change(std::string_view sentence) {
  return {AdviceKind::changes_input, {}, sentence};
}
constexpr FixedAdvice relax(std::array<std::string_view, 2> settings, std::string_view sentence) {
  return {AdviceKind::relaxes_tolerance, settings, sentence};
}

constexpr std::array kHomeAdvice{
    change("choose another home posture (`approach.home`)"),
    relax({"approach=null"}, "plans no approach and retreat; the movement itself was planned")};
constexpr std::array kRetreatAdvice{
    change("choose another home posture (`approach.home`), or record until the object is released"),
    relax({"approach.retreat=false"}, "plans no retreat; movement and approach were planned")};

constexpr Dependence kOnInput{}, kOnSearch{false, false, true}, kOnBaseAndSearch{true, false, true},
    kOnBaseAndDistance{true, true, false}, kOnAll{true, true, true};

constexpr std::array<ReasonExplanation, enum_count<Reason>()> kExplanations{{
    {Reason::none, ""},
    {Reason::unplanned,
     "Not planned yet.",
     kOnInput,
     {change("run the same command again: it continues where it was stopped")}},
    {Reason::no_movement,
     "The demonstration has no complete reach, or it could not be reconstructed.",
     kOnInput,
     {change("the recording must contain a complete reach, from rest to rest; `morphe inspect` "
             "shows what was found in it"),
      relax({"segment.whole_recording=true"}, "the whole recording becomes one movement")}},
    {Reason::no_shoulder,
     "The person's shoulder was never seen during the movement.",
     kOnInput,
     {change("the shoulder must be seen at least once: record markers or sensors of shoulder, "
             "elbow and wrist")}},
    {Reason::no_goal,
     "The fingertips give too few goals to plan for.",
     kOnInput,
     {change("at least one fingertip must be seen during the grasp, and the movement must have at "
             "least five frames")}},
    {Reason::implausible_arm,
     "The reconstructed arm exceeds human joint limits.",
     kOnInput,
     {change("use `morphe inspect` to check the axes (`axes`, `forward`), the chosen hand, and "
             "whether names of left and right are swapped"),
      relax({"human.max_limit_violation_m=1"},
            "the reconstructed arm is followed although it exceeds human joint limits")}},
    {Reason::doubtful_recording,
     "The recording has a flag that the config refuses (audit.refuse).",
     kOnInput,
     {change("correct the recording, or accept its flags in its manifest if it is right")}},
    {Reason::start_in_collision, "The robot collides at the first sample of the path.", kOnAll},
    {Reason::goal_in_collision,
     "The robot collides at a goal: at some time in every posture found that reaches the goals, "
     "or at the end of the path.",
     kOnBaseAndDistance},
    {Reason::unreachable,
     "At some time no posture found reaches the goals, with or without obstacles.",
     kOnBaseAndDistance},
    {Reason::no_path, "The path collides, and no detour was found.", kOnAll},
    {Reason::smoothing_collision,
     "The path is collision-free, but the smooth curve through it is not.",
     kOnSearch,
     {change("move the base or the obstacles: a path farther from them has been tried")}},
    {Reason::joint_limit,
     "A joint would exceed its limits.",
     kOnBaseAndSearch,
     {change("correct the joint's limits, or move the base so that the joint stays within them")}},
    {Reason::jump,
     "The joints jump from one frame to the next, and no repair closed the gap.",
     kOnBaseAndSearch,
     {change("record without gaps, or move the base so that the arm does not change its branch")}},
    {Reason::tracking, "A fingertip is farther from its goal than the tolerance of the phase.",
     kOnAll},
    {Reason::invalid_path,
     "The path to be timed is not a valid path of this robot: a fault of Morphe.",
     kOnInput,
     {change("report it, with the recording and the config")}},
    {Reason::duration_too_short,
     "The path cannot be followed in the requested time.",
     kOnInput,
     {relax({"retime.mode=fastest", "retime.duration_s=null"},
            "the shortest duration that the limits allow")}},
    {Reason::not_held,
     "The target is carried without two opposed contacts that keep still in the hand.",
     kOnInput,
     {change("end the plan with the grasp (`segment.plan_until: grasp`), or enlarge "
             "`grasp.touch_distance` if the person held the target with more fingers"),
      change("without the section `grasp` of the config, carrying is not checked")}},
    {Reason::no_approach, "There is no approach from the home posture to the first sample.",
     kOnInput, kHomeAdvice},
    {Reason::no_retreat, "There is no retreat from the last sample back to the home posture.",
     kOnInput, kRetreatAdvice},
    {Reason::no_reference_frame,
     "An object of the scene is placed relative to something that does not exist.",
     kOnInput,
     {change("give the object another `relative_to`, or state a missing table by "
             "`scene.table.height`; a target exists only in movements with a grasp")}},
    {Reason::released_in_air,
     "The hand lets go of the target in the air, although it stood on something before.",
     kOnInput,
     {change("end the plan before (segment.plan_until), or add what the target is put down on to "
             "scene.objects")}},
    {Reason::not_known,
     "The plan would rest on something that is assumed, although the config requires it to be "
     "known "
     "(must_be_known).",
     kOnInput,
     {change(
          "give what is missing: record the object, or state it in the config (scene.table.height, "
          "scene.target.pose with scene.target.body), or the recording's property at import or in "
          "its manifest"),
      relax({"must_be_known=[]"}, "everything may be assumed")}},
    {Reason::rejected,
     "The independent verification rejects the trajectory: a fault of Morphe.",
     kOnInput,
     {change("report it, with the recording and the config")}},
}};

constexpr bool is_in_order() {
  for (std::size_t k = 0; k < kExplanations.size(); ++k) {
    if (static_cast<std::size_t>(kExplanations[k].reason) != k) return false;
  }
  return true;
}
static_assert(is_in_order(), "the explanations are in the order of the reasons");

}  // namespace

const ReasonExplanation& explanation_of(Reason reason) {
  return kExplanations.at(static_cast<std::size_t>(reason));
}

}  // namespace morphe::explain
