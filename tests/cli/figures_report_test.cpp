#include "cli/figures_report.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TetFigures figures_of_tets(std::int64_t tets, double height, const Vec3& at) {
  TetFigures figures;
  figures.shapes.tets = tets;
  figures.shapes.smallest_height = height;
  figures.lowest_at = at;
  return figures;
}

/// Four tets in two sub-domains, one of them near a cut.
MeshFigures four_tets() {
  MeshFigures figures;
  figures.tets = 4;
  figures.all = figures_of_tets(4, 0.125, {1, 2.5, -3});
  figures.near_cuts = figures_of_tets(1, 0.125, {1, 2.5, -3});
  figures.away_from_cuts = figures_of_tets(3, 0.25, {4, 5, 6});
  figures.all.radius_ratio.counts[5] = 1;  // from 0.25
  figures.all.radius_ratio.counts[7] = 2;  // from 0.35
  figures.all.radius_ratio.counts[8] = 1;  // from 0.40
  figures.near_cuts.radius_ratio.counts[5] = 1;
  figures.volumes = {{-3, 1}, {-1, 3}};
  figures.edges.edges = 8;
  figures.edges.shortest = 0.5;
  figures.edges.longest = 3;
  figures.edges.sum = 10;
  figures.edges.over_spacing.counts[5] = 2;   // from 0.5
  figures.edges.over_spacing.counts[24] = 6;  // from 2.4, and all that is longer
  figures.subdomains = {{1, 4, 4, 0.1, 30}, {3, 6, 8, 0.3, 20}};
  figures.worst = {{12.3456, 150.5, 0.25, 0.01234567, {1.5, 2.5, 3.5}, 1, 17, true},
                   {0.001, 179.9, 0.5, 0.5, {0, 0, 0}, 0, 3, false}};
  return figures;
}

std::string bar(std::size_t length) { return std::string(length, '#') + "\n"; }

TEST(FiguresReport, for_people_has_the_time_step_histograms_the_balance_and_the_worst) {
  EXPECT_EQ(
      figures_text(four_tets()),
      "time step       0.125 / wave speed, limited by the height at (1, 2.5, -3)\n"
      "                2.000 times as many steps as the mesh away from the cuts would need\n"
      "radius ratio\n"
      "  0.25-0.30            25.0000 % " +
          bar(25) + "  0.30-0.35             0.0000 % " + bar(0) +
          "  0.35-0.40            50.0000 % " + bar(50) + "  0.40-0.45            25.0000 % " +
          bar(25) +
          "volume\n"
          "  from 0.125           25.0000 % " +
          bar(16) + "  from 0.25             0.0000 % " + bar(0) +
          "  from 0.5             75.0000 % " + bar(50) +
          "edge length over spacing: 0.500 to 3.000, mean 1.250\n"
          "  0.50-0.60            25.0000 % " +
          bar(16) +
          [] {
            std::string empty;
            for (int i = 6; i < 24; ++i) {
              const auto number = [](int tenths) {
                return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "0";
              };
              empty += "  " + number(i) + "-" + number(i + 1) + "             0.0000 % \n";
            }
            return empty;
          }() +
          "  from 2.40            75.0000 % " + bar(50) +
          "balance         1.500: elements of the largest sub-domain / mean\n"
          "worst tets\n"
          "MIN DEG  MAX DEG  RADIUS RATIO  HEIGHT   SUB-DOMAIN  NEAR A CUT  AT\n"
          "12.346   150.500  0.2500        0.01235  1           yes         (1.5, 2.5, 3.5)\n"
          "0.00100  179.900  0.5000        0.5      0           no          (0, 0, 0)\n");
}

TEST(FiguresReport, for_people_leaves_out_what_is_not_known) {
  MeshFigures figures = four_tets();
  figures.near_cuts = {};
  figures.edges = {};
  figures.worst.clear();
  figures.knows_subdomains = false;
  std::string text = figures_text(figures);
  for (const char* what : {"times as many", "edge length", "balance", "worst"}) {
    EXPECT_THAT(text, Not(HasSubstr(what)));
  }
  EXPECT_THAT(text, HasSubstr("time step"));
  figures.knows_subdomains = true;
  figures.subdomains.pop_back();
  EXPECT_THAT(figures_text(figures), Not(HasSubstr("balance"))) << "of a single sub-domain";
  figures.tets = 0;
  EXPECT_EQ(figures_text(figures), "");
}

TEST(FiguresReport, has_at_most_two_dozen_bins_of_volumes) {
  MeshFigures figures;
  figures.tets = 3;
  const auto lines_with = [&figures](int last) {
    figures.volumes = {{0, 1}, {1, 1}, {last, 1}};
    const std::string text = figures_text(figures);
    std::size_t count = 0;
    for (std::size_t at = text.find("  from "); at != std::string::npos;
         at = text.find("  from ", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(lines_with(23), 24U);
  EXPECT_EQ(lines_with(24), 13U) << "two powers of two each";
  EXPECT_THAT(figures_text(figures), HasSubstr("  from 1               66.6667 % " + bar(50)));
  EXPECT_THAT(figures_text(figures), HasSubstr("  from 1.68e+07        33.3333 % " + bar(25)));
}

TEST(FiguresReport, for_programs_has_every_figure) {
  nlohmann::ordered_json json = figures_json(four_tets());
  EXPECT_EQ(json["time_step"], 0.125);
  EXPECT_EQ(json["smallest_height_at"], nlohmann::ordered_json({1.0, 2.5, -3.0}));
  EXPECT_EQ(json["steps_beside_away_from_cuts"], 2);
  EXPECT_EQ(json["radius_ratio_histogram"]["from"], 0);
  EXPECT_EQ(json["radius_ratio_histogram"]["to"], 1);
  EXPECT_EQ(json["radius_ratio_histogram"]["counts"].size(), 20U);
  EXPECT_EQ(json["radius_ratio_histogram"]["counts"][7], 2);
  EXPECT_EQ(json["volume_histogram"],
            nlohmann::ordered_json({{"first_power_of_two", -3}, {"counts", {1, 0, 3}}}));
  json["edge_over_spacing"].erase("histogram");
  EXPECT_EQ(
      json["edge_over_spacing"],
      nlohmann::ordered_json({{"edges", 8}, {"shortest", 0.5}, {"longest", 3.0}, {"mean", 1.25}}));
  EXPECT_EQ(json["near_cuts_figures"]["smallest_height"], 0.125);
  EXPECT_EQ(json["near_cuts_figures"]["radius_ratio_histogram"]["counts"][5], 1);
  EXPECT_EQ(json["near_cuts_figures"]["radius_ratio_histogram"]["counts"][7], 0);
  EXPECT_EQ(json["away_from_cuts_figures"]["smallest_height"], 0.25);
  EXPECT_EQ(json["away_from_cuts_figures"]["smallest_height_at"],
            nlohmann::ordered_json({4.0, 5.0, 6.0}));
  EXPECT_EQ(json["largest_over_mean"], 1.5);
  EXPECT_EQ(json["subdomain_elements"], nlohmann::ordered_json({1, 3}));
  ASSERT_EQ(json["worst"].size(), 2U);
  EXPECT_EQ(json["worst"][0], nlohmann::ordered_json({{"min_dihedral_deg", 12.3456},
                                                      {"max_dihedral_deg", 150.5},
                                                      {"radius_ratio", 0.25},
                                                      {"height", 0.01234567},
                                                      {"at", {1.5, 2.5, 3.5}},
                                                      {"subdomain", 1},
                                                      {"tet", 17},
                                                      {"near_cut", true}}));
}

TEST(FiguresReport, for_programs_says_what_is_not_known) {
  MeshFigures figures = four_tets();
  figures.edges = {};
  figures.volumes.clear();
  figures.knows_subdomains = false;
  const nlohmann::ordered_json json = figures_json(figures);
  EXPECT_TRUE(json["edge_over_spacing"].is_null());
  EXPECT_EQ(json["volume_histogram"]["first_power_of_two"], 0);
  EXPECT_TRUE(json["volume_histogram"]["counts"].empty());
  EXPECT_TRUE(json["subdomain_elements"].empty());
}

}  // namespace
}  // namespace tetfarm
