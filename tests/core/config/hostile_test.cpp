// YAML that is small and makes much work, or says two things.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/config/node.hpp"

namespace morphe::config {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing::StrEq;
using testing::ThrowsMessage;

std::string refused(const std::string& text) {
  try {
    ConfigNode::parse(text, "a.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HostileYaml, AnAliasOfItself) {
  EXPECT_THAT(refused("a: &a [*a]\n"),
              HasSubstr("nested deeper than 100 levels, or contains itself"));
  EXPECT_THAT(refused("a: &a {b: *a}\n"), HasSubstr("contains itself"));
  ConfigNode node = ConfigNode::parse("b: 1\n", "a.yaml");
  EXPECT_THAT(
      [&] { node.set("b", "&a [*a]"); },
      ThrowsMessage<InputError>(AllOf(StartsWith("--set b:1: "), HasSubstr("contains itself"))));
}

TEST(HostileYaml, AliasesThatMakeMuchOfLittle) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i) {
    text += fmt::format("a{0}: &a{0} [", i);
    for (int k = 0; k < 10; ++k) text += fmt::format("{}*a{}", k == 0 ? "" : ", ", i - 1);
    text += "]\n";
  }
  EXPECT_THAT(refused(text), HasSubstr("has more than 1000000 values"));
}

TEST(HostileYaml, TwoHundredThousandKeysTakeNoLongerThanTheirLength) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += fmt::format("key_{}: 1\n", i);
  const ConfigNode node = ConfigNode::parse(text, "a.yaml");
  double sum = 0;
  for (const std::string& key : node.keys()) sum += node[key].number();
  EXPECT_EQ(sum, 200'000);
  EXPECT_THAT([&] { ConfigNode::parse(text, "a.yaml").require_all_keys_read(); },
              ThrowsMessage<InputError>(AllOf(StartsWith("a.yaml:1: key_0: unknown key\n"),
                                              EndsWith("\n… and 980 more"))));
}

TEST(HostileYaml, NestingWithoutEnd) {
  EXPECT_NE(refused("a: " + std::string(100'000, '[')), "");
  EXPECT_NE(refused("a: " + std::string(100'000, '{')), "");
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_NE(refused(deep + std::string(2000, ' ') + "b"), "");
  std::string path = "a";
  for (int i = 0; i < 10'000; ++i) path += ".a";
  ConfigNode node = ConfigNode::parse("b: 1\n", "a.yaml");
  EXPECT_THAT([&] { node.set(path, "1"); },
              ThrowsMessage<InputError>(StrEq("--set: names more than 100 levels")));
}

TEST(HostileYaml, ASecondDocumentIsNotIgnored) {
  EXPECT_EQ(refused("a: 1\n---\nb: 2\n"),
            "a.yaml:3: a second YAML document begins; only one is allowed");
  EXPECT_EQ(refused("---\na: 1\n...\n"), "");
  EXPECT_EQ(refused("a: 1\n---\n# nothing\n"), "");
  EXPECT_NE(refused("---\n---\na: 1\n"), "");
}

/// A brace that nothing opened was a document of its own, again and again.
TEST(HostileYaml, ABraceThatNothingOpenedIsNoEndlessRowOfDocuments) {
  for (const char* text : {"a: 1\n}\n", "}", "]", "a: b}\n}", "x: y\n  z: a: &a {b: 1}\n, c"})
    refused(text);
}

TEST(HostileYaml, ControlCharactersOfKeysAreSpelled) {
  EXPECT_THAT(refused("\"a\\e[31m\": 1\n\"a\\e[31m\": 2\n"),
              HasSubstr("a\\u001b[31m: the key appears twice"));
  const ConfigNode node = ConfigNode::parse("\"x\\ny\": [1]\n", "a.yaml");
  try {
    node["x\ny"].number();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("a.yaml:1: x\\u000ay: "));
  }
}

}  // namespace
}  // namespace morphe::config
