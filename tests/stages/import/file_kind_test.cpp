#include "core/files/file_kind.hpp"

#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

class FileKinds : public RecordingFolder {};

TEST_F(FileKinds, AreSaidWithTheWayToTheRecording) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "is empty; "},
      {" \r\n\n", "is empty but for blanks; "},
      {std::string(100, '\0'), "is filled with zeros; "},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1234567\n",
       "is a Git LFS pointer, not the file itself; fetch it: git lfs pull"},
      {"/annex/objects/MD5E-s12--0.c3d\n", "fetch it: git annex get"},
      {"PK\3\4\x14\0\6\0\0\0\0\0"s + "[Content_Types].xml ... xl/workbook.xml",
       "an Excel workbook"},
      {"PK\3\4\x14\0\0\0\0\0trial.csv"s, "is a zip archive; unpack it"},
      {"\x80\4\x95\0\0"s, "is a Python pickle; load it in Python"},
      {"\x93NUMPY\1\0"s, "a single NumPy array"},
      {"\x1F\x8B\x08\0\0"s, "is a gzip archive; unpack it"},
      {"MATLAB 5.0 MAT-file, Platform\0"s, "a MATLAB file"},
      {"{\"frames\": []}", "is a JSON file; convert"},
      {"<?xml version=\"1.0\"?>\n<robot name=\"r\"/>", "a robot description (URDF or SRDF)"},
      {"<mujoco/>", "a model of MuJoCo"},
      {"<!DOCTYPE html><html>", "is a web page, perhaps that of a download"},
      {"\0\0\0\x18"s + "ftypmp42....", "is a video (MP4)"},
      {"%PDF-1.7\n", "a PDF document"},
  };
  for (const auto& [bytes, message] : cases)
    EXPECT_THAT(error_of(write(bytes, "trial.bvh")), HasSubstr(message));
}

TEST_F(FileKinds, OfRecordingsAndUnknownFilesAreNone) {
  for (const char* text : {"a,b\n1,2\n", "HIERARCHY\nROOT h", "Trajectories\n100\n", "hello"})
    EXPECT_FALSE(files::file_kind(text)) << text;
  EXPECT_THAT(error_of(write("hello", "trial.txt")), HasSubstr("format: not recognised"));
}

}  // namespace
}  // namespace morphe::imports
