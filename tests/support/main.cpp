#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

/// Runs the tests of a folder with a temporary directory of their own: ctest runs every test in a
/// process of its own and several at once, and they write files of the same names.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::string folder = (std::filesystem::temp_directory_path() / "morphe_test_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return EXIT_FAILURE;
  for (const char* name : {"TMPDIR", "TEST_TMPDIR"}) setenv(name, folder.c_str(), 1);
  const int failed = RUN_ALL_TESTS();
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return failed;
}
