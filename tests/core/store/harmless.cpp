#include "core/store/sandbox_probe.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/stat.h>

#include "core/store/hdf5_file.hpp"
#include "core/store/plan_file.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

TEST(Harmless, FilesThatCanBeReadAndThoseThatCannotAreLeftToTheirReader) {
  const auto file = fresh_file("plans.h5");
  {
    PlanWriter writer(file, plan_header(), small_robot());
    writer.add(full_plan("zz", 0));
    writer.finish();
  }
  EXPECT_EQ(input_error([&] { probe_in_sandbox(file); }), "");
  const std::string bytes = bytes_of(file);
  for (std::size_t at = 8; at < bytes.size(); at += bytes.size() / 40) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x80);
    write_bytes(file, flipped);
    EXPECT_EQ(input_error([&] { probe_in_sandbox(file); }), "") << at;
  }
  EXPECT_EQ(input_error([&] { probe_in_sandbox(file.parent_path()); }), "");
  EXPECT_EQ(input_error([&] { probe_in_sandbox("/dev/zero"); }), "");
}

/// A group that holds itself is one object, however it is reached.
TEST(Harmless, AGroupThatHoldsItself) {
  const auto file = fresh_file("a.h5");
  const hid_t made = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t group = H5Gcreate2(made, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_hard(made, "/g", group, "again", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_hard(made, "/g", group, "and again", H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(group);
  H5Fclose(made);
  EXPECT_EQ(input_error([&] { probe_in_sandbox(file); }), "");
}

TEST(Hdf5File, APipeIsNoFile) {
  const auto pipe = fresh_file("pipe.h5");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(input_error([&] { Hdf5File::open(pipe); }), pipe.string() + ": is not a regular file");
}

}  // namespace
}  // namespace morphe::store
