#include "pipeline/report/filmstrip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "pipeline/report/svg_chart.hpp"
#include "tests/pipeline/report/turning_plan.hpp"

namespace morphe::report {
namespace {

std::string film(Plan plan, const std::string& path = "turn/000") {
  return filmstrip(arm(), plan, path, make_plan_view(arm(), std::nullopt, plan));
}

int count(const std::string& text, const std::string& of) {
  int found = 0;
  for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++found;
  return found;
}

/// From end to end of each line of a colour, in the picture's order; y up.
std::vector<Vec2> lines_of(const std::string& svg, const std::string& colour) {
  const std::regex line(
      R"~(<line x1="([-\d.]+)" y1="([-\d.]+)" x2="([-\d.]+)" y2="([-\d.]+)" stroke="(#\w+)")~");
  std::vector<Vec2> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), line), end; at != end; ++at) {
    if ((*at)[5] != colour) continue;
    found.emplace_back(std::stod((*at)[3]) - std::stod((*at)[1]),
                       std::stod((*at)[2]) - std::stod((*at)[4]));
  }
  return found;
}

TEST(Filmstrip, ShowsTheArmInParallelProjectionAtOneScale) {
  const std::vector<Vec2> robot = lines_of(film(turning_plan()), std::string(Colours::kRobot));
  ASSERT_EQ(robot.size(), 10u);  // two capsules, five times
  const Vec3 near = Vec3(0.9, 0.75, 0.55).normalized();
  const Vec3 right = Vec3::UnitZ().cross(near).normalized(), up = near.cross(right);
  const auto seen_at = [&](double angle) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0);
    return Vec2(right.dot(along), up.dot(along));
  };
  const auto longest = [&](std::size_t pose) {
    const Vec2 &a = robot[2 * pose], &b = robot[2 * pose + 1];
    return a.norm() > b.norm() ? a : b;
  };
  const double scale = longest(0).norm() / seen_at(0).norm();
  EXPECT_LT((longest(0) - scale * seen_at(0)).norm(), 0.03);
  EXPECT_LT((longest(4) - scale * seen_at(kAngle)).norm(), 0.03);
  // Upper arm 0.15 m, forearm 0.2 m in a line with it.
  EXPECT_NEAR(std::min(robot[0].norm(), robot[1].norm()) / longest(0).norm(), 0.75, 1e-3);
}

TEST(Filmstrip, PutsAPanelAtTheGrasp) {
  const std::string svg = film(turning_plan());
  EXPECT_EQ(count(svg, "<clipPath"), 5);
  EXPECT_NE(svg.find(">1.00 s, grasp<"), std::string::npos);
  EXPECT_NE(svg.find(">0.00 s<"), std::string::npos);
  EXPECT_NE(svg.find(">2.00 s<"), std::string::npos);
}

TEST(Filmstrip, LeavesOutWhatWasNotSeen) {
  Plan plan = turning_plan();
  for (Vec3& tip : plan.goals.tip_position.values) tip = unknown_point();
  plan.goals.shoulder_position.assign(3, unknown_point());
  plan.scene.objects = {ball({0, 0.7, 0}, 0.1)};
  const std::string svg = film(plan);
  EXPECT_FALSE(std::regex_search(svg, std::regex("[\" ,]-?(nan|inf)")));
  EXPECT_TRUE(lines_of(svg, std::string(Colours::kPerson)).empty());
  EXPECT_EQ(count(svg, "<polygon"), 5);
}

TEST(Filmstrip, ShowsThePersonWhereNothingWasPlanned) {
  Plan plan = turning_plan();
  plan.trajectory = {};
  plan.reason = Reason::no_path;
  const std::string svg = film(plan);
  EXPECT_TRUE(lines_of(svg, std::string(Colours::kRobot)).empty());
  EXPECT_EQ(lines_of(svg, std::string(Colours::kPerson)).size(), 5u);  // upper arms alone
  EXPECT_NE(svg.find("infeasible (no_path)"), std::string::npos);
}

TEST(Filmstrip, NamesFromFilesAreText) {
  const std::string svg = film(turning_plan(), "<script>&\"\x01/000");
  EXPECT_NE(svg.find("&lt;script&gt;&amp;&quot;/000"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(Chart, PutsValuesAtTheirPlaceBetweenTicks) {
  Svg svg(200, 100, "");
  draw_chart(svg, {0, 0}, {200, 100}, "", {{"a", {0, 1, 2}, {0, 10, 5}, "#123456", ""}}, {});
  const std::string text = svg.to_string();
  std::smatch path;
  const std::regex pattern(
      R"~(<path d="M([\d.]+) ([\d.]+) L([\d.]+) ([\d.]+) L([\d.]+) ([\d.]+) ")~");
  ASSERT_TRUE(std::regex_search(text, path, pattern));
  const auto number = [&](std::size_t k) { return std::stod(path[k]); };
  EXPECT_NEAR(number(3), (number(1) + number(5)) / 2, 0.011);
  EXPECT_NEAR(number(2) - number(6), (number(2) - number(4)) / 2, 0.011);
  EXPECT_NE(text.find(">10<"), std::string::npos);  // a tick at a round number
}

}  // namespace
}  // namespace morphe::report
