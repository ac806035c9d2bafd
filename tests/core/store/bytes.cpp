#include "core/store/bytes.hpp"

#include <gmock/gmock.h>

#include "core/store/plan_file.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

/// What a file holds of a plan, as the bytes of the whole file.
std::string file_of(const Plan& plan) {
  const auto file = fresh_file("plans.h5");
  PlanWriter writer(file, plan_header(), small_robot());
  writer.add(plan);
  writer.finish();
  return bytes_of(file);
}

TEST(Bytes, AFileMadeFromThemIsTheFileMadeFromThePlan) {
  for (const Plan& plan : {full_plan("zz", 3), infeasible_plan("a name", 0)}) {
    const std::string bytes = bytes_of(plan);
    EXPECT_TRUE(file_of(plan_from_bytes(bytes)) == file_of(plan));
    EXPECT_TRUE(bytes_of(plan_from_bytes(bytes)) == bytes);
  }
}

TEST(Bytes, RobotAndHeaderComeBack) {
  const std::string robot = bytes_of(small_robot()), header = bytes_of(plan_header());
  EXPECT_TRUE(bytes_of(robot_from_bytes(robot)) == robot);
  EXPECT_TRUE(bytes_of(header_from_bytes(header)) == header);
}

TEST(Bytes, EveryFieldOfADemonstrationCounts) {
  const Demonstration one = full_demonstration("one");
  const std::string bytes = bytes_of(one);
  Demonstration other = one;
  other.name = "two";
  EXPECT_FALSE(bytes_of(other) == bytes);
  other = one;
  other.streams.hand->time.back() = -1;
  EXPECT_FALSE(bytes_of(other) == bytes);
  other = one;
  other.labels.pop_back();
  EXPECT_FALSE(bytes_of(other) == bytes);
  EXPECT_TRUE(bytes_of(full_demonstration("one")) == bytes);
}

/// The shape of an array is as its item has it: a rotation has four numbers, a pose sixteen. Bytes
/// that said otherwise were read beyond their end.
TEST(Bytes, ShapesOfBlobsAreComparedInFull) {
  const std::string bytes = bytes_of(full_plan("zz", 0));
  for (const std::string name : {"wrist_orientation", "wrist_position"}) {
    const std::size_t at = bytes.find(name);
    ASSERT_NE(at, std::string::npos);
    std::string forged = bytes;
    const std::size_t columns = at + name.size() + 2 * sizeof(std::uint64_t);
    const auto wide = static_cast<std::uint64_t>(forged[columns]);
    ASSERT_EQ(wide, name == "wrist_orientation" ? 4u : 3u);
    forged[columns] = 1;
    EXPECT_EQ(input_error([&] { plan_from_bytes(forged); }), "is damaged") << name;
  }
}

TEST(Bytes, NothingMayFollowAPlanARobotOrAHeader) {
  const std::string plan = bytes_of(full_plan("zz", 0)), robot = bytes_of(small_robot()),
                    header = bytes_of(plan_header());
  for (const std::string& more : {std::string(1, '\0'), plan}) {
    EXPECT_EQ(input_error([&] { plan_from_bytes(plan + more); }), "is damaged");
    EXPECT_EQ(input_error([&] { robot_from_bytes(robot + more); }), "is damaged");
    EXPECT_EQ(input_error([&] { header_from_bytes(header + more); }), "is damaged");
  }
}

TEST(Bytes, DamagedOnesAreRefusedOrReadAsSomethingElse) {
  const std::string bytes = bytes_of(full_plan("zz", 0));
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_EQ(input_error([&] { plan_from_bytes(bytes.substr(0, length)); }), "is damaged");
  }
  for (std::size_t place = 0; place < bytes.size(); place += 13) {
    std::string flipped = bytes;
    flipped[place] = static_cast<char>(flipped[place] ^ 0x80);
    input_error([&] { plan_from_bytes(flipped); });  // no crash, no huge allocation
  }
}

}  // namespace
}  // namespace morphe::store
