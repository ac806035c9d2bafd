#include "core/files/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <span>
#include <system_error>

#include "core/files/text_encoding.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

using namespace std::string_view_literals;

/// The bytes at the beginning of a kind of file, and a word that must follow somewhere in its head.
struct Signature {
  std::string_view begin;
  std::string_view word;  ///< "" if there is no such word
  const char* name;
  const char* advice;  ///< "" if only the reader of the file knows the way
  bool pointer = false, unwrapped = false;
};

/// The root element of a kind of XML file.
struct XmlKind {
  std::string_view root;
  const char* name;
  const char* advice;
  bool unwrapped = false;
};

constexpr const char* kConvert =
    "convert the recording to one of the formats in docs/formats.md, such as CSV";
constexpr const char* kSaveSheet = "save the sheet as CSV UTF-8";
constexpr const char* kSaveArrays = "load it in Python and save its arrays with numpy.savez";
constexpr const char* kSaveTable = "save the table as CSV, or its arrays with numpy.savez";
constexpr const char* kUnpack = "unpack it";
constexpr const char* kExportBvh = "export its skeleton as BVH";
constexpr const char* kWriteMatlab = "write its points to CSV with writetable or writematrix";
constexpr const char* kTrackedMotion = "give the tracked motion, not the video";
constexpr const char* kGiveRobot =
    "give a recording here, and the robot with `morphe robot setup` or in the config";

constexpr Signature kBinary[] = {
    {"PK\3\4"sv, "xl/"sv, "an Excel workbook", kSaveSheet},
    {"PK\3\4"sv, "[Content_Types].xml"sv, "an Office document", "save the table as CSV UTF-8"},
    {"PK\3\4"sv, "mimetypeapplication/vnd.oasis.opendocument.spreadsheet"sv,
     "an OpenDocument spreadsheet", kSaveSheet},
    {"PK\3\4"sv, "data.pkl"sv, "a PyTorch file", "save its arrays with numpy.savez"},
    {"PK\3\4"sv, ".usd"sv, "a USD scene (usdz)", ""},
    {"PXR-USDC"sv, ""sv, "a USD scene", ""},
    {"\xD0\xCF\x11\xE0"sv, ""sv, "an old Office document (such as .xls)", kSaveSheet},
    {"\x93NUMPY"sv, ""sv, "a single NumPy array (.npy)",
     "save the arrays of the clip together with numpy.savez; see docs/clips.md"},
    {"\x80\x02"sv, ""sv, "a Python pickle", kSaveArrays},
    {"\x80\x03"sv, ""sv, "a Python pickle", kSaveArrays},
    {"\x80\x04"sv, ""sv, "a Python pickle", kSaveArrays},
    {"\x80\x05"sv, ""sv, "a Python pickle", kSaveArrays},
    {"\x1F\x8B"sv, ""sv, "a gzip archive", "unpack it: gunzip or tar xzf", false, true},
    {"BZh"sv, ""sv, "a bzip2 archive", kUnpack, false, true},
    {"\xFD"
     "7zXZ"sv,
     ""sv, "an xz archive", kUnpack, false, true},
    {"\x28\xB5\x2F\xFD"sv, ""sv, "a zstd archive", kUnpack, false, true},
    {"7z\xBC\xAF"sv, ""sv, "a 7z archive", kUnpack, false, true},
    {"Rar!"sv, ""sv, "a RAR archive", kUnpack, false, true},
    {"MATLAB 5.0 MAT-file"sv, ""sv, "a MATLAB file (.mat)", kWriteMatlab},
    {"MATLAB 7.3 MAT-file"sv, ""sv, "a MATLAB file (.mat)", kWriteMatlab},
    {"PAR1"sv, ""sv, "a Parquet file", kSaveTable},
    {"ARROW1"sv, ""sv, "an Arrow file", kSaveTable},
    {"SQLite format 3"sv, ""sv, "an SQLite database", kConvert},
    {"#ROSBAG"sv, ""sv, "a ROS bag", kConvert},
    {"\x89MCAP"sv, ""sv, "an MCAP log of ROS 2", kConvert},
    {"\x89PNG"sv, ""sv, "a picture (PNG)", ""},
    {"\xFF\xD8\xFF"sv, ""sv, "a picture (JPEG)", ""},
    {"GIF8"sv, ""sv, "a picture (GIF)", ""},
    {"RIFF"sv, ""sv, "a video or sound (RIFF)", kTrackedMotion},
    {"\x1A\x45\xDF\xA3"sv, ""sv, "a video (Matroska)", kTrackedMotion},
    {"%PDF"sv, ""sv, "a PDF document", ""},
    {"Kaydara FBX Binary"sv, ""sv, "an FBX scene", kExportBvh},
    {"glTF"sv, ""sv, "a glTF scene", kExportBvh},
    {"BLENDER"sv, ""sv, "a Blender file", kExportBvh},
    {"\x7F"
     "ELF"sv,
     ""sv, "a program", ""},
    {"\xFF\xFE\0\0"sv, ""sv, "text in UTF-32", "save it as UTF-8", false, true},
    {"\x89HDF"sv, "morphe-plans"sv, "a plans.h5, the result of a run",
     "give the recording or its demonstrations.h5; `morphe list`, `explain` and `report` read "
     "plans"},
    {"\x89HDF"sv, "morphe-demonstrations"sv, "a demonstrations.h5, already imported",
     "give it to `morphe run --dataset` or `morphe inspect`"},
};

constexpr Signature kText[] = {
    {"version https://git-lfs"sv, ""sv, "a Git LFS pointer, not the file itself",
     "fetch it: git lfs pull", true, true},
    {"/annex/objects/"sv, ""sv, "a git-annex pointer, not the file itself",
     "fetch it: git annex get", true, true},
    {"{\"nbformat"sv, ""sv, "a notebook", ""},
    {"{"sv, ""sv, "a JSON file", kConvert},
    {"["sv, "\":"sv, "a JSON file", kConvert},
    {"[["sv, ""sv, "a JSON file", kConvert},
    {":version"sv, ":root"sv, "an ASF skeleton", "convert it and its motion (.amc) to BVH"},
    {"#!oml:asf"sv, ""sv, "an AMC motion", "convert it and its skeleton (.asf) to BVH"},
    {"#usda"sv, ""sv, "a USD scene", ""},
    {"iso-10303-21"sv, ""sv, "a CAD model (STEP)", ""},
    {"solid "sv, "facet"sv, "a mesh (STL)", ""},
    {"ply"sv, "end_header"sv, "a mesh or point cloud (PLY)", ""},
    {"{\\rtf"sv, ""sv, "a rich text document", "save it as plain text", false, true},
    {"recordings:"sv, ""sv, "a manifest", "its name must end in .yaml"},
};

constexpr XmlKind kXml[] = {
    {"html"sv, "a web page, perhaps that of a download", "download the file itself", true},
    {"robot"sv, "a robot description (URDF or SRDF)", kGiveRobot},
    {"mujoco"sv, "a model of MuJoCo (MJCF)", kGiveRobot},
    {"sdf"sv, "a model in SDF", "give a recording here; robots are read from URDF or MJCF"},
    {"opensimdocument"sv, "an OpenSim model or setup",
     "give the markers (.trc) from which the motion was computed"},
    {"collada"sv, "a mesh (Collada)", ""},
    {""sv, "an XML file", kConvert},
};

std::string lower(std::string_view text) {
  std::string lowered(text);
  std::ranges::transform(lowered, lowered.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lowered;
}

std::string_view without_leading_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"sv), text.size()));
}

std::optional<FileKind> kind_in(std::span<const Signature> signatures, std::string_view head) {
  const auto matching = std::ranges::find_if(signatures, [&](const Signature& signature) {
    return head.starts_with(signature.begin) && head.find(signature.word) != head.npos;
  });
  if (matching == signatures.end()) return std::nullopt;
  return FileKind{matching->name, matching->advice, matching->pointer, matching->unwrapped};
}

FileKind xml_kind(std::string_view text) {
  const std::string root = xml_root_name(text);
  const auto matching = std::ranges::find_if(
      kXml, [&](const XmlKind& kind) { return kind.root.empty() || kind.root == root; });
  return {matching->name, matching->advice, false, matching->unwrapped};
}

}  // namespace

std::string xml_root_name(std::string_view text) {
  for (text = without_leading_blanks(text); text.starts_with('<');
       text = without_leading_blanks(text)) {
    const bool comment = text.starts_with("<!--"sv);
    if (!comment && !text.starts_with("<?"sv) && !text.starts_with("<!"sv)) {
      const std::string_view name = text.substr(1, text.find_first_of(" \t\r\n/>"sv) - 1);
      return lower(name);
    }
    if (!comment && lower(text.substr(0, 14)) == "<!doctype html") return "html";
    const std::string_view end = comment ? "-->"sv : ">"sv;
    const std::size_t at = text.find(end);
    if (at == text.npos) break;
    text.remove_prefix(at + end.size());
  }
  return "";
}

std::optional<FileKind> file_kind(std::string_view head) {
  const std::string_view text = without_leading_blanks(head);
  if (text.empty()) {
    return FileKind{head.empty() ? "empty" : "empty but for blanks",
                    "record or copy it again: the content is not in it", false, true};
  }
  if (head.find_first_not_of('\0') == head.npos)
    return FileKind{"filled with zeros", "copy it again: the content is not in it", false, true};
  if (head.size() > 11 && head.substr(4, 4) == "ftyp"sv)
    return FileKind{"a video (MP4)", kTrackedMotion};
  if (head.size() > 262 && head.substr(257, 5) == "ustar"sv)
    return FileKind{"a tar archive", kUnpack, false, true};
  if (const auto kind = kind_in(kBinary, head)) return kind;
  if (head.starts_with("PK\3\4"sv) && head.find(".npy") == head.npos)
    return FileKind{"a zip archive", kUnpack, false, true};
  if (head.find('\0') != head.npos) return std::nullopt;
  if (text.starts_with('<')) return xml_kind(text);
  return kind_in(kText, lower(text));
}

namespace {

constexpr std::size_t kHeadSize_bytes = 65536;  // a header may name hundreds of points

std::string head_on_disk(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    throw InputError(
        fmt::format("{}: is not a regular file; pipes cannot be read, as it is read more than once",
                    file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(status))
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::string head(kHeadSize_bytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

}  // namespace

std::string read_file_head(const std::filesystem::path& file, const GivenFiles* given) {
  const std::string head =
      given ? given->bytes(file).substr(0, kHeadSize_bytes) : head_on_disk(file);
  if (const auto order = utf16_order(head)) return utf8_from_utf16(head, *order);
  return head.starts_with("\xEF\xBB\xBF") ? head.substr(3) : head;
}

}  // namespace morphe::files
