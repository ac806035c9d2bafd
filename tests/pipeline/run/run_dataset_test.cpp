#include "pipeline/run/run_dataset.hpp"

#include <gmock/gmock.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/motion/input_error.hpp"
#include "core/store/demonstration_file.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kDemonstrations = 6;

/// Does what it is asked `good` times, then nothing any more.
struct FailingDisk : files::Disk {
  explicit FailingDisk(int good) : left(good) {}
  int left, error = ENOSPC;

  bool fails() {
    if (left-- > 0) return false;
    errno = error;
    return true;
  }
  std::int64_t write(int descriptor, const void* bytes, std::size_t count,
                     std::int64_t at) override {
    return fails() ? -1 : files::real_disk().write(descriptor, bytes, count, at);
  }
  int truncate(int descriptor, std::int64_t length) override {
    return fails() ? -1 : files::real_disk().truncate(descriptor, length);
  }
  int sync(int descriptor) override { return fails() ? -1 : files::real_disk().sync(descriptor); }
  int rename(const char* from, const char* to) override {
    return fails() ? -1 : files::real_disk().rename(from, to);
  }
};

class RunDataset : public testing::Test {
 protected:
  RunDataset() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("morphe_run_") + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    store::DemonstrationWriter writer(dataset());
    for (int k = 0; k < kDemonstrations; ++k) {
      Demonstration demonstration;
      demonstration.name = "d" + std::to_string(k);
      writer.add(demonstration);
    }
    writer.finish();
  }
  ~RunDataset() override { fs::remove_all(folder); }

  fs::path dataset() const { return folder / "demonstrations.h5"; }
  fs::path plans(const std::string& run) const { return folder / run / "plans.h5"; }

  RunResult run(const std::string& name, files::Disk& disk) const {
    fs::create_directories(folder / name);
    const auto journal = Journal::write(folder / name, "morphe 1.2.3", {}, false);
    RunRequest request;
    request.dataset = dataset();
    request.plans = plans(name);
    request.identity.software = "morphe 1.2.3";
    RobotModel robot = two_link_arm();
    robot.velocity = robot.acceleration = robot.jerk = JointVector::Ones(2);
    request.identity.robot = robot;
    request.config = "seed: 1\n";
    request.disk = &disk;
    request.plan = [](const Demonstration& demonstration) {
      DemonstrationOutcome outcome;
      outcome.demonstration = demonstration.name;
      Plan plan;
      plan.demonstration = demonstration.name;
      plan.reason = Reason::no_goal;
      plan.detail = std::string(3000, demonstration.name.back());
      outcome.plans = {plan};
      return outcome;
    };
    request.rows = [](const Plan& plan) { return plan.demonstration; };
    request.publish = [] {};
    Progress progress(Verbosity::quiet);
    return run_dataset(*journal, request, progress);
  }

  static std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
  }

  fs::path folder;
};

/// Whichever write, sync or rename is the first to fail: one error that names the file, nothing
/// under its name but what was there, nothing planned lost, and the same bytes once there is room.
TEST_F(RunDataset, ADiskThatFailsAnywhereLosesNothing) {
  FailingDisk good(1 << 30);
  EXPECT_EQ(run("whole", good).summary.movements, kDemonstrations);
  const std::string whole = bytes_of(plans("whole"));
  const int calls = (1 << 30) - good.left;
  ASSERT_GT(calls, kDemonstrations);
  int kept = 0;
  for (int at = 0; at < calls - 1; ++at) {  // the last one syncs the folder: the file is there
    const std::string name = "fails_at_" + std::to_string(at);
    fs::create_directories(folder / name);
    std::ofstream(plans(name)) << "an older result";
    FailingDisk failing(at);
    failing.error = at % 2 ? ENOSPC : EIO;
    try {
      run(name, failing);
      ADD_FAILURE() << "call " << at << " failed, and nobody noticed";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(plans(name).string()));
      EXPECT_THAT(error.what(), HasSubstr("cannot be written"));
      EXPECT_THAT(error.what(), HasSubstr(std::strerror(failing.error)));
    }
    EXPECT_EQ(bytes_of(plans(name)), "an older result") << "call " << at;
    EXPECT_FALSE(fs::exists(plans(name).string() + ".part")) << "call " << at;
    const BatchSummary again = run(name, files::real_disk()).summary;
    EXPECT_EQ(again.movements, kDemonstrations);
    EXPECT_EQ(bytes_of(plans(name)), whole) << "call " << at;
    kept += again.reused;
  }
  EXPECT_GT(kept, calls) << "what was planned before the disk failed is not planned again";
}

TEST_F(RunDataset, PlansOnlyWhatIsMissing) {
  EXPECT_EQ(run("one", files::real_disk()).summary.reused, 0);
  const std::string first = bytes_of(plans("one"));
  EXPECT_EQ(run("one", files::real_disk()).summary.reused, kDemonstrations);
  EXPECT_EQ(bytes_of(plans("one")), first);
}

}  // namespace
}  // namespace morphe::run
