// What is wrong with a job's spacing, or with a file of it, word by word.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/error.h"
#include "mesh/spacing/octree_build.h"
#include "mesh/spacing/octree_refine.h"
#include "mesh/spacing/sources.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

std::string refusal_of_sources(const std::vector<SourceCorner>& corners, std::size_t before = 0) {
  std::vector<Source> sources(before, Source{{{{}, 1, 1, 2}}});
  sources.push_back({corners});
  return refusal([&] { check_sources(sources); });
}

TEST(SpacingRefusals, of_sources_name_the_source_and_what_is_wrong) {
  const SourceCorner good{{0, 0, 0}, 1, 1, 2};
  EXPECT_EQ(refusal_of_sources({good}), "none");
  EXPECT_EQ(refusal_of_sources({good, good, good}), "none");
  EXPECT_EQ(refusal_of_sources({}), "source 1: a source must have 1, 2 or 3 corners, not 0");
  EXPECT_EQ(refusal_of_sources({good, good, good, good}, 2),
            "source 3: a source must have 1, 2 or 3 corners, not 4");
  EXPECT_EQ(refusal_of_sources({good, {{0, NAN, 0}, 1, 1, 2}}),
            "source 1: the position is not finite");
  EXPECT_EQ(refusal_of_sources({{{HUGE_VAL, 0, 0}, 1, 1, 2}}),
            "source 1: the position is not finite");
  for (const double bad : {0.0, -1.0, static_cast<double>(NAN), HUGE_VAL}) {
    EXPECT_EQ(refusal_of_sources({{{}, bad, 1, 2}}, 1), "source 2: the spacing is not positive")
        << bad;
    EXPECT_EQ(refusal_of_sources({{{}, 1, bad, 2}}), "source 1: a radius is not positive") << bad;
    EXPECT_EQ(refusal_of_sources({{{}, 1, 1, bad}}), "source 1: a radius is not positive") << bad;
  }
  EXPECT_EQ(refusal_of_sources({{{}, 1, 2, 1.999}}),
            "source 1: the outer radius is smaller than the inner radius");
  EXPECT_EQ(refusal_of_sources({{{}, 1, 2, 2}}), "none") << "as large is no smaller";
}

TEST(SpacingRefusals, of_options_and_surfaces_say_what_is_wrong) {
  const SurfaceMesh cube = shapes::unit_cube();
  const auto with = [&cube](double growth, double background) {
    SpacingOptions options;
    options.growth = growth;
    options.background = background;
    return refusal([&] { make_spacing_field(cube, options); });
  };
  EXPECT_EQ(with(0.3, 0), "none");
  EXPECT_EQ(with(0, 0.5), "spacing: the growth is not positive");
  EXPECT_EQ(with(-1, 0.5), "spacing: the growth is not positive");
  EXPECT_EQ(with(HUGE_VAL, 0.5), "spacing: the growth is not positive");
  EXPECT_EQ(with(0.3, -1), "spacing: the background spacing is negative");
  EXPECT_EQ(with(0.3, NAN), "spacing: the background spacing is negative");
  EXPECT_EQ(with(0.3, HUGE_VAL), "spacing: the background spacing is negative");
  EXPECT_EQ(refusal([] { make_spacing_field({}, {}); }),
            "surface: the surface has no finite extent");
  SurfaceMesh point = cube;
  for (Vec3& p : point.vertices) p = {1, 1, 1};
  EXPECT_EQ(refusal([&] { make_spacing_field(point, {}); }),
            "surface: the surface has no finite extent");
  SurfaceMesh far = cube;
  for (Vec3& p : far.vertices) p.x += 4e12;
  EXPECT_EQ(refusal([&] { make_spacing_field(far, {}); }),
            "surface: the domain is too far from the origin for its size");
  const Box3 box{{0, 0, 0}, {1, 1, 1}};
  SpacingDemand crowd{DemandTree({}, 0.5), {}, 1, 0.5, 1};
  for (int i = 0; i < 8; ++i) {
    crowd.sources.push_back(source_demand({{{{0.5, 0.5, 0.5}, 0.03, 0.2, 0.4}}}, 0.5));
  }
  EXPECT_EQ(refusal([&] { refine(crowd, grid_frame(box, 1), box, 1000); }),
            "spacing: too many sources or edges ask for a small spacing at one place");
}

TEST(SpacingRefusals, of_bytes_say_what_is_wrong_with_them) {
  const std::string bytes = make_spacing_field(shapes::unit_cube(), {}).to_bytes();
  const auto read = [](const std::string& text) {
    return refusal([&text] { SpacingField::from_bytes(text, "the file"); });
  };
  EXPECT_EQ(read(bytes), "none");
  EXPECT_EQ(read(""), "the file: is too short for a spacing field");
  EXPECT_EQ(read(bytes.substr(0, 50)), "the file: is too short for a spacing field");
  std::string other = bytes;
  other[0] ^= 1;
  EXPECT_EQ(read(other), "the file: is not a spacing field");
  other = bytes;
  other.back() ^= 1;
  EXPECT_EQ(read(other), "the file: the spacing field has a wrong checksum");
  EXPECT_EQ(read(bytes + std::string(4, '\0')), "the file: the spacing field has a wrong checksum");
}

TEST(SpacingRefusals, of_octrees_name_the_first_invariant_that_does_not_hold) {
  SpacingDemand demand{DemandTree({{{0.5, 0.5, 0.5}, 0.05, 0}}, 0.5), {}, 0.5, 0.5, 0.5};
  const Box3 box{{0, 0, 0}, {1, 1, 1}};
  const SpacingOctree sound = build_octree(demand, grid_frame(box, 0.5), box);
  const auto fault = [&sound](void (*break_it)(SpacingOctree&)) -> std::string {
    SpacingOctree octree = sound;
    break_it(octree);
    const char* found = validate(octree);
    return found == nullptr ? "none" : found;
  };
  EXPECT_EQ(fault([](SpacingOctree&) {}), "none");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.child_of.resize(0); }), "no node");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.values.resize(o.values.size() - 1); }), "lengths");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.owned_corners.push_back(0); }), "lengths");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.frame.unit = 0; }), "unit");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.frame.unit = HUGE_VAL; }), "unit");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.frame.low[2] = GridFrame::farthest + 1; }),
            "low corner");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.frame.low[0] = -GridFrame::farthest - 1; }),
            "low corner");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.frame.low[1] = GridFrame::farthest; }), "none");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.child_of.push_back(~0); }), "tree");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.values[5][3] = 0; }), "value");
  EXPECT_EQ(fault([](SpacingOctree& o) { o.values[o.values.size() - 1][7] = HUGE_VALF; }), "value");
}

}  // namespace
}  // namespace tetfarm
