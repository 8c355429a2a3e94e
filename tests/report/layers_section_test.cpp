#include <gmock/gmock.h>

#include "report/report_page.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::Not;

ReportedLayers three_quarters() {
  ReportedLayers layers;
  layers.full = 300;
  layers.by_reason = {{"fold", 60}, {"no room", 40}};
  layers.by_layers = {10, 0, 90, 300};
  layers.first_heights.add(1);
  layers.shapes = {{"median <of> it", "0.875"}};
  layers.pictures = {{"The \"wall\"", "png"}};
  return layers;
}

TEST(LayersSection, tells_how_much_of_the_wall_has_all_layers_and_why_the_rest_has_not) {
  const std::string html = layers_section(three_quarters());
  EXPECT_THAT(html, HasSubstr("<h2>Boundary layers</h2>"));
  EXPECT_THAT(html, HasSubstr("<td>all layers</td><td>300</td><td>75.00 %</td>"));
  EXPECT_THAT(html, HasSubstr("<td>fewer: fold</td><td>60</td><td>15.00 %</td>"));
  EXPECT_THAT(html, HasSubstr("<td>fewer: no room</td><td>40</td><td>10.00 %</td>"));
  EXPECT_THAT(html, HasSubstr("median &lt;of&gt; it"));
  EXPECT_THAT(html, HasSubstr("0.875"));
}

TEST(LayersSection, has_charts_of_layers_and_of_first_heights_and_the_pictures) {
  const std::string html = layers_section(three_quarters());
  EXPECT_THAT(html, HasSubstr("2: 22.5"));
  EXPECT_THAT(html, HasSubstr("1.000: 100"));
  EXPECT_THAT(html, HasSubstr("<figcaption>The &quot;wall&quot;</figcaption>"));
}

TEST(LayersSection, is_not_there_without_a_wall) { EXPECT_EQ(layers_section({}), ""); }

TEST(LayersSection, stands_in_the_page_of_a_mesh_with_layers_alone) {
  ReportContent content;
  EXPECT_THAT(report_page(content), Not(HasSubstr("Boundary layers")));
  content.layers = three_quarters();
  EXPECT_THAT(report_page(content), HasSubstr("Boundary layers"));
}

}  // namespace
}  // namespace tetfarm
