#include "core/config/renamed_keys.hpp"

#include <gtest/gtest.h>

#include "core/config/fields.hpp"
#include "core/config/spelling_hint.hpp"

namespace morphe::config {
namespace {

enum class Mode { human, catch_up };
constexpr std::array<std::string_view, 2> names_of(Mode) { return {"human", "catch_up"}; }

struct RenamedOptions {
  double required_clearance = 0;
  double position = 0;
  Mode mode = Mode::human;
};
template <class Fields>
void fields(Fields& f, RenamedOptions& o) {
  f("required_clearance", o.required_clearance, bounds::kLength);
  f.required("position", o.position, bounds::kLength);
  f("mode", o.mode);
}

std::string read_error(const std::string& text) {
  RenamedOptions options;
  try {
    read_document(ConfigNode::parse(text, "o.yaml"), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RenamedKeys, KnowsWhatAnOldNameIsCalledNow) {
  EXPECT_EQ(current_name("farthest_tip", {"engine", "max_tip_error"}), "max_tip_error");
  EXPECT_EQ(current_name("farthest_tip", {"engine"}), "") << "no key here is called so now";
  EXPECT_EQ(current_name("max_tip_error", {"engine", "max_tip_error"}), "");
  EXPECT_EQ(current_name("farthest", {"max_tip_error"}), "") << "old names are taken as they are";
  EXPECT_EQ(current_name("", {""}), "");
}

TEST(RenamedKeys, TellsKeysOfOneOldNameApartByWhereItStands) {
  EXPECT_EQ(current_name("at", {"scale", "factor", "align"}), "align");
  EXPECT_EQ(current_name("at", {"joint", "position"}), "position");
}

TEST(RenamedKeys, KnowsTheOldNameOfAKey) {
  EXPECT_EQ(former_name("max_iterations", {"attempts", "iterations"}), "iterations");
  EXPECT_EQ(former_name("max_iterations", {"attempts"}), "");
  EXPECT_EQ(former_name("max_penetration", {"penetration"}), "penetration");
  EXPECT_EQ(former_name("max_penetration", {"contact_depth"}), "contact_depth");
}

TEST(RenamedKeys, ComesBeforeWordsThatAreSpelledAlike) {
  EXPECT_EQ(spelling_hint("iterations", {"iteration", "max_iterations"}),
            "; it is now called 'max_iterations'");
  EXPECT_EQ(spelling_hint("iterations", {"iteration"}), "; did you mean 'iteration'?");
}

TEST(RenamedKeys, HaveOptionsAmongThem) {
  EXPECT_EQ(spelling_hint("--static", {"--strict", "--static-trial"}),
            "; it is now called '--static-trial'");
  EXPECT_EQ(current_name("--torque", {"torque_limit"}), "") << "options are no keys";
}

TEST(RenamedKeys, AreRefusedWithTheNewName) {
  EXPECT_EQ(read_error("margin: 0.001\nposition: 1\n"),
            "o.yaml:1: margin: unknown key; it is now called 'required_clearance'");
  EXPECT_EQ(read_error("at: 1\n"),
            "o.yaml:1: position: is missing; 'at' is now called 'position'\n"
            "o.yaml:1: at: unknown key; it is now called 'position'");
}

TEST(RenamedKeys, HaveValuesAmongThem) {
  EXPECT_EQ(read_error("position: 1\nmode: kept\n"),
            "o.yaml:2: mode: must be human or catch_up, not 'kept'; it is now called 'catch_up'");
  EXPECT_EQ(read_error("position: 1\nmode: closed\n"),
            "o.yaml:2: mode: must be human or catch_up, not 'closed'");
}

}  // namespace
}  // namespace morphe::config
