#include "core/collision/stl_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace morphe::collision {
namespace {

using testing::HasSubstr;

class StlFile : public testing::Test {
 protected:
  std::string read(const std::string& bytes) {
    const auto file = std::filesystem::path(testing::TempDir()) / "morphe_stl_file.stl";
    std::ofstream(file, std::ios::binary) << bytes;
    mesh = {};
    return read_stl(file, mesh);
  }
  SceneObject mesh;
};

/// A header, the number of facets that it claims, and those that are there: (k, 1, 2), …
std::string binary(std::uint32_t claimed, int there) {
  std::string bytes("solid as some programs begin a binary");
  bytes.resize(80);
  bytes.append(reinterpret_cast<const char*>(&claimed), sizeof claimed);
  for (int k = 0; k < there; ++k) {
    const float values[12] = {0, 0, 1, static_cast<float>(k), 1, 2, 3, -0.0f, 5, 6, 7, 8.5};
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST_F(StlFile, TextAndBinary) {
  EXPECT_EQ(
      read("solid a vertex in a name\nfacet normal 0 0 1\n outer loop\n  vertex 0 1 2\n"
           "  vertex 3 -0.0 5\r\n  vertex +6 7e0 8.5\n endloop\nendfacet\nendsolid a vertex\n"),
      "");
  const SceneObject text = mesh;
  EXPECT_EQ(read(binary(1, 1)), "");
  for (const SceneObject& one : {text, mesh}) {
    ASSERT_EQ(one.vertices.size(), 3u);
    EXPECT_EQ(one.vertices[0], Vec3(0, 1, 2));
    EXPECT_EQ(one.vertices[1], Vec3(3, 0, 5));
    EXPECT_FALSE(std::signbit(one.vertices[1].y()));
    EXPECT_EQ(one.vertices[2], Vec3(6, 7, 8.5));
    EXPECT_EQ(one.triangles, std::vector<Eigen::Vector3i>{Eigen::Vector3i(0, 1, 2)});
  }
}

TEST_F(StlFile, TextMayBeginWithBlanksOrAMarkAndHasAnyCase) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 1 2\nvertex 3 0 5\nVERTEX 6 7 x\n";
  for (const std::string start :
       {"\n\t solid", "\xEF\xBB\xBFsolid", "SOLID", "\xEF\xBB\xBF\nSolid"}) {
    const std::string text = start + " a vertex in a name\n" + facet;
    ASSERT_GT(text.size(), 84u);  // as long as a binary file at least
    const long line = std::count(start.begin(), start.end(), '\n') + 6;
    EXPECT_EQ(read(text), fmt::format("line {}: 'vertex' must be followed by 3 numbers", line));
    std::string valid = text;
    valid[valid.rfind('x')] = '8';
    EXPECT_EQ(read(valid + "endloop\nENDFACET\nEndSolid a vertex\n"), "");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[2], Vec3(6, 7, 8));
  }
}

TEST_F(StlFile, WhatIsCutOrClaimsMoreIsRefused) {
  std::string cut = binary(2, 1);
  EXPECT_EQ(read(cut), "the header states 2 facets, but the file has only 1");
  cut[0] = 'x';
  EXPECT_EQ(read(cut), "the header states 2 facets, but the file has only 1");
  std::string huge = binary(0xffffffff, 1);
  huge[0] = 'x';
  EXPECT_EQ(read(huge), "the header states 4294967295 facets, but the file has only 1");
  EXPECT_EQ(read("solid\nvertex 1 2 3\nvertex 1 2\n"),
            "line 3: 'vertex' must be followed by 3 numbers");
  EXPECT_EQ(read("solid\nvertex 1 2 3\nvertex 1 2 x\n"),
            "line 3: 'vertex' must be followed by 3 numbers");
  EXPECT_EQ(read("solid\nvertex 1 2 3\nendfacet\n"),
            "line 3: the facet that ends here has 1 vertex, not 3");
  const std::string two = "vertex 1 2 3\nvertex 1 2 3\n";
  EXPECT_EQ(read("solid\n" + two + two + two + "endfacet\n"),
            "line 8: the facet that ends here has 6 vertices, not 3");
  EXPECT_EQ(read("solid\nvertex 1 2 3\n"), "the file ends within a facet");
  for (const std::size_t size : {4, 50, 83}) {
    EXPECT_EQ(
        read(binary(1, 1).substr(0, size)),
        fmt::format("the header of a binary STL has 84 bytes, but the file has only {}", size));
  }
  EXPECT_EQ(read(""), "");  // nothing: a mesh without triangles is for others to refuse
  EXPECT_TRUE(mesh.triangles.empty());
}

}  // namespace
}  // namespace morphe::collision
