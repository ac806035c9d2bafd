#include "stages/import/folders/manifest.hpp"

#include "recording_folder.hpp"

namespace morphe::imports {
namespace {

class Manifest : public RecordingFolder {};

const std::filesystem::path kShippedSets = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets";

void expect_equal(const ManifestEntry& a, const ManifestEntry& b) {
  const auto real = [](const std::string& path) {
    return path.empty() ? path : std::filesystem::weakly_canonical(path).string();
  };
  for (const auto path :
       {&ManifestEntry::file, &ManifestEntry::static_trial, &ManifestEntry::names})
    EXPECT_EQ(real(a.*path), real(b.*path));
  for (const auto text : {&ManifestEntry::name, &ManifestEntry::format, &ManifestEntry::subject,
                          &ManifestEntry::task, &ManifestEntry::source, &ManifestEntry::licence})
    EXPECT_EQ(a.*text, b.*text);
  EXPECT_EQ(a.hand, b.hand);
  EXPECT_EQ(a.conventions.axes, b.conventions.axes);
  EXPECT_EQ(a.conventions.unit, b.conventions.unit);
  EXPECT_EQ(a.conventions.rate_hz, b.conventions.rate_hz);
  EXPECT_EQ(a.upper_arm, b.upper_arm);
  EXPECT_EQ(a.forearm, b.forearm);
  EXPECT_EQ(a.notes, b.notes);
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t k = 0; k < a.labels.size(); ++k) {
    EXPECT_EQ(a.labels[k].phase, b.labels[k].phase);
    EXPECT_EQ(a.labels[k].begin_s, b.labels[k].begin_s);
    EXPECT_EQ(a.labels[k].end_s, b.labels[k].end_s);
  }
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    EXPECT_EQ(a.objects[k].name, b.objects[k].name);
    EXPECT_EQ(a.objects[k].markers, b.objects[k].markers);
    EXPECT_EQ(a.objects[k].size, b.objects[k].size);
  }
}

TEST_F(Manifest, WhatIsWrittenIsReadBack) {
  for (const char* folder : {"ue-adl", "pyomeca", "cmu-native", "dex-retargeting", "adroit-dapg"}) {
    std::vector<ManifestEntry> entries = read_manifest(kShippedSets / folder / "recordings.yaml");
    entries.front().notes = {"it's assumed: yes", "another # one"};
    const auto file = write(manifest_text(entries, folder_), "written.yaml");
    const std::vector<ManifestEntry> again = read_manifest(file);
    ASSERT_EQ(again.size(), entries.size()) << folder;
    for (std::size_t k = 0; k < again.size(); ++k) {
      SCOPED_TRACE(entries[k].file);
      expect_equal(again[k], entries[k]);
    }
  }
}

}  // namespace
}  // namespace morphe::imports
