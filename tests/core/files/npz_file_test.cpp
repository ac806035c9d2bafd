#include "core/files/npz_file.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/files/little_endian.hpp"
#include "core/files/zip_archive.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

std::string npy(const std::string& type, const std::string& shape, const std::string& values,
                const std::string& order = "False") {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  std::string bytes("\x93NUMPY\x01\x00", 8);
  append_little_endian(header.size(), 2, bytes);
  return bytes + header + values;
}

std::string bytes_of(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

NpyArray array_of(const std::string& bytes) { return read_npy(bytes, "a.npz", "key"); }

std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
std::string npy_error(const std::string& bytes) {
  return error_of([&] { array_of(bytes); });
}
std::string zip_error(const std::string& bytes) {
  return error_of([&] { unzip(bytes, "a.npz"); });
}

using Numbers = std::vector<double>;

TEST(Npy, NumbersOfEverySizeAndOrder) {
  EXPECT_EQ(array_of(npy("|b1", "(3,)", bytes_of({0, 1, 1}))).values, (Numbers{0, 1, 1}));
  EXPECT_EQ(array_of(npy("|i1", "(2,)", bytes_of({0x80, 0x7F}))).values, (Numbers{-128, 127}));
  EXPECT_EQ(array_of(npy("|u1", "(2,)", bytes_of({0x80, 0xFF}))).values, (Numbers{128, 255}));
  EXPECT_EQ(array_of(npy("<i2", "()", bytes_of({0xFE, 0xFF}))).values, (Numbers{-2}));
  EXPECT_EQ(array_of(npy(">i2", "()", bytes_of({0xFF, 0xFE}))).values, (Numbers{-2}));
  EXPECT_EQ(array_of(npy(">u4", "()", bytes_of({0x80, 0, 0, 1}))).values, (Numbers{2147483649.0}));
  EXPECT_EQ(array_of(npy("<i8", "(1,)", std::string(8, '\xFF'))).values, (Numbers{-1}));
  EXPECT_EQ(array_of(npy(">f4", "()", bytes_of({0xC0, 0x49, 0x0F, 0xDB}))).values,
            (Numbers{-static_cast<double>(3.14159274F)}));
  EXPECT_EQ(array_of(npy("<f8", "()", bytes_of({0, 0, 0, 0, 0, 0, 0xF8, 0x3F}))).values,
            (Numbers{1.5}));
}

TEST(Npy, HalfPrecision) {  // examples of IEEE 754's binary16
  const auto half = [](int low, int high) {
    return array_of(npy("<f2", "()", bytes_of({low, high}))).values[0];
  };
  EXPECT_EQ(half(0x00, 0x3C), 1);
  EXPECT_EQ(half(0x00, 0xC0), -2);
  EXPECT_EQ(half(0xFF, 0x7B), 65504);
  EXPECT_EQ(half(0x01, 0x00), std::ldexp(1, -24));
  EXPECT_EQ(half(0x00, 0xFC), -HUGE_VAL);
  EXPECT_TRUE(std::isnan(half(0x00, 0x7E)));
}

TEST(Npy, TextAndItsEncodings) {
  const std::string mug = bytes_of({'m', 0, 0, 0, 'u', 0, 0, 0, 'g', 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(array_of(npy("<U4", "()", mug)).text, (std::vector<std::string>{"mug"}));
  EXPECT_EQ(array_of(npy(">U1", "(2,)", bytes_of({0, 0, 0, 0xE9, 0, 1, 0xF6, 0}))).text,
            (std::vector<std::string>{"\xC3\xA9", "\xF0\x9F\x98\x80"}));
  EXPECT_EQ(array_of(npy("|S3", "(2,)", bytes_of({'a', 'b', 0, 0xE9, 0, 0}))).text,
            (std::vector<std::string>{"ab", "\xC3\xA9"}));
  EXPECT_NE(npy_error(npy("<U1", "()", bytes_of({0, 0xD8, 0, 0}))).find("invalid character"),
            std::string::npos);
}

TEST(Npy, FirstIndexFastestIsTurnedRound) {
  std::string values;
  for (int k = 0; k < 6; ++k) values += static_cast<char>(k);
  // numpy: np.asfortranarray([[0, 2, 4], [1, 3, 5]])
  EXPECT_EQ(array_of(npy("|u1", "(2, 3)", values, "True")).values, (Numbers{0, 2, 4, 1, 3, 5}));
  EXPECT_EQ(array_of(npy("|u1", "(2L, 3L)", values)).shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(array_of(npy("<f8", "(0, 20, 3)", "")).values.empty());
}

TEST(Npy, SaysWhatItDoesNotRead) {
  EXPECT_NE(npy_error(npy("|O", "(1,)", "\x80\x04.")).find("a.npz: key: contains Python objects"),
            std::string::npos);
  EXPECT_NE(npy_error(npy("<c16", "()", std::string(16, 0))).find("'<c16'"), std::string::npos);
  EXPECT_NE(npy_error(npy("<M8[ns]", "()", std::string(8, 0))).find("'<M8[ns]'"),
            std::string::npos);
  EXPECT_NE(npy_error(npy("<f8", "(2,)", std::string(15, 0))).find("ends too early"),
            std::string::npos);
  EXPECT_NE(npy_error(npy("<f8", "(4294967296, 4294967296)", "")).find("134 million"),
            std::string::npos);
  EXPECT_NE(npy_error(npy("<U0", "(999999999,)", "")).find("134 million"), std::string::npos);
  EXPECT_NE(npy_error(npy("<f8", "(-1,)", "")).find("header"), std::string::npos);
  EXPECT_NE(npy_error("PK").find("not a .npy"), std::string::npos);
}

/// As numpy's savez makes them: zip64's extra field in the local header, none in the directory.
std::string as_numpy_zips(const std::string& name, const std::string& bytes, bool deflated) {
  std::string packed = bytes;
  if (deflated) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    packed.resize(deflateBound(&stream, static_cast<uLong>(bytes.size())));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
  }
  std::string facts;
  append_little_endian(20, 2, facts);
  append_little_endian(0, 2, facts);
  append_little_endian(deflated ? 8 : 0, 2, facts);
  append_little_endian(0, 4, facts);
  append_little_endian(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())), 4,
      facts);
  append_little_endian(packed.size(), 4, facts);
  append_little_endian(bytes.size(), 4, facts);
  append_little_endian(name.size(), 2, facts);
  std::string zip = "PK\x03\x04" + facts;
  append_little_endian(20, 2, zip);
  zip += name + std::string("\x01\x00\x10\x00", 4);
  append_little_endian(bytes.size(), 8, zip);
  append_little_endian(packed.size(), 8, zip);
  zip += packed;
  const std::size_t directory = zip.size();
  zip += std::string("PK\x01\x02\x14\x03", 6) + facts + std::string(16, 0) + name;
  const std::size_t size = zip.size() - directory;
  zip += std::string("PK\x05\x06\0\0\0\0\x01\0\x01\0", 12);
  append_little_endian(size, 4, zip);
  append_little_endian(directory, 4, zip);
  return zip + std::string(2, 0);
}

TEST(Zip, StoredAndDeflatedMembersAsNumpyWritesThem) {
  const std::string bytes(3000, 'a');
  for (const bool deflated : {false, true}) {
    const auto members = unzip(as_numpy_zips("x.npy", bytes, deflated), "a.npz");
    ASSERT_EQ(members.size(), 1U);
    EXPECT_EQ(members[0].name, "x.npy");
    EXPECT_EQ(members[0].bytes, bytes);
  }
}

TEST(Zip, DirectoryOfZip64) {
  const std::string plain = as_numpy_zips("x.npy", "abc", false);
  const std::size_t end = plain.size() - 22;
  const std::string size = plain.substr(end + 12, 4), at = plain.substr(end + 16, 4);
  const std::string zeros(4, 0);
  std::string zip = plain.substr(0, end) + "PK\x06\x06";
  append_little_endian(44, 8, zip);
  append_little_endian(0, 12, zip);  // versions and disks
  append_little_endian(1, 8, zip);
  append_little_endian(1, 8, zip);
  zip += size + zeros + at + zeros + "PK\x06\x07" + zeros;
  append_little_endian(end, 8, zip);
  append_little_endian(1, 4, zip);
  zip += std::string("PK\x05\x06\0\0\0\0", 8) + std::string(12, '\xFF') + std::string(2, 0);
  EXPECT_EQ(unzip(zip, "a.npz").at(0).bytes, "abc");
}

TEST(Zip, DamageAndTricksAreRefused) {
  const std::string zip = as_numpy_zips("x.npy", "abcdef", false);
  std::string flipped = zip;
  flipped[flipped.find("abcdef")] = 'b';
  EXPECT_EQ(zip_error(flipped), "a.npz: x.npy: is damaged: its checksum is wrong");
  std::string locked = zip;
  locked[locked.find("PK\x01\x02") + 8] = 1;
  EXPECT_EQ(zip_error(locked), "a.npz: x.npy: is encrypted");
  const std::string twice = files::zip({{"x.npy", "a"}, {"x.npy", "b"}}, "a.npz");
  EXPECT_EQ(zip_error(twice), "a.npz: x.npy: appears twice");
  std::string bomb = as_numpy_zips("x.npy", std::string(100, 'a'), true);
  bomb.replace(bomb.find("PK\x01\x02") + 24, 4, std::string("\0\0\0\x20", 4));  // 512 MiB
  EXPECT_NE(zip_error(bomb).find("stated unpacked size is impossible"), std::string::npos);
  bomb.replace(bomb.find("PK\x01\x02") + 24, 4, std::string("\0\0\0\x70", 4));
  EXPECT_NE(zip_error(bomb).find("1 GiB"), std::string::npos);
  EXPECT_NE(zip_error("").find("not a complete zip archive"), std::string::npos);
}

std::filesystem::path temporary() { return std::filesystem::path(testing::TempDir()) / "a.npz"; }
std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<NpyArray> some_arrays() {
  return {{"fps", NpyKind::floating, {}, {59.94}},
          {"points", NpyKind::floating, {2, 3}, {0.1, -1e-300, 1e300, HUGE_VAL, -0.0, 7}},
          {"triangles", NpyKind::integer, {1, 3}, {0, -1, 9007199254740991.0}},
          {"names", NpyKind::text, {3}, {}, {"mug", "", "caf\xC3\xA9 \xF0\x9F\x98\x80"}},
          {"empty", NpyKind::text, {0}}};
}

TEST(Npz, WhatIsWrittenIsReadAgainBitForBit) {
  const auto file = temporary();
  write_npz(file, some_arrays());
  const std::string first = contents(file);
  const NpzFile read = read_npz(file);
  EXPECT_TRUE(is_npz(first));
  ASSERT_EQ(read.arrays.size(), some_arrays().size());
  for (const NpyArray& wanted : some_arrays()) {
    const NpyArray* const array = read.find(wanted.name);
    ASSERT_NE(array, nullptr) << wanted.name;
    EXPECT_EQ(array->kind, wanted.kind) << wanted.name;
    EXPECT_EQ(array->shape, wanted.shape) << wanted.name;
    EXPECT_EQ(array->values, wanted.values) << wanted.name;
    EXPECT_EQ(array->text, wanted.text) << wanted.name;
  }
  EXPECT_TRUE(std::signbit(read.find("points")->values[4]));
  write_npz(file, some_arrays());
  EXPECT_EQ(contents(file), first);
}

TEST(Npz, KeysAreToldWhateverTheArraysHold) {
  const auto file = temporary();
  std::ofstream(file, std::ios::binary)
      << files::zip({{"weights.npy", "no array at all"}, {"b.npy", ""}}, "a.npz");
  EXPECT_EQ(npz_keys(file), (std::vector<std::string>{"weights", "b"}));
  EXPECT_NE(error_of([&] { read_npz(file); }), "");
  const std::string whole = contents(file);
  std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() - 10);
  EXPECT_NE(error_of([&] { npz_keys(file); }), "");
}

TEST(Npz, DamageAnywhereIsAnErrorOrHarmless) {
  const auto file = temporary();
  write_npz(file, some_arrays());
  const std::string whole = contents(file);
  const auto reads = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return error_of([&] { read_npz(file); }).empty();
  };
  for (std::size_t length = 0; length < whole.size(); length += 29) {
    EXPECT_FALSE(reads(whole.substr(0, length))) << length;
  }
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 0xFF);
    reads(flipped);  // a date may be flipped without harm; nothing may crash
  }
}

}  // namespace
}  // namespace morphe::files
