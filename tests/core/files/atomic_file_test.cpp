#include "core/files/atomic_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class PartFileTest : public testing::Test {
 protected:
  PartFileTest() {
    folder = fs::path(testing::TempDir()) /
             (std::string("morphe_part_") +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    target = folder / "a.txt";
    part = folder / "a.txt.part";
  }
  ~PartFileTest() override { fs::remove_all(folder); }
  std::string refused() const {
    try {
      write_atomically(target, "new");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder, target, part;
};

TEST_F(PartFileTest, ThePartOfAKilledProcessIsReplaced) {
  std::ofstream(part) << "half";
  write_atomically(target, "new");
  EXPECT_EQ(text_of(target), "new");
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(PartFileTest, LinksAreNotFollowed) {
  std::ofstream(folder / "victim") << "kept";
  fs::create_symlink(folder / "victim", part);
  EXPECT_THAT(refused(), HasSubstr("a.txt.part: exists and is not a regular file"));
  EXPECT_EQ(text_of(folder / "victim"), "kept");
  fs::remove(part);
  fs::create_hard_link(folder / "victim", part);
  write_atomically(target, "new");
  EXPECT_EQ(text_of(folder / "victim"), "kept");
}

TEST_F(PartFileTest, DevicesPipesAndFoldersAreNoOutputs) {
  fs::create_symlink("/dev/null", target);
  EXPECT_THAT(refused(), HasSubstr("is a device, pipe or socket"));
  fs::remove(target);
  ASSERT_EQ(::mkfifo(target.c_str(), 0600), 0);
  EXPECT_THAT(refused(), HasSubstr("is a device, pipe or socket"));
  fs::remove(target);
  fs::create_directory(target);
  EXPECT_THAT(refused(), HasSubstr("is a folder"));
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(PartFileTest, OfTwoAtOnceTheLaterWritesAndTheOtherSaysSo) {
  AtomicFile first(target), second(target);
  first.write("first");
  second.write("second");
  EXPECT_THAT(
      [&] { first.commit(); },
      ThrowsMessage<InputError>(StrEq(target.string() + ": another process is writing it")));
  second.commit();
  EXPECT_EQ(text_of(target), "second");
}

TEST_F(PartFileTest, AFileThatIsReadIsNotReplaced) {
  std::ofstream(folder / "input") << "read";
  fs::create_hard_link(folder / "input", target);
  EXPECT_THAT([&] { expect_not_input(target, folder / "input"); },
              ThrowsMessage<InputError>(
                  StrEq(target.string() + ": is an input file; writing it would replace it")));
  expect_not_input(folder / "other", folder / "input");
  expect_not_input("", folder / "input");
}

}  // namespace
}  // namespace morphe::files
