#include "cli/figures_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/angle_text.h"
#include "base/check.h"
#include "cli/place_text.h"
#include "cli/text_table.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int bar_width = 50;

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[240];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

struct Bin {
  std::string name;
  std::int64_t count = 0;
};

std::string bars_text(const std::string& title, const std::vector<Bin>& bins) {
  std::int64_t largest = 1;
  std::int64_t sum = 0;
  for (const Bin& bin : bins) {
    largest = std::max(largest, bin.count);
    sum += bin.count;
  }
  std::string text = title + "\n";
  for (const Bin& bin : bins) {
    const auto length = static_cast<std::size_t>(bin.count * bar_width / largest);
    text += format("  %-19s %8.4f %% ", bin.name.c_str(),
                   100 * static_cast<double>(bin.count) / static_cast<double>(sum)) +
            std::string(length, '#') + "\n";
  }
  return text;
}

/// Without the empty bins at both ends. In an open histogram the last bin has all that is larger.
std::vector<Bin> bins_of(const Histogram& histogram, bool is_open) {
  std::vector<Bin> bins;
  TF_CHECK(!histogram.counts.empty());
  const std::size_t last = histogram.counts.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool has_end = !is_open || i < last;
    bins.push_back({has_end ? format("%.2f-%.2f", histogram.end_of(i), histogram.end_of(i + 1))
                            : format("from %.2f", histogram.end_of(i)),
                    histogram.counts[i]});
  }
  while (!bins.empty() && bins.back().count == 0) bins.pop_back();
  const auto first =
      std::find_if(bins.begin(), bins.end(), [](const Bin& bin) { return bin.count > 0; });
  bins.erase(bins.begin(), first);
  return bins;
}

/// Bins of `powers` powers of two each.
std::vector<Bin> bins_of(const std::map<int, std::int64_t>& volumes, int powers) {
  std::vector<Bin> bins;
  if (volumes.empty()) return bins;
  TF_CHECK(powers >= 1);
  const int first = volumes.begin()->first;
  for (int power = first; power <= volumes.rbegin()->first; power += powers) {
    bins.push_back({format("from %.3g", std::ldexp(1.0, power)), 0});
  }
  for (const auto& [power, count] : volumes) {
    bins[static_cast<std::size_t>((power - first) / powers)].count += count;
  }
  return bins;
}

/// As few powers of two in a bin as make a table that is looked at.
int powers_of_bin(const std::map<int, std::int64_t>& volumes) {
  constexpr int most_bins = 24;
  if (volumes.empty()) return 1;
  return (volumes.rbegin()->first - volumes.begin()->first) / most_bins + 1;
}

std::string time_step_text(const MeshFigures& figures) {
  std::string text = format("time step       %.6g / wave speed, limited by the height at %s\n",
                            figures.time_step(), place_text(figures.all.lowest_at).c_str());
  if (figures.near_cuts.shapes.tets > 0 && figures.away_from_cuts.shapes.tets > 0) {
    text += format(
        "                %.3f times as many steps as the mesh away from the cuts would need\n",
        figures.steps_beside_away());
  }
  return text;
}

std::string worst_text(const MeshFigures& figures) {
  std::vector<std::vector<std::string>> rows;
  for (const WorstTet& tet : figures.worst) {
    rows.push_back({angle_text(tet.min_dihedral_deg, 3), angle_text(tet.max_dihedral_deg, 3),
                    format("%.4f", tet.radius_ratio), format("%.4g", tet.height),
                    format("%zu", tet.subdomain), tet.is_near_cut ? "yes" : "no",
                    place_text(tet.centroid)});
  }
  return table_text(
      {"MIN DEG", "MAX DEG", "RADIUS RATIO", "HEIGHT", "SUB-DOMAIN", "NEAR A CUT", "AT"}, rows);
}

Json histogram_json(const Histogram& histogram) {
  return {{"from", histogram.low}, {"to", histogram.high}, {"counts", histogram.counts}};
}

Json side_json(const TetFigures& figures) {
  return {{"radius_ratio_histogram", histogram_json(figures.radius_ratio)},
          {"smallest_height", figures.shapes.smallest_height},
          {"smallest_height_at", place_json(figures.lowest_at)}};
}

Json volumes_json(const MeshFigures& figures) {
  Json counts = Json::array();
  for (const Bin& bin : bins_of(figures.volumes, 1)) counts.push_back(bin.count);
  return {{"first_power_of_two", figures.volumes.empty() ? 0 : figures.volumes.begin()->first},
          {"counts", counts}};
}

Json edges_json(const EdgeFigures& edges) {
  if (edges.edges == 0) return nullptr;
  return {{"edges", edges.edges},
          {"shortest", edges.shortest},
          {"longest", edges.longest},
          {"mean", edges.mean()},
          {"histogram", histogram_json(edges.over_spacing)}};
}

}  // namespace

std::string figures_text(const MeshFigures& figures) {
  std::string text;
  if (figures.tets > 0) {
    text = time_step_text(figures);
    text += bars_text("radius ratio", bins_of(figures.all.radius_ratio, false));
    text += bars_text("volume", bins_of(figures.volumes, powers_of_bin(figures.volumes)));
  }
  const EdgeFigures& edges = figures.edges;
  if (edges.edges > 0) {
    text += bars_text(format("edge length over spacing: %.3f to %.3f, mean %.3f", edges.shortest,
                             edges.longest, edges.mean()),
                      bins_of(edges.over_spacing, true));
  }
  if (figures.knows_subdomains && figures.subdomains.size() > 1) {
    text += format("balance         %.3f: elements of the largest sub-domain / mean\n",
                   figures.largest_over_mean());
  }
  return figures.worst.empty() ? text : text + "worst tets\n" + worst_text(figures);
}

nlohmann::ordered_json figures_json(const MeshFigures& figures) {
  Json json = {{"time_step", figures.time_step()},
               {"smallest_height_at", place_json(figures.all.lowest_at)},
               {"steps_beside_away_from_cuts", figures.steps_beside_away()},
               {"radius_ratio_histogram", histogram_json(figures.all.radius_ratio)},
               {"volume_histogram", volumes_json(figures)},
               {"edge_over_spacing", edges_json(figures.edges)},
               {"near_cuts_figures", side_json(figures.near_cuts)},
               {"away_from_cuts_figures", side_json(figures.away_from_cuts)},
               {"worst", Json::array()},
               {"largest_over_mean", figures.largest_over_mean()},
               {"subdomain_elements", Json::array()}};
  for (const WorstTet& tet : figures.worst) {
    json["worst"].push_back({{"min_dihedral_deg", tet.min_dihedral_deg},
                             {"max_dihedral_deg", tet.max_dihedral_deg},
                             {"radius_ratio", tet.radius_ratio},
                             {"height", tet.height},
                             {"at", place_json(tet.centroid)},
                             {"subdomain", tet.subdomain},
                             {"tet", tet.tet},
                             {"near_cut", tet.is_near_cut}});
  }
  if (figures.knows_subdomains) {
    for (const SubdomainFigures& subdomain : figures.subdomains) {
      json["subdomain_elements"].push_back(subdomain.cells);
    }
  }
  return json;
}

}  // namespace tetfarm
