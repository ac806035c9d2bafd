#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "core/files/sha256.hpp"
#include "core/store/plan_file.hpp"
#include "planar_plan.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

using Causes = std::set<std::string>;  ///< "cause subject"

PlanFileHeader header_of_test() {
  PlanFileHeader header;
  header.software = "morphe test";
  header.dataset_sha256 = std::string(64, '0');
  header.config_sha256 = files::sha256(header.config);
  return header;
}

class VerifyFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / fmt::format("morphe_verify_{}", getpid());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const Plan& plan) {
    const std::filesystem::path file = folder_ / "plans.h5";
    std::filesystem::remove(file);
    PlanFileHeader header = header_of_test();
    store::PlanWriter writer(file, header, planar::robot());
    Plan infeasible = planar::plan();
    infeasible.movement.index = 1;
    infeasible.movement.begin_s += 0.1;
    infeasible.reason = Reason::tracking;
    infeasible.trajectory = {};
    infeasible.certificate = {};
    infeasible.grasp = {};
    writer.add(plan);
    writer.add(infeasible);
    writer.finish();
    return file;
  }

  /// Exit status of tests/verify_plans.py and what it found.
  std::pair<int, Causes> python(const std::filesystem::path& file) {
    const std::string out = (folder_ / "out.json").string();
    const int status =
        std::system(fmt::format("/usr/bin/python3 {}/tests/verify_plans.py {} --json > {}",
                                MORPHE_SOURCE_DIR, file.string(), out)
                        .c_str());
    std::stringstream text;
    text << std::ifstream(out).rdbuf();
    const std::string json = text.str();
    const std::regex row(R"re("cause": "([^"]*)",\s*"subject": "([^"]*)")re");
    Causes causes;
    for (std::sregex_iterator it(json.begin(), json.end(), row), end; it != end; ++it)
      causes.insert((*it)[1].str() + " " + (*it)[2].str());
    return {WEXITSTATUS(status), causes};
  }

  std::filesystem::path folder_;
};

TEST_F(VerifyFile, AgreesWithThePythonScriptOnEveryMutation) {
  struct Case {
    const char* cause;  ///< that must be among those found, "" = none
    std::function<void(Plan&)> mutate;
  };
  const auto place = [](Plan& plan, std::size_t object, double time_s) {
    plan.scene.objects[object].position[0] = planar::tip_at(planar::position_at(time_s));
  };
  const Case cases[] = {
      {"", [](Plan&) {}},
      {"position elbow", [](Plan& plan) { plan.trajectory.position(50, 1) = 1.6; }},
      {"velocity shoulder", [](Plan& plan) { plan.trajectory.velocity(30, 0) = 2.5; }},
      {"rest proximal", [](Plan& plan) { plan.trajectory.acceleration(100, 2) = 0.01; }},
      {"object_collision distal/bottle", [&](Plan& plan) { place(plan, 0, 0.5); }},
      {"object_collision distal/rod",
       [&](Plan& plan) {
         plan = planar::plan(0.1);
         place(plan, 2, 0.55);
       }},
      {"tracking index", [](Plan& plan) { plan.goals.tip_position(75, 1).z() += 0.008; }},
      {"certificate duration_ratio", [](Plan& plan) { plan.certificate.duration_ratio = 1; }},
      {"certificate clearance", [](Plan& plan) { plan.certificate.clearance = 0.006; }},
      {"object_collision distal/cup", [](Plan& plan) { plan.movement.target = ""; }},
      {"object_collision distal/crate",
       [&](Plan& plan) {  // a box that falls and turns into the way
         SceneObject crate = plan.scene.objects[3];
         crate.name = "crate";
         crate.size = {0.3, 0.004, 0.3};
         crate.time = {2.1, 2.3, 2.5};
         const Vec3 at = planar::tip_at(planar::position_at(0.5));
         crate.position = {at + Vec3(0, 0, 0.8), at + Vec3(0.1, 0, 0.2), at + Vec3(0.1, 0.1, 0)};
         crate.orientation = {Quat::Identity(), Quat(Eigen::AngleAxisd(1, Vec3::UnitZ())),
                              Quat(Eigen::AngleAxisd(2, Vec3(0.6, 0, 0.8)))};
         plan.scene.objects.push_back(crate);
       }},
      {"self_collision forearm/distal",  // the finger folds back onto the arm
       [](Plan& plan) { plan.trajectory.position.col(2) *= 4.4; }},
      {"time time", [](Plan& plan) { plan.trajectory.time[10] = plan.trajectory.time[9]; }},
      {"finite velocity", [](Plan& plan) { plan.trajectory.velocity(3, 1) = kUnknown; }},
  };
  for (const Case& c : cases) {
    Plan plan = planar::plan();
    c.mutate(plan);
    const std::filesystem::path file = write(plan);
    const VerifyReport report = verify_file(file);
    EXPECT_EQ(report.executable, 1);
    EXPECT_EQ(report.infeasible, 1);
    Causes causes;
    for (const Violation& v : report.violations) {
      EXPECT_EQ(v.plan, "reach/000");
      causes.insert(v.cause + " " + v.subject);
    }
    EXPECT_EQ(causes.count(c.cause), *c.cause ? 1u : 0u) << c.cause;
    const auto [status, found] = python(file);
    EXPECT_EQ(status, causes.empty() ? 0 : 1) << c.cause;
    EXPECT_EQ(found, causes) << c.cause;
  }
}

TEST_F(VerifyFile, IsTheSameOnAnyNumberOfThreads) {
  const std::filesystem::path file = folder_ / "plans.h5";
  PlanFileHeader header = header_of_test();
  store::PlanWriter writer(file, header, planar::robot());
  for (int index = 0; index < 12; ++index) {
    Plan plan = planar::plan();
    plan.demonstration = fmt::format("reach{:02}", index);
    if (index % 3 == 1) plan.trajectory.velocity(30 + index, 0) = 2.5;
    if (index % 4 == 2) plan.goals.tip_position(75, 1).z() += 0.008;
    writer.add(plan);
  }
  writer.finish();
  const VerifyReport alone = verify_file(file);
  EXPECT_EQ(alone.executable, 12);
  EXPECT_GE(alone.violations.size(), 7u);
  for (const int jobs : {2, 5}) {
    EXPECT_EQ(verify_json(verify_file(file, {}, jobs)), verify_json(alone)) << jobs;
  }
}

TEST_F(VerifyFile, NamesAHashThatIsNoneAndAMovementTwice) {
  const std::filesystem::path file = folder_ / "plans.h5";
  PlanFileHeader header = header_of_test();
  header.dataset_sha256 = "unknown";
  store::PlanWriter writer(file, header, planar::robot());
  Plan plan = planar::plan();
  writer.add(plan);
  plan.movement.index = 1;
  writer.add(plan);
  writer.finish();
  Causes found;
  for (const Violation& v : verify_file(file).violations)
    found.insert(v.plan + " " + v.cause + " " + v.subject);
  EXPECT_EQ(found,
            (Causes{" structure @dataset_sha256 is no hash", "reach/001 structure begin_s"}));
}

}  // namespace
}  // namespace morphe::verify
