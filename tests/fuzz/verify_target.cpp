#include <cstdint>
#include <cstring>

#include "core/store/consistency.hpp"
#include "stages/verify/verify.hpp"
#include "targets.hpp"
#include "tests/stages/verify/planar_plan.hpp"

namespace morphe::fuzz {
namespace {

struct Forged {
  RobotModel robot = planar::robot();
  Plan plan = planar::plan();
};

template <class Values>
void add(Values& values, std::vector<double*>& all) {
  for (auto& value : values) all.push_back(&value);
}
void add(Vec3& point, std::vector<double*>& all) { add<Vec3>(point, all); }
void add(JointRows& rows, std::vector<double*>& all) {
  for (Eigen::Index k = 0; k < rows.size(); ++k) all.push_back(rows.data() + k);
}

/// Every number of a plan that the file holds and somebody may change.
std::vector<double*> numbers_of(Forged& f) {
  std::vector<double*> all;
  for (JointVector* v :
       {&f.robot.lower, &f.robot.upper, &f.robot.velocity, &f.robot.acceleration, &f.robot.jerk})
    add(*v, all);
  for (RobotModel::Capsule& capsule : f.robot.capsules) {
    all.push_back(&capsule.radius);
    add(capsule.from, all);
    add(capsule.to, all);
  }
  Trajectory& t = f.plan.trajectory;
  add(t.time, all);
  add(t.demonstration_time, all);
  add(t.clearance, all);
  for (JointRows* rows : {&t.position, &t.velocity, &t.acceleration}) add(*rows, all);
  add(f.plan.goals.time, all);
  for (Vec3& point : f.plan.goals.tip_position.values) add(point, all);
  for (SceneObject& object : f.plan.scene.objects) {
    add(object.size, all);
    add(object.time, all);
    for (Vec3& point : object.position) add(point, all);
    for (Quat& turn : object.orientation) add(turn.coeffs(), all);
    all.push_back(&object.attach_s);
    all.push_back(&object.release_s);
  }
  return all;
}

/// Changes, 10 bytes each: which number, and what it becomes. What a reader would refuse is not
/// judged.
void verify_forged(std::string_view bytes) {
  Forged forged;
  const std::vector<double*> numbers = numbers_of(forged);
  std::uint16_t which = 0;
  constexpr std::size_t kChange = sizeof which + sizeof(double);
  for (; bytes.size() >= kChange; bytes.remove_prefix(kChange)) {
    std::memcpy(&which, bytes.data(), sizeof which);
    std::memcpy(numbers[which % numbers.size()], bytes.data() + sizeof which, sizeof(double));
  }
  if (!store::inconsistency(forged.robot).empty() ||
      !store::inconsistency(forged.plan, forged.robot).empty())
    return;
  verify::verify_plan(forged.robot, "a/000", forged.plan);
}

}  // namespace

std::vector<Target> verify_targets() { return {{"verify", verify_forged}}; }

}  // namespace morphe::fuzz
