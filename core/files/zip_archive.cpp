#include "core/files/zip_archive.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <set>

#include "core/files/little_endian.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kIn32 = 0xFFFFFFFF, kIn16 = 0xFFFF;  ///< "see zip64"
constexpr std::uint64_t kMostPacked = 1032;                  ///< bytes that deflate makes of one
constexpr std::size_t kEndSize = 22, kLocatorSize = 20, kEnd64Size = 56;
constexpr std::size_t kEntrySize = 46, kLocalSize = 30;
constexpr std::uint64_t kEndSign = 0x06054b50, kLocatorSign = 0x07064b50, kEnd64Sign = 0x06064b50;
constexpr std::uint64_t kEntrySign = 0x02014b50, kLocalSign = 0x04034b50;
constexpr std::uint64_t kEncrypted = 1, kUtf8 = 1 << 11, kFirstOf1980 = 1 << 5 | 1;
constexpr std::uint64_t kStored = 0, kDeflated = 8;

/// What the directory says of a member.
struct Entry {
  std::string name;
  std::uint64_t flags = 0, method = 0, checksum = 0, packed = 0, unpacked = 0, at = 0;
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
  [[noreturn]] void damaged() const { fail("is a damaged zip archive: its directory is broken"); }

  /// A number of `count` bytes; the archive must reach that far.
  std::uint64_t number(std::uint64_t at, std::size_t count) const {
    if (at > bytes.size() || bytes.size() - at < count) damaged();
    return little_endian(bytes, at, count);
  }
  std::string_view text(std::uint64_t at, std::uint64_t count) const {
    if (at > bytes.size() || bytes.size() - at < count) damaged();
    return bytes.substr(at, count);
  }
};

struct Directory {
  std::uint64_t at = 0, size = 0, entries = 0;
};

Directory find_directory(const Archive& archive) {
  const std::size_t size = archive.bytes.size();
  const std::size_t farthest = size - std::min<std::size_t>(size, kEndSize + kIn16);
  std::size_t end = size;
  for (std::size_t at = size - std::min(size, kEndSize) + 1; at-- > farthest;) {
    if (size - at < kEndSize || archive.number(at, 4) != kEndSign) continue;
    if (at + kEndSize + archive.number(at + 20, 2) != size) continue;  // a comment with the sign
    end = at;
    break;
  }
  if (end == size) archive.fail("is no whole zip archive: it ends without its directory");
  if (archive.number(end + 4, 2) % kIn16 != 0) archive.fail("is a part of a divided zip archive");
  Directory directory{archive.number(end + 16, 4), archive.number(end + 12, 4),
                      archive.number(end + 10, 2)};
  const bool large = directory.at == kIn32 || directory.size == kIn32 || directory.entries == kIn16;
  if (!large || end < kLocatorSize || archive.number(end - kLocatorSize, 4) != kLocatorSign) {
    return directory;
  }
  const std::uint64_t end64 = archive.number(end - kLocatorSize + 8, 8);
  if (archive.text(end64, kEnd64Size).empty() || archive.number(end64, 4) != kEnd64Sign) {
    archive.damaged();
  }
  return {archive.number(end64 + 48, 8), archive.number(end64 + 40, 8),
          archive.number(end64 + 32, 8)};
}

/// Sizes and place that do not fit into 32 bits stand in the entry's extra field 1, in this order.
void read_zip64(const Archive& archive, std::string_view extra, Entry& entry) {
  while (extra.size() >= 4) {
    const std::uint64_t id = little_endian(extra, 0, 2), size = little_endian(extra, 2, 2);
    if (extra.size() - 4 < size) archive.damaged();
    std::string_view field = extra.substr(4, size);
    extra.remove_prefix(4 + size);
    if (id != 1) continue;
    for (std::uint64_t* value : {&entry.unpacked, &entry.packed, &entry.at}) {
      if (*value != kIn32) continue;
      if (field.size() < 8) archive.damaged();
      *value = little_endian(field, 0, 8);
      field.remove_prefix(8);
    }
  }
}

std::vector<Entry> read_directory(const Archive& archive) {
  const Directory directory = find_directory(archive);
  archive.text(directory.at, directory.size);
  if (directory.entries > directory.size / kEntrySize) archive.damaged();
  std::vector<Entry> entries;
  std::uint64_t at = directory.at;
  for (std::uint64_t k = 0; k < directory.entries; ++k) {
    if (archive.number(at, 4) != kEntrySign) archive.damaged();
    archive.text(at, kEntrySize);
    const std::uint64_t name = archive.number(at + 28, 2), extra = archive.number(at + 30, 2);
    Entry& entry = entries.emplace_back();
    entry.name = archive.text(at + kEntrySize, name);
    entry.flags = archive.number(at + 8, 2);
    entry.method = archive.number(at + 10, 2);
    entry.checksum = archive.number(at + 16, 4);
    entry.packed = archive.number(at + 20, 4);
    entry.unpacked = archive.number(at + 24, 4);
    entry.at = archive.number(at + 42, 4);
    read_zip64(archive, archive.text(at + kEntrySize + name, extra), entry);
    at += kEntrySize + name + extra + archive.number(at + 32, 2);
  }
  return entries;
}

std::string inflated(const Archive& archive, const Entry& entry, std::string_view packed) {
  if (entry.unpacked > kMostPacked * (entry.packed + 1)) {
    archive.fail(entry.name, "is damaged: it cannot unpack to the size that is said");
  }
  std::string bytes(entry.unpacked, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) archive.fail(entry.name, "cannot be unpacked");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.avail_out == 0 && stream.avail_in == 0;
  inflateEnd(&stream);
  if (!whole) archive.fail(entry.name, "is damaged: it does not unpack");
  return bytes;
}

std::uint64_t checksum_of(std::string_view bytes) {
  return crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()),
               static_cast<uInt>(bytes.size()));
}

ZipMember unpack(const Archive& archive, const Entry& entry) {
  if ((entry.flags & kEncrypted) != 0) archive.fail(entry.name, "is encrypted");
  if (entry.method != kStored && entry.method != kDeflated) {
    archive.fail(entry.name,
                 fmt::format("is packed by method {}; stored and deflated are read", entry.method));
  }
  if (archive.number(entry.at, 4) != kLocalSign) archive.damaged();
  const std::uint64_t name = archive.number(entry.at + 26, 2);
  const std::uint64_t extra = archive.number(entry.at + 28, 2);
  if (archive.text(entry.at + kLocalSize, name) != entry.name) archive.damaged();
  const std::string_view packed = archive.text(entry.at + kLocalSize + name + extra, entry.packed);
  if (entry.method == kStored && entry.packed != entry.unpacked) archive.damaged();
  ZipMember member{
      entry.name, entry.method == kStored ? std::string(packed) : inflated(archive, entry, packed)};
  if (checksum_of(member.bytes) != entry.checksum) {
    archive.fail(entry.name, "is damaged: its checksum is wrong");
  }
  return member;
}

/// What a local header and an entry of the directory both say, from the version that is needed on.
void append_facts(const ZipMember& member, std::string& out) {
  append_little_endian(20, 2, out);
  append_little_endian(kUtf8, 2, out);
  append_little_endian(kStored, 2, out);
  append_little_endian(0, 2, out);
  append_little_endian(kFirstOf1980, 2, out);
  append_little_endian(checksum_of(member.bytes), 4, out);
  append_little_endian(member.bytes.size(), 4, out);
  append_little_endian(member.bytes.size(), 4, out);
  append_little_endian(member.name.size(), 2, out);
  append_little_endian(0, 2, out);  // no extra field
}

}  // namespace

std::vector<ZipMember> unzip(std::string_view bytes, const std::string& file) {
  const Archive archive{bytes, file};
  const std::vector<Entry> entries = read_directory(archive);
  std::set<std::string_view> names;
  std::uint64_t total = 0;
  for (const Entry& entry : entries) {
    if (!names.insert(entry.name).second) archive.fail(entry.name, "stands twice");
    if (entry.unpacked > kMostBytes || (total += entry.unpacked) > kMostBytes) {
      archive.fail(entry.name, "unpacks to more than 1 GiB, with those before it");
    }
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

std::string zipped(const std::vector<ZipMember>& members, const std::string& file) {
  std::string out, directory;
  for (const ZipMember& member : members) {
    const std::size_t at = out.size();
    if (at + member.bytes.size() > kIn32 - kMostBytes || member.name.size() > kIn16) {
      throw InputError(fmt::format("{}: {}: is too large to be written", file, member.name));
    }
    append_little_endian(kLocalSign, 4, out);
    append_facts(member, out);
    out += member.name + member.bytes;
    append_little_endian(kEntrySign, 4, directory);
    append_little_endian(20, 2, directory);
    append_facts(member, directory);
    append_little_endian(0, 10, directory);  // no comment, disk 0, no attributes
    append_little_endian(at, 4, directory);
    directory += member.name;
  }
  if (members.size() >= kIn16) throw InputError(file + ": has too many members to be written");
  const std::size_t at = out.size();
  out += directory;
  append_little_endian(kEndSign, 4, out);
  append_little_endian(0, 4, out);
  append_little_endian(members.size(), 2, out);
  append_little_endian(members.size(), 2, out);
  append_little_endian(directory.size(), 4, out);
  append_little_endian(at, 4, out);
  append_little_endian(0, 2, out);
  return out;
}

}  // namespace morphe::files
