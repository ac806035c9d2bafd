#include "pipeline/planning/contact_posture.hpp"

#include <algorithm>
#include <memory>

#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/constants.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"
#include "stages/grasp/surface_contact_term.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::planning {
namespace {

/// Returns `start`, and the same with the joints that need not stay spread over their limits.
std::vector<JointVector> contact_starts(const robot::Robot& robot, const JointVector& start,
                                        const JointVector& stay, std::uint64_t seed) {
  std::vector<JointVector> starts =
      map::spread_starts(robot, kContactStarts, math::seed_from(seed, "contact starts"));
  for (JointVector& other : starts) {
    other = start + kContactStartShare * (other - start);
    for (Eigen::Index j = 0; j < start.size(); ++j) {
      if (stay[j] > 0) other[j] = start[j];
    }
  }
  starts.insert(starts.begin(), start);
  return starts;
}

}  // namespace

ContactPosture solve_contact_posture(const map::MappingProblem& problem, std::size_t frame,
                                     const std::vector<grasp::DesiredContact>& contacts,
                                     const JointVector& start, const JointVector& stay,
                                     const map::MapOptions& options, std::uint64_t seed) {
  const robot::Robot& robot = *problem.robot;
  const collision::CollisionWorld& world = *problem.world;
  const collision::Solid target = collision::solid_at(world, world.target);
  const Pose base_from_target = recorded_pose(target.object, problem.time[frame]);
  map::MappingProblem sliding = problem;
  sliding.goals[frame].pad_normal.clear();  // the normals of the surface take their place
  sliding.objective.get<humanlike::TipPosition>().weight = kSlideWeight_per_m2;
  humanlike::CustomTerms& terms = sliding.objective.get<humanlike::CustomTerms>();
  terms.weight = 1;
  terms.entries.push_back({"", 1,
                           std::make_shared<const grasp::SurfaceContactTerm>(
                               robot, contacts, target, base_from_target)});
  map::MappingScratch scratch;
  solve::Minimum best;
  for (const JointVector& from : contact_starts(robot, start, stay, seed)) {
    solve::Minimum found =
        map::solve_frame_near(sliding, frame, from, stay, options.frame_solver, scratch);
    const bool first = best.x.size() == 0;
    if (first || found.value < kContactStartAdvantage * best.value) best = std::move(found);
  }
  ContactPosture posture{best.x, contacts};
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, best.x, base_from_frame);
  for (grasp::DesiredContact& contact : posture.contacts) {
    const Vec3 pad = robot::tracked_point(robot, base_from_frame, contact.tip, 1);
    contact = grasp::project_contact(robot, target, base_from_target.inverse() * pad, contact);
    contact = grasp::limit_slide(robot, target, contact);
  }
  return posture;
}

}  // namespace morphe::planning
