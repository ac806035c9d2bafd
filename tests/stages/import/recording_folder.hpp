#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/motion/input_error.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {

/// A folder of a test's own for recordings that it writes.
class RecordingFolder : public testing::Test {
 protected:
  RecordingFolder() { std::filesystem::create_directories(folder_); }
  ~RecordingFolder() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text, const std::string& name = "trial.csv") {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// In the recorded axes, whichever way the person faces.
  Demonstration read(ImportRequest request) {
    request.conventions.forward = ForwardSource::recorded;
    std::vector<Demonstration> read;
    import_recordings(request, [&](Demonstration&& d) { read.push_back(std::move(d)); });
    return read.at(0);
  }
  Demonstration read(const std::filesystem::path& file, const Conventions& conventions = {}) {
    ImportRequest request;
    request.paths = {file};
    request.conventions = conventions;
    return read(request);
  }
  /// What is wrong, without the folder; "no error" if nothing is.
  std::string error_of(const std::filesystem::path& file, const Conventions& conventions = {}) {
    try {
      read(file, conventions);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string folder = folder_.string() + "/";
      if (message.starts_with(folder)) message.erase(0, folder.size());
      return message;
    }
    return "no error";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("morphe_" + test_name());

 private:
  static std::string test_name() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "_" + info->name();
    for (char& c : name) c = c == '/' ? '_' : c;
    return name;
  }
};

}  // namespace morphe::imports
