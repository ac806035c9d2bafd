#include <fmt/format.h>
#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "core/store/demonstration_file.hpp"
#include "core/store/hdf5_file.hpp"
#include "core/store/plan_file.hpp"
#include "sample_data.hpp"

/// Asked for by the leak sanitizer: HDF5 itself forgets an object header whose checksum failed.
extern "C" [[gnu::visibility("default")]] const char* __lsan_default_suppressions() {
  return "leak:libhdf5_serial";
}

namespace morphe::store {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::filesystem::path sample_plans() {
  const auto file = fresh_file("plans.h5");
  PlanFileHeader header = plan_header();
  header.config = "seed: 7\n";
  PlanWriter writer(file, header, small_robot());
  writer.add(full_plan("zz", 0));
  writer.add(infeasible_plan("zz", 1));
  writer.finish();
  return file;
}

/// What reading all of a file complains about.
std::string complaint(const std::filesystem::path& file) {
  return input_error([&] {
    const PlanReader reader(file);
    for (std::size_t i = 0; i < reader.size(); ++i) reader.read(i);
  });
}

TEST(DamagedFiles, WhatIsNoHdf5File) {
  const auto file = sample_plans();
  const std::string bytes = bytes_of(file), name = file.string();
  ASSERT_EQ(complaint(file), "");
  for (const std::string& content :
       {std::string(), std::string("demonstrations"), bytes.substr(0, bytes.size() / 2),
        bytes.substr(0, bytes.size() - 1), bytes.substr(0, 10)}) {
    write_bytes(file, content);
    EXPECT_EQ(complaint(file), name + ": is not a readable HDF5 file");
    EXPECT_EQ(input_error([&] { DemonstrationReader reader(file); }),
              name + ": is not a readable HDF5 file");
  }
  std::filesystem::remove(file);
  EXPECT_EQ(complaint(file), name + ": cannot be opened: No such file or directory");
}

TEST(DamagedFiles, EachIsRefusedWithItsPlace) {
  const auto file = sample_plans();
  const auto folder = file.parent_path();
  ASSERT_EQ(run_python("damage.py", file.string() + " " + folder.string()), 0);
  const std::string plan = "/plans/zz/000/";
  const std::vector<std::pair<std::string, std::string>> expected{
      {"version", "/: @version is 4; this program reads only version 3"},
      {"older_version", "/: @version is 2; this program reads only version 3"},
      {"format",
       "/: is 'morphe-demonstrations', not 'morphe-plans': it has recordings, already "
       "imported; give the plans.h5 of a run"},
      {"no_format", "/: @format is missing; must be morphe-plans"},
      {"version_text", "/@version: is missing or not a single integer"},
      {"no_robot", "/robot: is missing"},
      {"robot_parent", "/robot/frames/parent: 1 is outside [-1, 1)"},
      {"robot_joint", "/robot/frames/joint: 3 is outside [-1, 3)"},
      {"robot_columns", "/robot/frames/ratio: has 3 rows, not 4"},
      {"robot_limit", "/robot/jerk: has 2 rows, not 3"},
      {"robot_tip", "/robot/tips/frame: -1 is outside [0, 4)"},
      {"robot_pair", "/robot/allowed_collision_pairs: 3 is outside [0, 3)"},
      {"robot_palm", "/robot/@palm_frame: 4 is outside [0, 4)"},
      {"movement_name", "/plans/zz/first: is not the number of a movement (000, 001, …)"},
      {"movement_dataset", "/plans/zz/007: is not a readable group"},
      {"missing", plan + "goals/tip_position: is missing"},
      {"missing_group", plan + "scene: is missing"},
      {"missing_attribute", plan + "@required_clearance: is missing or not a single number"},
      {"missing_trajectory", plan + "trajectory: has no samples, but the plan is not infeasible"},
      {"extra_trajectory", "/plans/zz/001/trajectory: exists, but the plan is infeasible"},
      {"rank", plan + "goals/tip_position: has shape [4,6], must be [*,*,3]"},
      {"rows", plan + "trajectory/velocity: has 5 rows, not 6"},
      {"columns", plan + "path/position: has 4 columns, not 3"},
      {"type", plan + "goals/time: must contain numbers"},
      {"fraction", plan + "path/origin: must contain integers"},
      {"status", "/plans/zz/000: @status is 'infeasible' with the @reason ''"},
      {"shape", plan + "scene/cup: @shape has the unknown value 'cube'"},
      {"size", plan + "scene/cup/@size: has 2 numbers, not 3"},
      {"no_sample", plan + "scene/cup/time: has no samples"},
      {"triangle", plan + "scene/apple/triangles: 4 is outside [0, 4)"},
      {"phase", plan + "trajectory/phase: 13 is outside [0, 13)"},
      {"origin", plan + "path/origin: 3 is outside [0, 3)"},
      {"mapped_status", plan + "mapped/status: 4 is outside [0, 4)"},
      {"grasp_sample", plan + "grasp/@sample: 6 is outside [0, 6)"},
      {"findings", plan + "findings/excess: has 3 rows, not 2"},
      {"offset", plan + "goals: @common_base_offset must have 3 numbers"},
      {"claim_more", plan + "goals/time: has more values than the file can contain"},
      {"elsewhere", plan + "goals/time: stores its values in another file"},
      {"dangling", plan + "goals/time: is not a readable dataset"},
  };
  for (const auto& [name, message] : expected) {
    const auto damaged = (folder / (name + ".h5")).string();
    EXPECT_EQ(complaint(damaged), damaged + ":" + message);
  }
  EXPECT_THAT(complaint(folder / "input_group_loop.h5"), HasSubstr("/inputs/again/"));
}

TEST(DamagedFiles, DemonstrationsOfAnotherVersionOrFormat) {
  const auto plans = sample_plans();
  EXPECT_EQ(input_error([&] { DemonstrationReader reader(plans); }),
            plans.string() +
                ":/: is 'morphe-plans', not 'morphe-demonstrations': it is a plans.h5, the "
                "result of a run; give the recording or its demonstrations.h5");
  for (const int version : {2, 4}) {
    const auto file = fresh_file("demonstrations.h5");
    {
      Hdf5File out = Hdf5File::create(file);
      write_format(out.root(), "morphe-demonstrations", version);
      out.close();
    }
    EXPECT_EQ(input_error([&] { DemonstrationReader reader(file); }),
              fmt::format("{}:/: @version is {}; this program reads only version 3", file.string(),
                          version));
  }
}

TEST(DamagedFiles, AChangedNumberFailsItsChecksum) {
  const auto file = sample_plans();
  std::string bytes = bytes_of(file);
  const double wanted = full_plan("zz", 0).trajectory.acceleration(2, 1);
  const std::string needle(reinterpret_cast<const char*>(&wanted), sizeof wanted);
  const std::size_t at = bytes.find(needle);
  ASSERT_NE(at, std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  write_bytes(file, bytes);
  EXPECT_THAT(complaint(file),
              EndsWith("is damaged, or memory is short: its values cannot be read"));
}

TEST(DamagedFiles, NoChangedByteEverCrashesTheReader) {
  const auto file = sample_plans();
  const std::string bytes = bytes_of(file);
  std::size_t refused = 0, tried = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 397, ++tried) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(~changed[at]);
    write_bytes(file, changed);
    const std::string message = complaint(file);
    if (message.empty()) continue;
    EXPECT_THAT(message, StartsWith(file.string() + ":"));
    ++refused;
  }
  EXPECT_GT(refused, tried / 2);
}

}  // namespace
}  // namespace morphe::store
