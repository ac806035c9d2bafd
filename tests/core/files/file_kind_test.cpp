#include "core/files/file_kind.hpp"

#include <gmock/gmock.h>

namespace morphe::files {
namespace {

using namespace std::string_literals;

TEST(FileKind, OfXmlIsThatOfItsRootElement) {
  EXPECT_EQ(xml_root_name("<robot name='r'>"), "robot");
  EXPECT_EQ(xml_root_name(" \n<?xml version='1.0'?>\n<!-- <robot> -->\n<!DOCTYPE x>\n<Mujoco/>"),
            "mujoco");
  EXPECT_EQ(xml_root_name("<!-- <sdf> -->\n<!-- -- ><robot> --><robot>"), "robot");
  EXPECT_EQ(xml_root_name("<!doctype HTML><p>"), "html");
  EXPECT_EQ(xml_root_name("name: robot"), "");
  EXPECT_EQ(xml_root_name("<!-- not closed"), "");
  EXPECT_EQ(xml_root_name("<"), "");
  EXPECT_EQ(xml_root_name(""), "");
  EXPECT_EQ(file_kind("<!-- <robot> --><sdf version='1.9'/>")->name, "a model in SDF");
}

TEST(FileKind, TellsWhatStandsInThePlaceOfAnyFile) {
  for (const std::string& bytes :
       {""s, " \n"s, std::string(200, '\0'), "version https://git-lfs.github.com/spec/v1\n"s,
        "/annex/objects/MD5E-s1--0.stl"s, "\x1F\x8B\x08"s, "BZh9"s, "PK\3\4....a.urdf"s,
        "<!DOCTYPE html><html>"s, "\xFF\xFE\0\0x"s}) {
    ASSERT_TRUE(file_kind(bytes)) << bytes;
    EXPECT_TRUE(file_kind(bytes)->unwrapped) << bytes;
    EXPECT_FALSE(file_kind(bytes)->advice.empty()) << bytes;
  }
  for (const std::string& bytes : {"<robot/>"s, "PXR-USDC"s, "solid x facet"s, "%PDF-1.7"s})
    EXPECT_FALSE(file_kind(bytes)->unwrapped) << bytes;
}

}  // namespace
}  // namespace morphe::files
