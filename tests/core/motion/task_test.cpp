#include "core/motion/task.hpp"

#include <gtest/gtest.h>

#include "core/motion/revisit.hpp"

namespace morphe {
namespace {

TEST(Task, IsKnownByItsWordsInAnyForm) {
  for (const char* task : {"drink", "Drinking from a cup", "reach to grasp", "pick-and-place",
                           "pouring", "move a box", "she carried it", "put down", "lift the box"})
    EXPECT_EQ(kind_of_task(task), TaskKind::takes_object) << task;
  for (const char* task : {"reach forward", "reach_across", "COMB", "combing hair", "touching"})
    EXPECT_EQ(kind_of_task(task), TaskKind::touches) << task;
  for (const char* task : {"", "walk", "open a door", "rise, lift arm", "move your left hand",
                           "ADL007DR1", "computer", "placid", "putty"})
    EXPECT_EQ(kind_of_task(task), TaskKind::unknown) << task;
}

TEST(Task, ContainsWholeWords) {
  EXPECT_TRUE(contains_word("Drink, slowly", "drink"));
  EXPECT_TRUE(contains_word("stack and DRINK", "drink"));
  EXPECT_TRUE(contains_word("drinking a drink", "drink"));
  for (const char* task : {"", "drinking", "undrink", "dri nk"})
    EXPECT_FALSE(contains_word(task, "drink")) << task;
  EXPECT_FALSE(contains_word("drink", ""));
}

TEST(Revisit, IsOneAtTheSamePlaceAndZeroHalfwayOfTheShorterWay) {
  const Vec3 place(0.1, 0.2, 0.3);
  EXPECT_DOUBLE_EQ(revisit_score(place, place, 0.2, 0.5), 1);
  EXPECT_NEAR(revisit_score(place, place + Vec3(0, 0.1, 0), 0.2, 0.5), 0, 1e-12);
  EXPECT_NEAR(revisit_score(place, place + Vec3(0.1, 0, 0), 0.5, 0.2), 0, 1e-12);
  EXPECT_LT(revisit_score(place, place + Vec3(0, 0, 0.2), 0.2, 0.5), -2);
}

}  // namespace
}  // namespace morphe
