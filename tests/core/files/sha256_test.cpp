#include "core/files/sha256.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

// FIPS 180-4 examples.
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* kOfNothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kOfAMillionA =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

TEST(Sha256, KnownVectors) {
  EXPECT_EQ(sha256("abc"), kOfAbc);
  EXPECT_EQ(sha256(""), kOfNothing);
  EXPECT_EQ(sha256(std::string(1000000, 'a')), kOfAMillionA);
}

TEST(Sha256, FilesOfAnySize) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "hash_test.bin";
  std::ofstream(file, std::ios::binary) << std::string(1000000, 'a');
  EXPECT_EQ(sha256_of_file(file), kOfAMillionA);
  std::ofstream(file, std::ios::binary).close();
  EXPECT_EQ(sha256_of_file(file), kOfNothing);
  std::string blocks(1 << 21, 'b');  // a whole number of blocks
  std::ofstream(file, std::ios::binary) << blocks;
  EXPECT_EQ(sha256_of_file(file), sha256(blocks));
  std::filesystem::remove(file);
  EXPECT_THAT(
      [&] { sha256_of_file(file); },
      testing::ThrowsMessage<InputError>(testing::StrEq(file.string() + ": cannot be read")));
}

}  // namespace
}  // namespace morphe::files
