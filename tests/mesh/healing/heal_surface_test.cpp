#include "mesh/healing/heal_surface.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <limits>
#include <random>

#include "base/error.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/mesh/healing/damaged_surface.h"
#include "tests/support/cad_families.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

HealedSurface healed(const SurfaceMesh& surface) { return heal_surface(surface, {}, {}); }

TEST(HealSurface, leaves_a_sound_one_as_it_is) {
  const SurfaceMesh part = shapes::perforated_plate(1, 1);
  const HealedSurface same = healed(part);
  EXPECT_EQ(same.surface.vertices, part.vertices);
  EXPECT_EQ(same.surface.triangles, part.triangles);
  EXPECT_THAT(same.acts, IsEmpty());
}

TEST(HealSurface, mends_several_kinds_of_damage_to_parts_and_keeps_their_volume) {
  using Family = std::function<SurfaceMesh(std::uint64_t, int)>;
  const std::vector<Family> families = {shapes::capped_cylinder, shapes::perforated_plate,
                                        shapes::gear, shapes::rounded_block, shapes::filleted_bar};
  std::mt19937 random(7);
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(std::to_string(f) + " with seed " + std::to_string(seed));
      SurfaceMesh part = families[f](seed, 1);
      const double volume = check_surface(part).report.volume;
      const double diagonal = norm(bounding_box(part.vertices).size());
      const std::size_t count = part.triangles.size();
      for (int i = 0; i < 6; ++i) {
        const std::size_t t = random() % count;
        switch (random() % 4) {
          case 0:
            test::tear(part, t, {1e-8 * diagonal, 0, 0});
            break;
          case 1:
            test::add_copy(part, t, part.triangles[t]);
            break;
          case 2:
            test::divide_one_side(part, t);
            break;
          default:
            test::add_flat_triangle(part, t);
        }
      }
      ASSERT_FALSE(check_surface(part).report.defects.empty());
      const HealedSurface mended = healed(part);
      EXPECT_THAT(mended.checked.report.defects, IsEmpty());
      EXPECT_NEAR(mended.checked.report.volume, volume, 1e-6 * volume);
      EXPECT_FALSE(mended.acts.empty());
      EXPECT_EQ(healed(part).surface.triangles, mended.surface.triangles) << "each time";
    }
  }
}

/// A box with a cap of this height on one face: sound.
SurfaceMesh box_with_cap(double height) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  const Vec3 apex = vertex_at(box, box.triangles[5][2]);
  test::add_flat_triangle(box, 5);
  Vec3& tip = box.vertices.back();
  tip = tip + height * normalized(apex - tip);
  return box;
}

TEST(HealSurface, removes_what_is_nearly_flat_of_a_sound_one) {
  const SurfaceMesh sound = box_with_cap(1e-9);
  ASSERT_THAT(check_surface(sound).report.defects, IsEmpty());
  const HealedSurface better = healed(sound);
  EXPECT_THAT(heal_texts(better.acts), SizeIs(1));
  EXPECT_THAT(heal_texts(better.acts).front(), HasSubstr("1 nearly flat triangle removed"));
  EXPECT_THAT(better.checked.report.defects, IsEmpty());
  EXPECT_NE(better.surface.triangles, sound.triangles);
}

TEST(HealSurface, leaves_triangles_that_are_higher_than_the_tolerance) {
  HealOptions options;
  options.tolerance = 1e-10;
  EXPECT_THAT(heal_surface(box_with_cap(1e-9), {}, options).acts, IsEmpty());
}

TEST(HealSurface, says_what_it_cannot_mend) {
  // Through each other, and one of them open: what is inside is anybody's guess.
  SurfaceMesh two = test::with_body(shapes::box({0, 0, 0}, {1, 1, 1}, 1),
                                    shapes::box({0.5, 0.4, 0.3}, {2, 0.9, 0.8}, 1));
  std::erase_if(two.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](std::int32_t v) { return vertex_at(two, v).x == 0; });
  });
  two.patch_of_triangle.clear();
  const HealedSurface left = heal_surface(two, {}, {0, 0.1});
  ASSERT_THAT(left.checked.report.defects, SizeIs(2));
  EXPECT_EQ(left.checked.report.defects[0].kind, "open edge");
  EXPECT_EQ(left.checked.report.defects[1].kind, "self-intersection");
  EXPECT_THAT(left.acts, IsEmpty());
  EXPECT_EQ(left.surface.triangles, two.triangles);
}

TEST(HealSurface, unites_bodies_once_they_are_closed) {
  SurfaceMesh two = test::with_body(shapes::box({0, 0, 0}, {1, 1, 1}, 2),
                                    shapes::box({0.5, 0.4, 0.3}, {2, 0.9, 0.8}, 1));
  test::remove_triangle(two, 0);
  const HealedSurface united = heal_surface(two, {}, {0, 5});
  EXPECT_THAT(united.checked.report.defects, IsEmpty());
  EXPECT_NEAR(united.checked.report.volume, 1.25, 1e-12);
}

TEST(HealSurface, does_not_touch_what_makes_no_sense) {
  SurfaceMesh box = shapes::unit_cube();
  box.vertices[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(healed(box).checked.report.defects.at(0).kind, "bad coordinate");
  SurfaceMesh wild = shapes::unit_cube();
  wild.triangles[2][1] = 1000;
  EXPECT_EQ(healed(wild).checked.report.defects.at(0).kind, "bad vertex number");
  EXPECT_THAT(healed(wild).acts, IsEmpty());
}

TEST(HealSurface, wants_lengths_that_are_lengths) {
  HealOptions options;
  options.tolerance = -1;
  EXPECT_THROW(heal_surface(shapes::unit_cube(), {}, options), UsageError);
  options.tolerance = 0;
  options.largest_hole = std::numeric_limits<double>::infinity();
  EXPECT_THROW(heal_surface(shapes::unit_cube(), {}, options), UsageError);
}

TEST(HealSurface, mends_real_parts_as_their_program_wrote_them) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  for (const char* name : {"printer_einsy_base", "printer_extruder_body", "printer_psu_cover_mk3",
                           "printer_raspberry_cover", "printer_x_carriage"}) {
    SCOPED_TRACE(name);
    const SurfaceMesh part = read_surface(std::string(data) + "/broken/" + name + ".stl");
    ASSERT_FALSE(check_surface(part).report.defects.empty());
    const HealedSurface mended = healed(part);
    EXPECT_THAT(mended.checked.report.defects, IsEmpty());
    EXPECT_GT(mended.checked.report.volume, 0);
    EXPECT_FALSE(mended.acts.empty());
  }
}

TEST(HealTexts, have_a_line_for_each_kind_with_the_first_places) {
  std::vector<HealAct> acts;
  for (int i = 0; i < 5; ++i) {
    acts.push_back({HealKind::joined, {static_cast<double>(i), 0, 0}, {}});
  }
  acts.push_back({HealKind::hole, {7, 8, 9}, {}});
  EXPECT_THAT(heal_texts(acts),
              ::testing::ElementsAre(
                  "5 vertices joined with others: (0, 0, 0); (1, 0, 0); (2, 0, 0); and 2 more",
                  "1 hole filled: (7, 8, 9)"));
  EXPECT_THAT(heal_texts({}), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
