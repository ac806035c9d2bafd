#include "core/store/demonstration_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "same_flags.hpp"
#include "same_scene.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void expect_same(const Streams& all_a, const Streams& all_b) {
  ASSERT_TRUE(all_b.markers && all_b.sensors && all_b.skeleton && all_b.arm_angles && all_b.hand);
  {
    const MarkerStream &a = *all_a.markers, &b = *all_b.markers;
    EXPECT_SAME(names);
    EXPECT_SAME(time);
    EXPECT_SAME(position);
  }
  for (auto stream : {&Streams::sensors, &Streams::skeleton}) {
    const BodyStream &a = *(all_a.*stream), &b = *(all_b.*stream);
    EXPECT_SAME(names);
    EXPECT_SAME(parents);
    EXPECT_SAME(time);
    EXPECT_SAME(position);
    EXPECT_SAME(orientation);
  }
  {
    const AngleStream &a = *all_a.arm_angles, &b = *all_b.arm_angles;
    EXPECT_SAME(joints);
    EXPECT_SAME(time);
    EXPECT_SAME(angles);
  }
  const HandStream &a = *all_a.hand, &b = *all_b.hand;
  EXPECT_SAME(kind);
  EXPECT_SAME(names);
  EXPECT_SAME(time);
  EXPECT_SAME(angles);
  EXPECT_SAME(position);
}

void expect_same(const Demonstration& a, const Demonstration& b) {
  EXPECT_SAME(name);
  EXPECT_SAME(subject);
  EXPECT_SAME(task);
  EXPECT_SAME(hand);
  EXPECT_SAME(source);
  EXPECT_SAME(licence);
  ASSERT_TRUE(b.upper_arm && b.forearm && b.hand_length && b.hand_breadth);
  EXPECT_SAME(upper_arm.value());
  EXPECT_SAME(forearm.value());
  EXPECT_SAME(hand_length.value());
  EXPECT_SAME(hand_breadth.value());
  expect_same(a.streams, b.streams);
  expect_same(a.calibration, b.calibration);
  store::expect_same(a.objects, b.objects);
  store::expect_same(a.flags, b.flags);
  EXPECT_EQ(a.assumptions, b.assumptions);
  ASSERT_EQ(a.accepted_flags.size(), b.accepted_flags.size());
  for (std::size_t i = 0; i < a.accepted_flags.size(); ++i) {
    EXPECT_SAME(accepted_flags[i].code);
  }
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t i = 0; i < a.labels.size(); ++i) {
    EXPECT_SAME(labels[i].begin_s);
    EXPECT_SAME(labels[i].end_s);
    EXPECT_SAME(labels[i].phase);
  }
}

void write_demonstrations(const std::filesystem::path& file,
                          const std::vector<Demonstration>& all) {
  DemonstrationWriter writer(file);
  for (const Demonstration& demonstration : all) writer.add(demonstration);
  writer.finish();
}

TEST(DemonstrationFile, ReturnsEveryFieldBitForBit) {
  const auto file = fresh_file("d.h5");
  const Demonstration full = full_demonstration("DR2");
  write_demonstrations(file, {full});
  expect_same(full, DemonstrationReader(file).read(0));
}

TEST(DemonstrationFile, ReturnsEveryKindOfHand) {
  const auto file = fresh_file("d.h5");
  std::vector<Demonstration> all(2);
  all[0].name = "angles";
  all[0].streams.hand = {HandKind::joint_angles, {"a", "b"}, {0.5}, JointRows::Ones(1, 2), {}};
  all[1].name = "tips";
  all[1].streams.hand = {HandKind::fingertips, {}, {0.5}, {}, Array2D<Vec3>(1, 5, Vec3::Ones())};
  write_demonstrations(file, all);
  const DemonstrationReader reader(file);
  for (std::size_t i = 0; i < 2; ++i) {
    const HandStream a = *all[i].streams.hand, b = reader.read(i).streams.hand.value();
    EXPECT_SAME(kind);
    EXPECT_SAME(names);
    EXPECT_SAME(angles);
    EXPECT_SAME(position);
  }
}

TEST(DemonstrationFile, AbsentStaysAbsentAndEmptyStaysEmpty) {
  const auto file = fresh_file("d.h5");
  Demonstration bare;
  bare.name = "bare";
  bare.streams.markers = {{}, {}, {}};
  write_demonstrations(file, {bare});
  const Demonstration back = DemonstrationReader(file).read(0);
  EXPECT_FALSE(back.upper_arm || back.forearm || back.hand_length || back.hand_breadth);
  EXPECT_TRUE(back.streams.markers && back.streams.markers->names.empty());
  EXPECT_FALSE(back.streams.sensors || back.streams.skeleton || back.streams.arm_angles ||
               back.streams.hand || back.calibration.markers);
  EXPECT_TRUE(back.objects.empty() && back.labels.empty());
}

TEST(DemonstrationFile, SameCallsSameBytes) {
  const auto first = fresh_file("first.h5"), second = fresh_file("second.h5");
  for (const auto& file : {first, second})
    write_demonstrations(file, {full_demonstration("b"), full_demonstration("a")});
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(DemonstrationFile, KeepsTheOrderAlsoOfMany) {
  const auto file = fresh_file("d.h5");
  std::vector<Demonstration> all(100);  // more than fit into a group's header
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].name = fmt::format("take {}", (i * 37) % 100);
    names.push_back(all[i].name);
  }
  write_demonstrations(file, all);
  EXPECT_EQ(DemonstrationReader(file).names(), names);
}

TEST(DemonstrationFile, RefusesNamesAndArraysThatDoNotFit) {
  const auto file = fresh_file("d.h5");
  DemonstrationWriter writer(file);
  Demonstration demo;
  const auto add = [&](const std::string& name) {
    demo.name = name;
    return input_error([&] { writer.add(demo); });
  };
  EXPECT_EQ(add("a"), "");
  EXPECT_EQ(add("a"), file.string() + ":/demonstrations/a: already exists");
  EXPECT_THAT(add("a/b"), HasSubstr("'a/b' is not a valid name"));
  EXPECT_THAT(add(""), HasSubstr("'' is not a valid name"));
  demo.streams.markers = {{"m"}, {0, 1}, Array2D<Vec3>(3, 1, Vec3::Zero())};
  EXPECT_EQ(add("c"), file.string() + ":/demonstrations/c/markers/position: has 3 rows, not 2");
}

TEST(DemonstrationFile, LeavesNothingWithoutFinish) {
  const auto file = fresh_file("d.h5");
  const auto part = file.string() + ".part";
  {
    DemonstrationWriter writer(file);
    writer.add(full_demonstration("a"));
    EXPECT_TRUE(std::filesystem::exists(part));
  }
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_FALSE(std::filesystem::exists(file));
  write_demonstrations(file, {});
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_EQ(DemonstrationReader(file).size(), 0u);
}

TEST(DemonstrationFile, FolderThatIsNotThere) {
  EXPECT_THAT(input_error([] { DemonstrationWriter writer("/nonexistent/d.h5"); }),
              HasSubstr("/nonexistent/d.h5: cannot be written: No such file or directory"));
}

TEST(DemonstrationFile, ReadsWhatH5pyWrites) {
  const auto file = fresh_file("foreign.h5");
  ASSERT_EQ(run_python("write_demonstrations.py", file.string()), 0);
  const DemonstrationReader reader(file);
  EXPECT_THAT(reader.names(), ElementsAre("a", "b"));  // no creation order in the file: by name
  const Demonstration a = reader.read(0);
  EXPECT_EQ(a.subject, "S 1");
  EXPECT_EQ(a.hand, Side::right);
  ASSERT_TRUE(a.streams.markers);
  EXPECT_THAT(a.streams.markers->names, ElementsAre("one", "two"));
  EXPECT_THAT(a.streams.markers->time, ElementsAre(0, 1, 2));  // integers in the file
  EXPECT_EQ(a.streams.markers->position(1, 1), Vec3(9, 10, 11));
  ASSERT_EQ(a.labels.size(), 1u);
  EXPECT_EQ(a.labels[0].phase, PhaseKind::reach);
}

TEST(DemonstrationFile, LooksLikeTheContractToH5py) {
  const auto file = fresh_file("d.h5");
  write_demonstrations(file, {full_demonstration("zz"), full_demonstration("aa")});
  EXPECT_EQ(run_python("check_demonstrations.py", file.string()), 0);
}

}  // namespace
}  // namespace morphe::store
