#include "core/files/zip_archive.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

#include "core/files/little_endian.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

constexpr std::uint64_t kMaxUnpacked_bytes = std::uint64_t{1} << 30;
/// Values of fields whose number is in the zip64 record.
constexpr std::uint64_t kZip64Marker32 = 0xFFFFFFFF, kZip64Marker16 = 0xFFFF;
constexpr std::uint64_t kMaxDeflateRatio = 1032;  ///< bytes that deflate can produce from one
constexpr std::size_t kEndBytes = 22, kLocatorBytes = 20, kEnd64Bytes = 56;
constexpr std::size_t kEntryBytes = 46, kLocalBytes = 30;
constexpr std::uint64_t kEndSignature = 0x06054b50, kLocatorSignature = 0x07064b50,
                        kEnd64Signature = 0x06064b50;
constexpr std::uint64_t kEntrySignature = 0x02014b50, kLocalSignature = 0x04034b50;
constexpr std::uint64_t kEncryptedFlag = 1, kUtf8Flag = 1 << 11, kDosEpochDate = 1 << 5 | 1;
constexpr std::uint64_t kStored = 0, kDeflated = 8;

struct Entry {
  std::string name;
  std::uint64_t flags = 0, method = 0, checksum = 0, compressed_size = 0, uncompressed_size = 0;
  std::uint64_t offset = 0;
};

struct Archive {
  std::string_view bytes;
  const std::string& file;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", file, what));
  }
  [[noreturn]] void fail(const std::string& name, const std::string& what) const {
    throw InputError(fmt::format("{}: {}: {}", file, name, what));
  }
  [[noreturn]] void fail_damaged() const {
    fail("is a damaged zip archive: its directory is broken");
  }

  std::uint64_t number(std::uint64_t offset, std::size_t count) const {
    return read_little_endian(text(offset, count), 0, count);
  }
  std::string_view text(std::uint64_t offset, std::uint64_t count) const {
    if (offset > bytes.size() || bytes.size() - offset < count) fail_damaged();
    return bytes.substr(offset, count);
  }
};

struct Directory {
  std::uint64_t offset = 0, size = 0, entries = 0;
};

Directory find_directory(const Archive& archive) {
  const std::size_t size = archive.bytes.size();
  const std::size_t earliest = size - std::min<std::size_t>(size, kEndBytes + kZip64Marker16);
  std::size_t end = size;
  for (std::size_t k = size - std::min(size, kEndBytes) + 1; end == size && k-- > earliest;) {
    // The length of the comment tells the record from a comment that contains the signature.
    if (size - k >= kEndBytes && archive.number(k, 4) == kEndSignature &&
        k + kEndBytes + archive.number(k + 20, 2) == size)
      end = k;
  }
  if (end == size) archive.fail("is not a complete zip archive: its directory is missing");
  if (archive.number(end + 4, 2) % kZip64Marker16 != 0)
    archive.fail("is one part of a split zip archive");
  Directory directory{archive.number(end + 16, 4), archive.number(end + 12, 4),
                      archive.number(end + 10, 2)};
  const bool large = directory.offset == kZip64Marker32 || directory.size == kZip64Marker32 ||
                     directory.entries == kZip64Marker16;
  if (!large || end < kLocatorBytes || archive.number(end - kLocatorBytes, 4) != kLocatorSignature)
    return directory;
  const std::uint64_t end64 = archive.number(end - kLocatorBytes + 8, 8);
  if (archive.text(end64, kEnd64Bytes).empty() || archive.number(end64, 4) != kEnd64Signature)
    archive.fail_damaged();
  return {archive.number(end64 + 48, 8), archive.number(end64 + 40, 8),
          archive.number(end64 + 32, 8)};
}

/// Reads sizes and offset that exceed 32 bits from the entry's extra field 1, in this order.
void read_zip64(const Archive& archive, std::string_view extra, Entry& entry) {
  while (extra.size() >= 4) {
    const std::uint64_t id = read_little_endian(extra, 0, 2),
                        size = read_little_endian(extra, 2, 2);
    if (extra.size() - 4 < size) archive.fail_damaged();
    std::string_view field = extra.substr(4, size);
    extra.remove_prefix(4 + size);
    if (id != 1) continue;
    for (std::uint64_t* value : {&entry.uncompressed_size, &entry.compressed_size, &entry.offset}) {
      if (*value != kZip64Marker32) continue;
      if (field.size() < 8) archive.fail_damaged();
      *value = read_little_endian(field, 0, 8);
      field.remove_prefix(8);
    }
  }
}

std::vector<Entry> read_directory(const Archive& archive) {
  const Directory directory = find_directory(archive);
  archive.text(directory.offset, directory.size);
  if (directory.entries > directory.size / kEntryBytes) archive.fail_damaged();
  std::vector<Entry> entries;
  std::uint64_t begin = directory.offset;
  for (std::uint64_t k = 0; k < directory.entries; ++k) {
    if (archive.number(begin, 4) != kEntrySignature) archive.fail_damaged();
    archive.text(begin, kEntryBytes);
    const std::uint64_t name = archive.number(begin + 28, 2), extra = archive.number(begin + 30, 2);
    Entry& entry = entries.emplace_back();
    entry.name = archive.text(begin + kEntryBytes, name);
    entry.flags = archive.number(begin + 8, 2);
    entry.method = archive.number(begin + 10, 2);
    entry.checksum = archive.number(begin + 16, 4);
    entry.compressed_size = archive.number(begin + 20, 4);
    entry.uncompressed_size = archive.number(begin + 24, 4);
    entry.offset = archive.number(begin + 42, 4);
    read_zip64(archive, archive.text(begin + kEntryBytes + name, extra), entry);
    begin += kEntryBytes + name + extra + archive.number(begin + 32, 2);
  }
  return entries;
}

std::string inflate_member(const Archive& archive, const Entry& entry, std::string_view packed) {
  if (entry.uncompressed_size > kMaxDeflateRatio * (entry.compressed_size + 1))
    archive.fail(entry.name, "is damaged: its stated unpacked size is impossible");
  std::string bytes(entry.uncompressed_size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) archive.fail(entry.name, "cannot be unpacked");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.avail_out == 0 && stream.avail_in == 0;
  inflateEnd(&stream);
  if (!whole) archive.fail(entry.name, "is damaged: it cannot be unpacked");
  return bytes;
}

std::uint64_t checksum_of(std::string_view bytes) {
  return crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()),
               static_cast<uInt>(bytes.size()));
}

ZipMember unpack(const Archive& archive, const Entry& entry) {
  if ((entry.flags & kEncryptedFlag) != 0) archive.fail(entry.name, "is encrypted");
  if (entry.method != kStored && entry.method != kDeflated) {
    archive.fail(
        entry.name,
        fmt::format("uses the compression method {}; only stored and deflated are supported",
                    entry.method));
  }
  if (archive.number(entry.offset, 4) != kLocalSignature) archive.fail_damaged();
  const std::uint64_t name = archive.number(entry.offset + 26, 2);
  const std::uint64_t extra = archive.number(entry.offset + 28, 2);
  if (archive.text(entry.offset + kLocalBytes, name) != entry.name) archive.fail_damaged();
  const std::string_view packed =
      archive.text(entry.offset + kLocalBytes + name + extra, entry.compressed_size);
  if (entry.method == kStored && entry.compressed_size != entry.uncompressed_size)
    archive.fail_damaged();
  ZipMember member{entry.name, entry.method == kStored ? std::string(packed)
                                                       : inflate_member(archive, entry, packed)};
  if (checksum_of(member.bytes) != entry.checksum)
    archive.fail(entry.name, "is damaged: its checksum is wrong");
  return member;
}

using Field = std::pair<std::uint64_t, std::size_t>;  ///< a number and its count of bytes

void append(std::initializer_list<Field> fields, std::string& out) {
  for (const auto& [value, count] : fields) append_little_endian(value, count, out);
}

/// Appends the fields that local headers and entries share, from version to extra field's length.
void append_common_fields(const ZipMember& member, std::string& out) {
  const std::uint64_t size = member.bytes.size(), checksum = checksum_of(member.bytes);
  append({{20, 2}, {kUtf8Flag, 2}, {kStored, 2}, {0, 2}, {kDosEpochDate, 2}}, out);
  append({{checksum, 4}, {size, 4}, {size, 4}, {member.name.size(), 2}, {0, 2}}, out);
}

}  // namespace

std::vector<ZipMember> unzip(std::string_view bytes, const std::string& file) {
  const Archive archive{bytes, file};
  const std::vector<Entry> entries = read_directory(archive);
  std::set<std::string_view> names;
  std::uint64_t total = 0;
  for (const Entry& entry : entries) {
    if (!names.insert(entry.name).second) archive.fail(entry.name, "appears twice");
    if (entry.uncompressed_size > kMaxUnpacked_bytes ||
        (total += entry.uncompressed_size) > kMaxUnpacked_bytes)
      archive.fail(entry.name, "makes the archive unpack to more than 1 GiB");
  }
  std::vector<ZipMember> members;
  for (const Entry& entry : entries) members.push_back(unpack(archive, entry));
  return members;
}

std::vector<std::string> zip_names(std::string_view bytes, const std::string& file) {
  std::vector<std::string> names;
  for (Entry& entry : read_directory({bytes, file})) names.push_back(std::move(entry.name));
  return names;
}

std::string zip(const std::vector<ZipMember>& members, const std::string& file) {
  std::string out, directory;
  for (const ZipMember& member : members) {
    const std::size_t offset = out.size();
    if (offset + member.bytes.size() > kZip64Marker32 - kMaxUnpacked_bytes ||
        member.name.size() > kZip64Marker16)
      throw InputError(fmt::format("{}: {}: is too large to be written", file, member.name));
    append_little_endian(kLocalSignature, 4, out);
    append_common_fields(member, out);
    out += member.name + member.bytes;
    append({{kEntrySignature, 4}, {20, 2}}, directory);
    append_common_fields(member, directory);
    append({{0, 10}, {offset, 4}}, directory);  // no comment, disk 0, no attributes
    directory += member.name;
  }
  const std::size_t offset = out.size(), count = members.size();
  if (count >= kZip64Marker16) throw InputError(file + ": has too many members to be written");
  out += directory;
  append({{kEndSignature, 4}, {0, 4}, {count, 2}, {count, 2}}, out);
  append({{directory.size(), 4}, {offset, 4}, {0, 2}}, out);
  return out;
}

}  // namespace morphe::files
