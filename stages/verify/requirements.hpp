#pragma once

#include "core/motion/plan_request.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `config` violations if a plan with a trajectory differs from the request:
/// required_clearance, …, max_goal_gap_s   a tolerance that is not the config's
/// goals              frames are not spaced by the config's step; 1e-6 s
/// begin_s, end_s     not the begin of the first phase and the end of the last phase to be planned;
///                    1e-9 s
/// requested_end_s    the same of a partial plan, which ends earlier
/// approach, retreat  absent though requested, or present though not requested
/// OBJECT             an object of the config is missing, moves, or has another shape, size, mesh
///                    or pose (1e-6) than config and inputs give it; the target has another shape
/// carried_by         the target is attached to another frame than the request's, or to any though
///                    the movement ends before its attach_s
/// OBJECT/origin      it is not known whether an object was configured, recorded or inferred, an
///                    object of the config is not configured, or an object is inferred that is
///                    neither table nor target
/// clearance_by_kind  absent from a certificate with a clearance
/// must_be_known      an inferred table or target that the config requires to be known
/// sample_rate_hz     two samples of a motion are not a step of the controller apart; 1e-9 s
/// Records a `flag` violation for each of its flags that the config refuses and nobody accepted,
/// and the violations of verify_scene_shapes() and verify_placement().
void verify_requirements(const RobotModel& robot, const Plan& plan, const PlanRequest& request,
                         ViolationLog& violations);
/// Records the same violations of tolerances, times and placement for a plan without a trajectory.
/// (It may have failed before or after the tolerances of contacts were applied.)
void verify_infeasible_requirements(const RobotModel& robot, const Plan& plan,
                                    const PlanRequest& request, ViolationLog& violations);

/// Records `config` violations of shapes that follow from the request:
/// TARGET/shape          not that of `scene.target.body`
/// TARGET/shape_origin   that of a target which was not recorded is configured without a radius in
///                       the request, or inferred in spite of one
/// TARGET/size           its radius is not the request's, or outside of the bounds
/// NAME/size             a capsule of the person's other arm has another radius
void verify_scene_shapes(const Plan& plan, const PlanRequest& request, ViolationLog& violations);
/// Returns true if two objects have the same shape, to 1e-6 m of the vertices of a mesh.
bool same_shape(const SceneObject& a, const SceneObject& b);

/// Records a `robot` violation for each column in which a stored robot table differs from the
/// requested one: other names or counts, or numbers x that differ by more than 1e-9 max(1, |x|).
void verify_robot(const RobotModel& stored, const RobotModel& request, ViolationLog& violations);

/// Records an `assumption` violation for each assumption of robot, config and settings that the
/// stored ones lack, and for each stored one that is not requested.
void verify_assumptions(const std::vector<Assumption>& stored,
                        const std::vector<Assumption>& request, ViolationLog& violations);

/// Returns true if a plan with a clearance says neither the origin of any object nor the clearances
/// by kind, as in files of earlier versions.
bool lacks_origins_and_kinds(const Plan& plan);
/// Records `config` violations of the origins of a plan's objects and of its clearances by kind,
/// see verify_requirements(). A plan that lacks all of them is accepted; verify_file() demands
/// them.
void verify_origins(const Plan& plan, const PlanRequest& request, ViolationLog& violations);

}  // namespace morphe::verify
