#include "stages/import/recording/file_kind.hpp"

#include <algorithm>
#include <span>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

using namespace std::string_view_literals;

/// The bytes at the beginning of a kind of file, and a word that must follow somewhere in its head.
struct Signature {
  std::string_view begin;
  std::string_view word;  ///< "" if there is none
  const char* name;
  const char* advice;
  bool pointer = false;
};

constexpr const char* kConvert =
    "convert the recording to one of the formats in docs/formats.md, such as CSV";

constexpr Signature kBinary[] = {
    {"PK\3\4"sv, "xl/"sv, "an Excel workbook", "save the sheet as CSV UTF-8"},
    {"PK\3\4"sv, "[Content_Types].xml"sv, "an Office document", "save the table as CSV UTF-8"},
    {"PK\3\4"sv, "mimetypeapplication/vnd.oasis.opendocument.spreadsheet"sv,
     "an OpenDocument spreadsheet", "save the sheet as CSV UTF-8"},
    {"PK\3\4"sv, "data.pkl"sv, "a PyTorch file", "save its arrays with numpy.savez"},
    {"\xD0\xCF\x11\xE0"sv, ""sv, "an old Office document (such as .xls)",
     "save the sheet as CSV UTF-8"},
    {"\x93NUMPY"sv, ""sv, "a single NumPy array (.npy)",
     "save the arrays of the clip together with numpy.savez; see docs/clips.md"},
    {"\x80\x02"sv, ""sv, "a Python pickle",
     "load it in Python and save its arrays with numpy.savez"},
    {"\x80\x03"sv, ""sv, "a Python pickle",
     "load it in Python and save its arrays with numpy.savez"},
    {"\x80\x04"sv, ""sv, "a Python pickle",
     "load it in Python and save its arrays with numpy.savez"},
    {"\x80\x05"sv, ""sv, "a Python pickle",
     "load it in Python and save its arrays with numpy.savez"},
    {"\x1F\x8B"sv, ""sv, "a gzip archive", "unpack it: gunzip or tar xzf"},
    {"BZh"sv, ""sv, "a bzip2 archive", "unpack it"},
    {"\xFD"
     "7zXZ"sv,
     ""sv, "an xz archive", "unpack it"},
    {"\x28\xB5\x2F\xFD"sv, ""sv, "a zstd archive", "unpack it"},
    {"7z\xBC\xAF"sv, ""sv, "a 7z archive", "unpack it"},
    {"Rar!"sv, ""sv, "a RAR archive", "unpack it"},
    {"MATLAB 5.0 MAT-file"sv, ""sv, "a MATLAB file (.mat)",
     "write its points to CSV with writetable or writematrix"},
    {"MATLAB 7.3 MAT-file"sv, ""sv, "a MATLAB file (.mat)",
     "write its points to CSV with writetable or writematrix"},
    {"PAR1"sv, ""sv, "a Parquet file", "save the table as CSV, or its arrays with numpy.savez"},
    {"ARROW1"sv, ""sv, "an Arrow file", "save the table as CSV, or its arrays with numpy.savez"},
    {"SQLite format 3"sv, ""sv, "an SQLite database", kConvert},
    {"#ROSBAG"sv, ""sv, "a ROS bag", kConvert},
    {"\x89MCAP"sv, ""sv, "an MCAP log of ROS 2", kConvert},
    {"\x89PNG"sv, ""sv, "a picture (PNG)", "give the recording itself"},
    {"\xFF\xD8\xFF"sv, ""sv, "a picture (JPEG)", "give the recording itself"},
    {"GIF8"sv, ""sv, "a picture (GIF)", "give the recording itself"},
    {"RIFF"sv, ""sv, "a video or sound (RIFF)", "give the tracked motion, not the video"},
    {"\x1A\x45\xDF\xA3"sv, ""sv, "a video (Matroska)", "give the tracked motion, not the video"},
    {"%PDF"sv, ""sv, "a PDF document", "give the recording itself"},
    {"Kaydara FBX Binary"sv, ""sv, "an FBX scene", "export its skeleton as BVH"},
    {"glTF"sv, ""sv, "a glTF scene", "export its skeleton as BVH"},
    {"\x7F"
     "ELF"sv,
     ""sv, "a program", "give the recording itself"},
    {"\xFF\xFE\0\0"sv, ""sv, "text in UTF-32", "save it as UTF-8"},
    {"\x89HDF"sv, "morphe-plans"sv, "a plans.h5, the result of a run",
     "give the recording or its demonstrations.h5; `morphe list`, `explain` and `report` read "
     "plans"},
    {"\x89HDF"sv, "morphe-demonstrations"sv, "a demonstrations.h5, already imported",
     "give it to `morphe run --dataset` or `morphe inspect`"},
};

constexpr Signature kText[] = {
    {"version https://git-lfs"sv, ""sv, "a Git LFS pointer, not the recording itself",
     "fetch it: git lfs pull", true},
    {"/annex/objects/"sv, ""sv, "a git-annex pointer, not the recording itself",
     "fetch it: git annex get", true},
    {"{\"nbformat"sv, ""sv, "a notebook", "give the recording itself"},
    {"<!doctype html"sv, ""sv, "a web page, perhaps that of a download",
     "download the file itself"},
    {"<html"sv, ""sv, "a web page, perhaps that of a download", "download the file itself"},
    {"<"sv, "<robot"sv, "a robot description (URDF or SRDF)",
     "give a recording here, and the robot with `morphe setup` or in the config"},
    {"<"sv, "<mujoco"sv, "a model of MuJoCo",
     "give a recording here; robots are read from URDF by `morphe setup`"},
    {"<"sv, "<sdf"sv, "a model in SDF",
     "give a recording here; robots are read from URDF by `morphe setup`"},
    {"<"sv, "<opensimdocument"sv, "an OpenSim model or setup",
     "give the markers (.trc) from which the motion was computed"},
    {"<"sv, ""sv, "an XML file", kConvert},
    {"{"sv, ""sv, "a JSON file", kConvert},
    {"["sv, "\":"sv, "a JSON file", kConvert},
    {"[["sv, ""sv, "a JSON file", kConvert},
    {":version"sv, ":root"sv, "an ASF skeleton", "convert it and its motion (.amc) to BVH"},
    {"#!oml:asf"sv, ""sv, "an AMC motion", "convert it and its skeleton (.asf) to BVH"},
    {"solid "sv, "facet"sv, "a mesh (STL)", "give the recording itself"},
    {"ply"sv, "end_header"sv, "a mesh or point cloud (PLY)", "give the recording itself"},
    {"{\\rtf"sv, ""sv, "a rich text document", "save it as plain text"},
    {"recordings:"sv, ""sv, "a manifest", "its name must end in .yaml"},
};

std::optional<FileKind> kind_in(std::span<const Signature> signatures, std::string_view head) {
  const auto matching = std::ranges::find_if(signatures, [&](const Signature& signature) {
    return head.starts_with(signature.begin) && head.find(signature.word) != head.npos;
  });
  if (matching == signatures.end()) return std::nullopt;
  return FileKind{matching->name, matching->advice, matching->pointer};
}

}  // namespace

std::optional<FileKind> foreign_file_kind(std::string_view head) {
  if (head.find_first_not_of(" \t\r\n"sv) == head.npos) {
    return FileKind{head.empty() ? "empty" : "empty but for blanks",
                    "record or copy it again: the recording is not in it"};
  }
  if (head.find_first_not_of('\0') == head.npos)
    return FileKind{"filled with zeros", "copy it again: the recording is not in it"};
  if (head.size() > 11 && head.substr(4, 4) == "ftyp"sv)
    return FileKind{"a video (MP4)", "give the tracked motion, not the video"};
  if (head.size() > 262 && head.substr(257, 5) == "ustar"sv)
    return FileKind{"a tar archive", "unpack it"};
  if (const auto kind = kind_in(kBinary, head)) return kind;
  if (head.starts_with("PK\3\4"sv) && head.find(".npy") == head.npos)
    return FileKind{"a zip archive", "unpack it"};
  if (head.find('\0') != head.npos) return std::nullopt;
  return kind_in(kText, to_lower(trim(head, " \t\r\n")));
}

}  // namespace morphe::imports
