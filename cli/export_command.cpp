#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/counted.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "base/large_blocks.h"
#include "cli/commands.h"
#include "cli/mesh_input.h"
#include "cli/read_ahead.h"
#include "cli/typed_patches.h"
#include "json/json_line.h"
#include "mesh/core/element_block.h"
#include "mesh/formats/list/format.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/partition/partitioned_mesh.h"
#include "mesh/partition/renumbered_mesh.h"

namespace tetfarm {

namespace {

/// Where files may lie for a while: beside what is written.
std::filesystem::path folder_of(const std::filesystem::path& output) {
  const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
  make_folders(folder);
  return folder;
}

/// Parts that nobody could tell apart in the file would be worked out for nothing.
void require_parts_in(const Format& format, int partitions) {
  if (partitions == 0 || format.holds_parts) return;
  std::string others;
  for (const Format& other : written_formats()) {
    if (other.holds_parts) others += (others.empty() ? "" : ", ") + std::string(other.name);
  }
  throw ErrorWithHelp(
      ExitCode::usage,
      "--partitions " + std::to_string(partitions) + ": a file of format " +
          std::string(format.name) + " cannot say which part an element is in",
      "leave it out if the solver partitions the mesh itself; formats that can: " + others);
}

/// How far apart the numbers of neighbours are, in the parts as they were and as they are written.
struct NumberingFigures {
  NumberSpans before;
  NumberSpans after;
};

/// Puts the mesh with new numbers in the place of the other.
NumberingFigures renumber(std::unique_ptr<MeshSource>& source, const std::string& name) {
  NumberingFigures figures{spans_of(*source), {}};
  source = std::make_unique<RenumberedMesh>(
      std::move(source),
      name == "rcm" ? NodeNumbering::reverse_cuthill_mckee : NodeNumbering::hilbert);
  figures.after = spans_of(*source);
  return figures;
}

nlohmann::ordered_json spans_json(const NumberSpans& spans) {
  return {{"bandwidth", spans.bandwidth}, {"mean_difference", spans.mean()}};
}

/// "12 tets, 8 prisms, 30 nodes, 20 boundary triangles, 4 boundary quads": other types than tets
/// and triangles where there are any.
std::string counts_text(const ExportCounts& counts) {
  std::string text = std::to_string(counts.elements[ElementType::tet]) + " tets, ";
  for (const ElementType type : cell_block_types) {
    const std::int64_t count = counts.elements[type];
    if (count > 0) text += text_of_count(count, type) + ", ";
  }
  text += std::to_string(counts.nodes) + " nodes, " +
          std::to_string(counts.elements[ElementType::triangle]) + " boundary triangles";
  const std::int64_t quads = counts.elements[ElementType::quad];
  if (quads > 0) text += ", " + std::to_string(quads) + " boundary quads";
  return text;
}

nlohmann::ordered_json json_of(const ExportCommand& command, const Format& format,
                               const ExportCounts& counts, const PartitionFigures& figures,
                               const std::optional<NumberingFigures>& numbering) {
  nlohmann::ordered_json result = {{"type", "export"},
                                   {"file", command.output},
                                   {"format", format.name},
                                   {"nodes", counts.nodes},
                                   {"elements", counts.elements[ElementType::tet]},
                                   {"boundary_triangles", counts.elements[ElementType::triangle]},
                                   {"subdomains", counts.parts}};
  for (const ElementType type : cell_block_types) {
    if (counts.elements[type] > 0)
      result[std::string(element(type).plural)] = counts.elements[type];
  }
  const std::int64_t quads = counts.elements[ElementType::quad];
  if (quads > 0) result["boundary_quads"] = quads;
  if (!figures.cells.empty()) {
    result["partitions"] = {{"elements", figures.cells},
                            {"largest_over_mean", figures.largest_over_mean()},
                            {"cut_faces", figures.cut_faces}};
  }
  if (numbering) {
    result["numbering"] = {{"order", command.numbering},
                           {"before", spans_json(numbering->before)},
                           {"after", spans_json(numbering->after)}};
  }
  return result;
}

}  // namespace

ExitCode export_command(const ExportCommand& command) {
  keep_freed_memory();
  const Format& format = find_mesh_format(command.format, command.output);
  require_name_of_a_file(format, command.output);
  require_parts_in(format, command.partitions);
  const std::filesystem::path folder = folder_of(command.output);
  const MeshInput mesh = find_mesh(command.input, command.source, folder);
  std::unique_ptr<MeshSource> source = open_mesh(mesh, folder);
  if (!command.patch_types.empty()) {
    source = std::make_unique<TypedPatches>(std::move(source), command.patch_types);
  }
  PartitionFigures figures;
  if (command.partitions > 0) {
    PartitionOptions options;
    options.parts = command.partitions;
    options.keeps_columns = command.keep_columns == "yes";
    auto parts = std::make_unique<PartitionedMesh>(*source, options, folder);
    figures = parts->figures();
    source = std::move(parts);
  }
  std::optional<NumberingFigures> numbering;
  if (command.numbering != "as-meshed") numbering = renumber(source, command.numbering);
  if (source->takes_threads()) source = std::make_unique<ReadAhead>(std::move(source));
  const ExportCounts counts = export_mesh(*source, format, command.output);
  if (command.json) {
    std::printf("%s\n", json_line(json_of(command, format, counts, figures, numbering)).c_str());
    return ExitCode::ok;
  }
  std::printf("%s: %s; %s\n", command.output.c_str(), std::string(format.what).c_str(),
              counts_text(counts).c_str());
  if (!figures.cells.empty()) {
    std::printf("%s: largest/mean %.3f, %lld faces between them\n",
                counted(figures.cells.size(), "part").c_str(), figures.largest_over_mean(),
                static_cast<long long>(figures.cut_faces));
  }
  if (numbering) {
    std::printf(
        "node numbers of neighbours in a part differ by %.0f on average, %lld at most (before: "
        "%.0f, %lld)\n",
        numbering->after.mean(), static_cast<long long>(numbering->after.bandwidth),
        numbering->before.mean(), static_cast<long long>(numbering->before.bandwidth));
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
