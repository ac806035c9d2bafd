#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/motion/input_error.hpp"
#include "core/store/plan_header.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/planning/plan_requirements.hpp"

namespace morphe::planning {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// Copies the shipped configs, so that what is loaded can be removed before it is loaded again.
class ReloadConfig : public testing::Test {
 protected:
  ReloadConfig() {
    fs::remove_all(configs);
    fs::create_directories(configs.parent_path());
    fs::copy(MORPHE_SOURCE_DIR "/configs", configs, fs::copy_options::recursive);
  }
  PlanFileHeader header(const LoadedConfig& loaded) const {
    PlanFileHeader header = header_of(loaded, "of no dataset");
    header.inputs_sha256 = store::inputs_hash(header);
    return header;
  }
  PlanFileHeader shelf(const std::vector<std::string>& settings = {}) const {
    return header(load_config(configs / "pipelines/pa10_dlr_hit2_shelf.yaml", settings));
  }
  static std::vector<std::string> faults_of(const PlanFileHeader& header) {
    return plan_requirements(header).header_faults;
  }
  static PlanFileHeader::Input& input(PlanFileHeader& header, const std::string& path) {
    return *std::ranges::find(header.inputs, path, &PlanFileHeader::Input::path);
  }
  fs::path configs = fs::path(testing::TempDir()) / "reload/configs";
};

TEST_F(ReloadConfig, EveryShippedPipelineFollowsFromItsHeader) {
  std::vector<PlanFileHeader> headers;
  for (const fs::directory_entry& entry : fs::directory_iterator(configs / "pipelines"))
    for (const RobotConfig& robot : load_robots(entry.path(), {"seed=3"}))
      headers.push_back(header(robot.loaded));
  ASSERT_GT(headers.size(), 10);
  fs::remove_all(configs);
  for (const PlanFileHeader& header : headers) {
    SCOPED_TRACE(header.settings.front());
    EXPECT_EQ(reload_config(header).effective, header.config);
    EXPECT_THAT(faults_of(header), IsEmpty());
  }
}

TEST_F(ReloadConfig, ChangesOfTheHeaderAreNamed) {
  const PlanFileHeader honest = shelf({"check.tracking_tolerance=0.04"});
  EXPECT_EQ(honest.settings.size(), 2);
  PlanFileHeader changed = honest;
  changed.settings.pop_back();
  EXPECT_THAT(faults_of(changed),
              ElementsAre("@config: check.tracking_tolerance 0.04 -> 0.05", "inputs_sha256"));
  changed.inputs_sha256 = store::inputs_hash(changed);
  EXPECT_THAT(faults_of(changed), ElementsAre("@config: check.tracking_tolerance 0.04 -> 0.05"));
  changed = honest;
  changed.inputs.push_back({"notes.yaml", "of: nothing"});
  EXPECT_THAT(faults_of(changed), Contains("/inputs/notes.yaml is not read"));
}

TEST_F(ReloadConfig, MeshesAreThoseOfTheInputs) {
  PlanFileHeader header = shelf();
  const SceneObject honest = plan_requirements(header).bodies.front().object;
  EXPECT_GT(honest.triangles.size(), 10U);
  std::string& bytes = input(header, "scenes/shelf.stl").text;
  const std::uint32_t rows = 12;
  bytes.replace(80, 4, std::string(reinterpret_cast<const char*>(&rows), 4));
  bytes.resize(84 + 50 * rows);
  EXPECT_LT(plan_requirements(header).bodies.front().object.triangles.size(),
            honest.triangles.size());
}

TEST_F(ReloadConfig, InputsThatCannotBeReadAreNamed) {
  PlanFileHeader header = shelf();
  std::string& text = input(header, "robots/pa10.yaml").text;
  const std::string honest = text;
  text += "name: again\n";
  EXPECT_THAT([&] { reload_config(header); },
              ThrowsMessage<InputError>(HasSubstr("/inputs/robots/pa10.yaml:")));
  text = honest;
  std::erase_if(header.inputs, [](const auto& own) { return own.path == "scenes/shelf.stl"; });
  EXPECT_THAT([&] { reload_config(header); },
              ThrowsMessage<InputError>(HasSubstr("/inputs: does not contain scenes/shelf.stl")));
  header.settings.clear();
  EXPECT_THAT([&] { reload_config(header); }, ThrowsMessage<InputError>(HasSubstr("/@settings")));
}

}  // namespace
}  // namespace morphe::planning
