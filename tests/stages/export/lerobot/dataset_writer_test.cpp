#include "stages/export/lerobot/dataset_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>

namespace morphe::exports {
namespace {

class LeRobotDatasetFiles : public testing::Test {
 protected:
  LeRobotDatasetFiles()
      : folder(std::filesystem::path(testing::TempDir()) /
               ("lerobot_" + std::to_string(getpid()))) {}
  ~LeRobotDatasetFiles() override { std::filesystem::remove_all(folder); }

  files::AtomicFile& new_file(const std::string& name) {
    std::filesystem::create_directories((folder / name).parent_path());
    names.push_back(name);
    return files.emplace_back(folder / name);
  }
  nlohmann::json json(const std::string& name) const {
    std::ifstream stream(folder / name);
    return nlohmann::json::parse(stream);
  }

  const std::filesystem::path folder;
  std::list<files::AtomicFile> files;
  std::vector<std::string> names;
};

Episode some_episode(int number) {
  const Eigen::Index frames = 1 + number % 3;
  JointRows state(frames, 2), phase = JointRows::Constant(frames, 1, number % 2);
  for (Eigen::Index k = 0; k < frames; ++k)
    state.row(k) << 0.1 * static_cast<double>(k), 0.001 * number;
  return {number % 2 == 0 ? "even" : "odd", {state, phase}};
}

TEST_F(LeRobotDatasetFiles, TenThousandEpisodesAreDividedIntoSmallFiles) {
  constexpr int kEpisodes = 10000;
  LeRobotDataset dataset{
      30, "arm", {{"observation.state", {"a.pos", "b.pos"}}, {"phase", {"phase"}, true}}};
  dataset.max_file_bytes = 2'000'000;
  dataset.files_per_chunk = 3;
  LeRobotWriter writer(
      dataset, [this](const std::string& name) -> files::AtomicFile& { return new_file(name); });
  for (int k = 0; k < kEpisodes; ++k) writer.add(some_episode(k));
  writer.finish({{"train", {0, kEpisodes}}});
  int data_files = 0, episode_files = 0, chunks = 0;
  for (files::AtomicFile& file : files) file.commit();
  for (const std::string& name : names) {
    EXPECT_LE(std::filesystem::file_size(folder / name), 2'000'000u) << name;
    data_files += name.starts_with("data/") ? 1 : 0;
    episode_files += name.starts_with("meta/episodes/") ? 1 : 0;
    chunks += name.ends_with("/file-000.parquet") && name.starts_with("meta/episodes/") ? 1 : 0;
  }
  EXPECT_GE(data_files, 1);
  EXPECT_GE(episode_files, 4);
  EXPECT_EQ(chunks, (episode_files + 2) / 3);
  const nlohmann::json info = json("meta/info.json");
  EXPECT_EQ(info["total_episodes"], kEpisodes);
  EXPECT_EQ(info["total_frames"], 19999);
  EXPECT_EQ(info["total_tasks"], 2);
  EXPECT_EQ(info["chunks_size"], 3);
  EXPECT_EQ(info["splits"], (nlohmann::json{{"train", "0:10000"}}));
  const nlohmann::json stats = json("meta/stats.json");
  EXPECT_EQ(stats["index"]["max"][0], 19998);
  EXPECT_EQ(stats["phase"]["min"][0], 0);
  EXPECT_EQ(stats["phase"]["max"][0], 1);
  EXPECT_FLOAT_EQ(stats["observation.state"]["max"][1].get<float>(), 9.999F);
}

}  // namespace
}  // namespace morphe::exports
