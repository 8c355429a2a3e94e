#include "mesh/render/render_mesh.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "base/error.h"
#include "mesh/render/palette.h"
#include "mesh/render/part_faces.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

/// Unit cubes from x = 0 on, six tets each, every cube a part; patches: the end at x = 0 is
/// "inlet", the rest "wall".
std::vector<NumberedPart> row_of_parts(int cubes) {
  std::vector<NumberedPart> parts;
  for (int cube = 0; cube < cubes; ++cube) {
    NumberedPart part;
    part.number = cube;
    part.region = 1 + cube % 2;
    for (int i = 0; i < 8; ++i) {
      part.nodes.push_back({cube + static_cast<double>(i / 4), static_cast<double>(i / 2 % 2),
                            static_cast<double>(i % 2)});
    }
    std::array<std::int32_t, 3> steps = {1, 2, 4};
    do {
      part.tets.push_back({0, steps[0], steps[0] + steps[1], 7});
    } while (std::next_permutation(steps.begin(), steps.end()));
    for (const ShownFace& face : outer_faces(part, std::vector<bool>(6, true))) {
      Vec3 sum;
      for (const std::int32_t v : face.nodes) sum += part.nodes[static_cast<std::size_t>(v)];
      const double x = sum.x / 3;
      const bool is_low = x == cube;
      const bool is_high = x == cube + 1;
      if ((is_low && cube > 0) || (is_high && cube + 1 < cubes)) continue;
      part.faces.push_back(face.nodes);
      part.patch_of_face.push_back(is_low ? 0 : 1);
    }
    parts.push_back(part);
  }
  return parts;
}

const std::vector<std::string> patches = {"inlet", "wall"};

Picture render(std::vector<NumberedPart> parts, const RenderOptions& options,
               const std::vector<std::string>& names = patches) {
  const auto visit_all = [&parts](const auto& visit) {
    for (NumberedPart& part : parts) visit(part);
  };
  return render_mesh(visit_all, names, options);
}

RenderOptions small(View view) {
  RenderOptions options;
  options.view = view;
  options.width = 200;
  options.height = 120;
  options.samples = 2;
  options.edge_width = 0;
  return options;
}

/// How many pixels have each palette colour's hue, whatever the light; -1 grey, -2 background.
std::map<int, int> pixels_by_colour(const Picture& picture) {
  std::map<int, int> count;
  for (std::size_t i = 0; i < picture.bytes.size(); i += 3) {
    const auto* p = &picture.bytes[i];
    if (p[0] == 255 && p[1] == 255 && p[2] == 255) {
      ++count[-2];
      continue;
    }
    int best = -1;
    double nearest = 1e9;
    for (int number = -1; number < 6; ++number) {
      const Colour c = number < 0 ? neutral_grey : palette_colour(number);
      const double scale = (p[0] + p[1] + p[2]) / (255.0 * (c.red + c.green + c.blue));
      const double distance = std::abs(p[0] - 255 * c.red * scale) +
                              std::abs(p[1] - 255 * c.green * scale) +
                              std::abs(p[2] - 255 * c.blue * scale);
      if (distance < nearest) best = number;
      nearest = std::min(nearest, distance);
    }
    ++count[best];
  }
  return count;
}

TEST(PartFaces, of_a_whole_cube_are_its_twelve_boundary_triangles) {
  const NumberedPart part = row_of_parts(1)[0];
  EXPECT_EQ(outer_faces(part, std::vector<bool>(6, true)).size(), 12U);
  EXPECT_EQ(outer_faces(part, std::vector<bool>(6, false)).size(), 0U);
  std::vector<bool> one(6, false);
  one[2] = true;
  const auto faces = outer_faces(part, one);
  EXPECT_EQ(faces.size(), 4U);
  EXPECT_EQ(std::ranges::count_if(faces, [](const ShownFace& f) { return f.patch >= 0; }), 2);
}

TEST(RenderMesh, shows_each_subdomain_in_its_colour) {
  const auto count = pixels_by_colour(render(row_of_parts(3), small(View::surface)));
  for (int part = 0; part < 3; ++part) EXPECT_GT(count.at(part), 500) << part;
  EXPECT_GT(count.at(-2), 1000);
  EXPECT_EQ(count.count(3), 0U);
}

TEST(RenderMesh, shows_regions_and_patches_in_their_colours) {
  RenderOptions options = small(View::surface);
  options.colour_by = ColourBy::region;
  auto count = pixels_by_colour(render(row_of_parts(3), options));
  EXPECT_GT(count.at(0), count.at(1));
  EXPECT_GT(count.at(1), 500);
  EXPECT_EQ(count.count(2), 0U);
  options.colour_by = ColourBy::patch;
  count = pixels_by_colour(render(row_of_parts(3), options));
  EXPECT_GT(count.at(0), 100);
  EXPECT_GT(count.at(1), 1000);
}

TEST(RenderMesh, cut_leaves_out_what_is_before_the_plane) {
  RenderOptions options = small(View::cut);
  options.camera.from = {-1, -0.1, 0.1};
  options.cut_normal = {1, 0, 0};
  options.cut_at = 1;
  const auto count = pixels_by_colour(render(row_of_parts(3), options));
  EXPECT_EQ(count.count(0), 0U) << "the part before the plane is gone";
  EXPECT_GT(count.at(1), 3000) << "the next one faces the eye";
  options.camera.from = {1, -0.1, 0.1};
  EXPECT_GT(pixels_by_colour(render(row_of_parts(3), options)).at(0), 3000)
      << "seen from the other side, the other part is left";
}

TEST(RenderMesh, exploded_moves_the_subdomains_apart) {
  RenderOptions options = small(View::exploded);
  options.camera.from = {0, -1, 0};
  options.explosion = 0;
  const auto background_columns = [&] {
    const Picture picture = render(row_of_parts(2), options);
    int columns = 0;
    for (int x = 20; x < 180; ++x) {
      const auto i = static_cast<std::size_t>(3 * (60 * picture.width + x));
      if (picture.bytes[i] == 255 && picture.bytes[i + 1] == 255) ++columns;
    }
    return columns;
  };
  EXPECT_EQ(background_columns(), 0);
  options.explosion = 1;
  EXPECT_GT(background_columns(), 30);
}

TEST(RenderMesh, shows_bodies_grey_and_whole_in_a_cut_and_hides_what_it_is_told_to) {
  RenderOptions options = small(View::cut);
  options.camera.from = {-1, -0.5, 0.3};
  options.cut_normal = {1, 0, 0};
  options.cut_at = 2;
  options.bodies = {"inlet"};
  auto count = pixels_by_colour(render(row_of_parts(3), options));
  EXPECT_GT(count[-1], 3000) << "the inlet lies before the plane";
  EXPECT_EQ(count.count(0), 0U);
  options.hidden = {"inlet"};
  count = pixels_by_colour(render(row_of_parts(3), options));
  EXPECT_LT(count[-1], 300) << "but for mixed pixels on outlines";
}

TEST(RenderMesh, shows_the_cells_that_a_plane_goes_through_in_a_slice) {
  RenderOptions options = small(View::slice);
  options.camera.from = {0, -1, 0};
  options.cut_normal = {0, 1, 0};
  options.cut_at = 0.4;
  const auto count = pixels_by_colour(render(row_of_parts(3), options));
  for (int part = 0; part < 3; ++part) EXPECT_GT(count.at(part), 1000) << part;
  options.cut_at = 1.5;
  EXPECT_THROW(render(row_of_parts(3), options), UsageError);
}

TEST(RenderMesh, colours_layers_by_turns) {
  RenderOptions options = small(View::slice);
  options.camera.from = {0, -1, 0};
  options.cut_at = 0.4;
  options.colour_by = ColourBy::layer;
  std::vector<NumberedPart> parts = row_of_parts(4);
  parts[0].marks[CellMark::layer].assign(6, 1);
  parts[1].marks[CellMark::layer].assign(6, 2);
  parts[2].marks[CellMark::pml_depth].assign(6, 1);
  const Picture picture = render(parts, options);
  const auto has = [&](const Colour& colour) {
    const auto level = [](float share) { return static_cast<int>(std::lround(255 * share)); };
    for (std::size_t i = 0; i + 2 < picture.bytes.size(); i += 3) {
      if (picture.bytes[i] == level(colour.red) && picture.bytes[i + 1] == level(colour.green) &&
          picture.bytes[i + 2] == level(colour.blue)) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(has(layer_colour(1, false)));
  EXPECT_TRUE(has(layer_colour(2, false)));
  EXPECT_TRUE(has(layer_colour(1, true)));
  EXPECT_TRUE(has(beyond_layers));
  EXPECT_FALSE(has(layer_colour(2, true)));
}

TEST(RenderMesh, takes_all_but_an_outer_boundary_for_bodies) {
  const auto count =
      pixels_by_colour(render(row_of_parts(3), small(View::surface), {"ship", "outer_box"}));
  EXPECT_GT(count.at(0), 1000) << "the inlet alone, and large";
  EXPECT_EQ(count.count(1), 0U);
}

TEST(RenderMesh, says_which_patches_there_are) {
  RenderOptions options = small(View::surface);
  options.hidden = {"outlet"};
  try {
    render(row_of_parts(1), options);
    FAIL() << "an unknown patch was taken";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("--hide: no patch \"outlet\"; the patches are inlet, wall"));
  }
}

TEST(RenderMesh, makes_the_same_picture_again) {
  RenderOptions options = small(View::exploded);
  options.edge_width = 1;
  EXPECT_EQ(render(row_of_parts(3), options).bytes, render(row_of_parts(3), options).bytes);
}

TEST(Palette, tells_neighbouring_numbers_apart) {
  for (int i = 0; i < 200; ++i) {
    const Colour a = palette_colour(i);
    const Colour b = palette_colour(i + 1);
    EXPECT_GT(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue),
              0.2F)
        << i;
  }
}

}  // namespace
}  // namespace tetfarm
