"""What a plans.h5 holds, in twenty lines: read_plans.py PLANS.h5 (or the folder of a run)."""
import sys

import morphe

with morphe.Plans(sys.argv[1]) as plans:
    print(f"{plans.robot.name}, {len(plans.robot.joints)} joints, written by {plans.software}")
    for plan in plans:
        if plan.trajectory is None:
            print(f"{plan.name}: {plan.status}: {plan.reason}: {plan.detail}")
            continue
        print(f"{plan.name}: {plan.status}, {plan.duration:.3f} s, {1000 * plan.certificate.clearance:.2f} mm clear")
        for each in plan.assumptions_of("inferred"):
            print(f"  inferred: {each.subject}: {each.value}")
        if plan.grasp is not None:
            time = plan.trajectory.time[plan.grasp.sample]
            thumb = plan.tip_poses(time)[0, :3, 3]
            print(f"  grasps {plan.target} at {time:.3f} s, {plan.robot.tips[0].name} at {thumb.round(3)} m,",
                  f"fastest joint {abs(plan.at(time).velocity).max():.3f} per s")
