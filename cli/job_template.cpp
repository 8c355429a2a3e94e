#include "cli/job_template.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/angle_text.h"
#include "base/counted.h"
#include "base/error.h"
#include "base/job_name.h"
#include "base/printable_text.h"
#include "base/utf8.h"
#include "cli/progress_display.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_formats.h"
#include "mesh/job_file/toml_text.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_patches = 60;
constexpr std::size_t most_patches_of_layers = 3;

/// With few digits, for values to start from.
double rounded(double value, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return std::strtod(text.data(), nullptr);
}

std::string rounded_length(double value) { return toml_number(rounded(value, 3)); }

std::string rounded_place(const Vec3& at) {
  return rounded_length(at.x) + ", " + rounded_length(at.y) + ", " + rounded_length(at.z);
}

std::string remark_line(const std::string& words) { return "# " + words + "\n"; }

/// In lines that fit a terminal.
std::string remarks(const std::string& words) {
  constexpr std::size_t longest_line = 88;
  std::string text;
  std::string line = "#";
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (line.size() + 1 + word.size() > longest_line) {
      text += line + "\n";
      line = "#";
    }
    line += " " + word;
  }
  return text + line + "\n";
}

std::string about_lengths(const ProposedJob& proposed) {
  if (!proposed.unit.empty()) {
    return "Lengths are in metres; the surface's file is in " + proposed.unit + ".";
  }
  if (proposed.scale == 1) return "Lengths are in the unit of the surface.";
  return "Lengths are those of the surface's file times " + toml_number(proposed.scale) + ".";
}

std::string about_file(const ProposedJob& proposed, const std::string& file) {
  return remark_line("Job file of " + printable(proposed.surface) +
                     ", written by `tetfarm init`. It can be used as it is:") +
         remark_line("    tetfarm plan " + file + "           what the job comes to") +
         remark_line("    tetfarm run " + file + " -o out     the mesh, in the folder `out`") +
         "#\n" +
         remarks(
             "Lines with # and a blank are remarks. Those with # right before a word are settings "
             "that are not in force: take the # away to use one, and from the settings right above "
             "and below it, which belong to it. Where a second # is left, the setting is optional. "
             "Each shows the value that counts without it, or an example where there is none. All "
             "keys are in docs/job_file.md. " +
             about_lengths(proposed));
}

std::string patch_line(const ProposedPatch& patch) {
  std::array<char, 60> figures{};
  std::snprintf(figures.data(), figures.size(), "  %10lld  %11.4g  ",
                static_cast<long long>(patch.triangles), patch.median_edge);
  return remark_line(figures.data() + quoted_toml(printable(patch.name)));
}

std::string about_patches(const ProposedJob& proposed) {
  std::string text = remark_line("   triangles  median edge  patch");
  const std::size_t shown = std::min(most_patches, proposed.patches.size());
  for (std::size_t i = 0; i < shown; ++i) text += patch_line(proposed.patches[i]);
  if (shown == proposed.patches.size()) return text;
  return text + remark_line("  and " + std::to_string(proposed.patches.size() - shown) + " more");
}

std::string about_regions(const ProposedJob& proposed) {
  std::string text;
  for (const RegionFigures& region : proposed.report.regions) {
    const std::string number =
        region.number > 0 ? "region " + std::to_string(region.number) : "void";
    text += remark_line("  " + number + ": " + quoted_toml(printable(region.name)) + ", volume " +
                        rounded_length(region.volume));
  }
  return text;
}

std::string about_surface(const ProposedJob& proposed) {
  const SurfaceReport& report = proposed.report;
  const Vec3 size = proposed.box.size();
  return "\n" +
         remark_line("The surface has " +
                     counted(static_cast<std::uint64_t>(proposed.triangles), "triangle") + " in " +
                     counted(report.shells.size(), "shell") + ".") +
         remark_line("  box " + rounded_length(size.x) + " x " + rounded_length(size.y) + " x " +
                     rounded_length(size.z) + ", from " + rounded_place(proposed.box.low) + " to " +
                     rounded_place(proposed.box.high)) +
         remark_line("  edges " + rounded_length(report.shortest_edge) + " shortest, " +
                     rounded_length(report.median_edge) + " median, " +
                     rounded_length(report.longest_edge) + " longest; smallest angle " +
                     angle_text(report.smallest_angle_deg) + " deg") +
         about_patches(proposed) + about_regions(proposed) +
         remark_line("As it is, the job has about " + short_count(proposed.elements) +
                     " elements.");
}

std::string scale_setting(const ProposedJob& proposed) {
  if (!proposed.unit.empty()) return "unit = " + quoted_toml(proposed.unit) + "\n";
  return proposed.scale == 1 ? "" : "scale = " + toml_number(proposed.scale) + "\n";
}

std::string geometry_section(const ProposedJob& proposed) {
  const bool has_name = problem_with_job_name(proposed.name).empty();
  return "\nversion = 1\n" + (has_name ? "name = " + quoted_toml(proposed.name) + "\n" : "") +
         "\n[geometry]\n" + remarks("A relative path starts at this file's folder.") +
         "surface = " + quoted_toml(proposed.surface) + "\n" + scale_setting(proposed);
}

std::string surface_section(const ProposedJob& proposed) {
  constexpr int digits = 4;
  const RemeshOptions& options = proposed.remeshing;
  return "\n[surface]\n" +
         remarks(
             "The triangles of the surface are faces of the mesh. With this, even ones take their "
             "place first: with edges of `size`, down to `min_size` where the surface is curved or "
             "narrow. Edges sharper than `angle` (degrees) stay, and nothing lies farther from the "
             "given surface than `tolerance` (by itself less on small faces).") +
         "#remesh = true\n##size = " + toml_number(rounded(options.size, digits)) +
         "\n##min_size = " + toml_number(rounded(options.min_size, digits)) +
         "\n##angle = " + toml_number(options.angle_deg) +
         "\n##tolerance = " + toml_number(rounded(options.tolerance, digits)) + "\n";
}

std::string domain_section(const ProposedJob& proposed) {
  return "\n[domain]\n" +
         remarks(
             "As it is, the space within the surface is meshed. With this, the surface is a body, "
             "and the space round it is meshed, out to a box (or \"sphere\") of `factor` times its "
             "size: about " +
             short_count(proposed.elements_in_box) +
             " elements. `spacing` is the edge length on the box.") +
         "#outer = \"box\"\n##factor = " + toml_number(default_outer_factor("box")) +
         "\n##spacing = " + rounded_length(proposed.edge_of_box) + "\n";
}

/// Of waves for which the edge is about a tenth of the length, in metres.
std::string frequency_for(double edge) {
  constexpr double mega = 1e6;
  const WaveSize wave;
  const double hertz = rounded(wave.speed / (wave.per_wavelength * edge), 1);
  const bool is_common = hertz >= mega && hertz < mega * mega;
  return is_common ? "\"" + toml_number(rounded(hertz / mega, 1)) + "MHz\"" : toml_number(hertz);
}

std::string spacing_section(const ProposedJob& proposed) {
  const WaveSize wave;
  const double longest = proposed.report.longest_edge;
  return "\n[spacing]\n" +
         remarks("By how much edges may grow per unit of length, away from surface and sources.") +
         "growth = " + toml_number(JobFile{}.growth) + "\n" +
         remarks(
             "The longest that edges may be; without it, as long as the growth allows. This is the "
             "longest edge of the surface.") +
         "#default = " + rounded_length(longest) + "\n" +
         remarks(
             "In place of `default`, for waves: so many edges to a wavelength. The speed is that "
             "of light in metres per second" +
             std::string(proposed.unit.empty()
                             ? "; a surface in millimetres needs 1000 times as much."
                             : ".")) +
         "#frequency = " + frequency_for(longest) + "\n##wave_speed = " + toml_number(wave.speed) +
         "\n##per_wavelength = " + toml_number(wave.per_wavelength) + "\n" +
         remarks("\"ignore\": only `default` and the sources count, not the surface's own edges.") +
         "#surface = \"inherit\"\n" +
         remarks("A job of more elements is refused before it starts; 0: no job is.") +
         "#max_elements = " + std::to_string(JobFile{}.max_elements) + "\n";
}

std::string source_example(const ProposedJob& proposed) {
  constexpr double inner_share = 0.05;
  constexpr double outer_share = 0.2;
  const double diagonal = norm(proposed.box.size());
  return "\n" +
         remarks(
             "Finer edges round a point, here the middle of the surface's box: `spacing` within "
             "the inner radius, growing up to the outer one. There may be any number of these, and "
             "the kinds \"line\" and \"triangle\".") +
         "#[[source]]\n#kind = \"point\"\n#at = [" + rounded_place(proposed.box.centre()) +
         "]\n#spacing = " + rounded_length(proposed.report.median_edge / 2) +
         "\n#inner = " + rounded_length(inner_share * diagonal) +
         "\n#outer = " + rounded_length(outer_share * diagonal) + "\n";
}

/// The finest ones, which are most often the walls. Only names that mean themselves when typed.
std::vector<ProposedPatch> patches_for_layers(const ProposedJob& proposed) {
  std::vector<ProposedPatch> fine;
  for (const ProposedPatch& patch : proposed.patches) {
    const bool is_plain = !patch.name.empty() && printable(patch.name) == patch.name &&
                          patch.name.find_first_of("*?") == std::string::npos;
    if (patch.triangles > 0 && is_plain) fine.push_back(patch);
  }
  std::stable_sort(fine.begin(), fine.end(), [](const ProposedPatch& a, const ProposedPatch& b) {
    return a.median_edge < b.median_edge;
  });
  const auto last = std::find_if(fine.begin(), fine.end(), [&fine](const ProposedPatch& patch) {
    return patch.median_edge > 2 * fine.front().median_edge;
  });
  fine.erase(last, fine.end());
  if (fine.size() > most_patches_of_layers) fine.resize(most_patches_of_layers);
  return fine;
}

/// None for several regions, where no layers grow.
std::string layers_example(const ProposedJob& proposed) {
  if (proposed.report.regions.size() > 1) return "";
  constexpr double first_share = 0.1;
  const std::vector<ProposedPatch> fine = patches_for_layers(proposed);
  std::string names;
  for (const ProposedPatch& patch : fine) {
    names += (names.empty() ? "" : ", ") + quoted_toml(patch.name);
  }
  if (fine.empty()) names = "\"*\"";
  const double edge = fine.empty() ? proposed.report.median_edge : fine.front().median_edge;
  const JobLayers defaults;
  return "\n" +
         remarks(
             "Boundary layers on patches (names as above; * stands for any text), each `growth` "
             "times as high as the one below. `tetfarm spacing` finds the first height for a y+. "
             "Without `count` they end where they are about as high as the surface's edges.") +
         "#[[layers]]\n#patches = [" + names +
         "]\n#first_height = " + rounded_length(first_share * edge) +
         "\n##growth = " + toml_number(defaults.growth) +
         "\n##count = 10\n##fan_angle = " + toml_number(defaults.fan_angle) + "\n";
}

/// Of the finest patch with a name that means itself.
std::string patch_example(const ProposedJob& proposed) {
  const std::vector<ProposedPatch> fine = patches_for_layers(proposed);
  if (fine.empty()) return "";
  const ProposedPatch& patch = fine.front();
  return "\n" +
         remarks(
             "What a patch is to a solver, and how long edges are at it, growing away from it. "
             "There may be one of these for each patch, or for several (* stands for any text).") +
         "#[patch." + quoted_toml(patch.name) +
         "]\n#type = \"wall\"\n##size = " + rounded_length(patch.median_edge / 2) + "\n";
}

std::string decompose_section(const ProposedJob& proposed) {
  return "\n[decompose]\n" +
         remarks("Into how many sub-domains the domain is cut, which workers mesh side by side.") +
         "#subdomains = " + std::to_string(proposed.subdomains) + "\n" +
         remarks("In place of `subdomains`: as many as it takes for no task to need more memory.") +
         "#max_memory = \"2GiB\"\n";
}

std::string quality_section() {
  return "\n[quality]\n" +
         remarks(
             "Gates: a mesh with a smaller dihedral angle (degrees) ends with exit code 4. This "
             "one is for the elements where the surface forces no small angles,") +
         "#min_unforced_dihedral = " + toml_number(JobFile{}.min_unforced_dihedral_deg) + "\n" +
         remarks("and this one, which is off by default, for all.") + "#min_dihedral = 1\n";
}

std::string output_section() {
  std::string formats;
  for (const std::string_view format : job_output_formats()) formats += " " + std::string(format);
  return "\n[output]\n" + remarks("What is written, any of:" + formats) +
         "formats = [\"vtkhdf\"]\n" +
         remarks("\"needed\": files between the tasks go when no task needs them any more.") +
         "#keep = \"all\"\n";
}

}  // namespace

std::string job_template(const ProposedJob& proposed, const std::string& file) {
  if (!is_utf8(proposed.surface)) {
    throw UsageError("this path is not UTF-8, and a job file cannot name it; rename it",
                     printable(proposed.surface));
  }
  return about_file(proposed, printable(file)) + about_surface(proposed) +
         geometry_section(proposed) + surface_section(proposed) + domain_section(proposed) +
         spacing_section(proposed) + source_example(proposed) + patch_example(proposed) +
         layers_example(proposed) + decompose_section(proposed) + quality_section() +
         output_section();
}

}  // namespace tetfarm
