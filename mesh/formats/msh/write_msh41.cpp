#include "mesh/formats/msh/write_msh41.h"

#include "base/check.h"
#include "mesh/formats/msh/msh41_sections.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// Where the lists of the file begin.
struct Places {
  std::int64_t node_tags = 0;
  std::int64_t node_places = 0;
  std::vector<std::int64_t> triangles;      ///< of each patch
  ByType<std::vector<std::int64_t>> faces;  ///< of each patch, of types in blocks
  std::vector<std::int64_t> tets;           ///< of each run of a region in a part
  ByType<std::vector<std::int64_t>> cells;  ///< the same
};

/// Bytes of an element with its number.
std::int64_t element_bytes(ElementType type, const NumberText& style) {
  return style.record_bytes(static_cast<int>(1 + nodes_of(type)), 0);
}

/// A list of elements of one entity, after its head; without elements neither is there.
std::int64_t leave_block(NumberText& numbers, GrowingEnd& end, ElementType type, std::size_t entity,
                         std::int64_t count) {
  if (count > 0) {
    put_msh_block(numbers, {element(type).dimension, static_cast<std::int32_t>(entity + 1),
                            msh_code(type), count});
  }
  end.write(numbers.take());
  return end.leave(count * element_bytes(type, numbers));
}

/// A run without any cells has a list of tets without tets.
bool has_tets(const RegionRun& run) { return run.tets > 0 || run.cells() == 0; }

std::int64_t blocks_of(const MeshOutline& outline, const std::vector<RegionRun>& runs) {
  std::int64_t blocks = 0;
  for (const RegionRun& run : runs) {
    blocks += has_tets(run) ? 1 : 0;
    for (const ElementType type : cell_block_types) blocks += run.others[type] > 0 ? 1 : 0;
  }
  for (const std::int64_t faces : outline.faces_of_patch) blocks += faces > 0 ? 1 : 0;
  for (const ElementType type : face_block_types) {
    for (const std::int64_t faces : outline.blocks[type].of_group) blocks += faces > 0 ? 1 : 0;
  }
  return blocks;
}

void leave_elements(NumberText& numbers, GrowingEnd& end, const MeshOutline& outline,
                    const std::vector<RegionRun>& runs, Places& places) {
  const std::size_t patches = outline.patch_names.size();
  for (std::size_t i = 0; i < patches; ++i) {
    places.triangles.push_back(
        leave_block(numbers, end, ElementType::triangle, i, outline.faces_of_patch[i]));
  }
  for (const ElementType type : face_block_types) {
    for (std::size_t i = 0; i < patches; ++i) {
      places.faces[type].push_back(
          leave_block(numbers, end, type, i, outline.blocks[type].of_group[i]));
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (has_tets(runs[i])) {
      put_msh_block(numbers, {3, static_cast<int>(i + 1), msh_tet_type, runs[i].tets});
    }
    end.write(numbers.take());
    places.tets.push_back(end.leave(runs[i].tets * element_bytes(ElementType::tet, numbers)));
  }
  for (const ElementType type : cell_block_types) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      places.cells[type].push_back(leave_block(numbers, end, type, i, runs[i].others[type]));
    }
  }
}

Places write_frame(OutputFile& file, const MeshOutline& outline, const NumberText& style) {
  GrowingEnd end(file);
  Places places;
  std::vector<MshVolume> volumes;
  const std::vector<RegionRun> runs = region_runs(outline);
  for (const RegionRun& run : runs) volumes.push_back({run.region, outline.parts[run.part].box});
  end.write(msh_head(outline, style));
  end.write(msh_entities(outline, volumes, style));
  NumberText numbers = style;
  numbers.words("$Nodes\n");
  put_msh_counts(numbers, 1, outline.nodes, 1, outline.nodes);
  put_msh_block(numbers, {3, 1, 0, outline.nodes});
  end.write(numbers.take());
  places.node_tags = end.leave(outline.nodes * style.record_bytes(1, 0));
  places.node_places = end.leave(outline.nodes * style.record_bytes(0, 3));
  numbers.words(msh_section_end("Nodes", style) + "$Elements\n");
  const std::int64_t elements = outline.boundary_faces() + outline.cells();
  put_msh_counts(numbers, blocks_of(outline, runs), elements, 1, elements);
  leave_elements(numbers, end, outline, runs, places);
  end.write(msh_section_end("Elements", style));
  return places;
}

void write_nodes(OutputFile& file, const NumberedPart& part, const Places& places,
                 const NumberText& style) {
  write_node_records(file, places.node_tags, style.record_bytes(1, 0), part, style,
                     [](NumberText& numbers, std::int64_t number, const Vec3&) {
                       numbers.integer(number + 1);
                       numbers.end_record();
                     });
  write_node_records(file, places.node_places, style.record_bytes(0, 3), part, style,
                     [](NumberText& numbers, std::int64_t, const Vec3& p) {
                       for (const double x : {p.x, p.y, p.z}) numbers.real(x);
                       numbers.end_record();
                     });
}

/// The elements of the patches, by their numbers.
void write_faces(OutputFile& file, const NumberedPart& part, const PartOutline& here,
                 const MeshOutline& outline, const Places& places, const NumberText& style) {
  const std::vector<std::int64_t> first_triangle = first_msh_triangles(outline);
  const auto triangles = faces_by_patch(part, outline.patch_names.size());
  for (std::size_t patch = 0; patch < triangles.size(); ++patch) {
    NumberText numbers = style;
    const std::int64_t before = here.first_face_of_patch[patch];
    std::int64_t number = first_triangle[patch] + before;
    for (const std::size_t face : triangles[patch]) {
      put_msh_element(numbers, number++, part.faces[face], part);
    }
    file.write(places.triangles[patch] + before * style.record_bytes(4, 0), numbers.bytes());
  }
  for (const ElementType type : face_block_types) {
    if (part.blocks[type].empty()) continue;
    std::int64_t first = first_msh_numbers(outline).block[type];
    const auto faces = faces_by_patch(part.blocks[type], outline.patch_names.size());
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      NumberText numbers = style;
      const std::int64_t before = here.blocks[type].first_of_group[patch];
      std::int64_t number = first + before;
      for (const std::size_t face : faces[patch]) {
        put_msh_element(numbers, number++, type, part, face);
      }
      file.write(places.faces[type][patch] + before * element_bytes(type, style), numbers.bytes());
      first += outline.blocks[type].of_group[patch];
    }
  }
}

/// The cells of a run; `next` are those of the part that have been written.
void write_run(OutputFile& file, const NumberedPart& part, const RegionRun& run, std::size_t index,
               const MshNumbers& first, const Places& places, const NumberText& style,
               std::size_t& next_tet, ByType<std::size_t>& next) {
  NumberText numbers = style;
  std::int64_t number = first.tet + run.first_tet;
  for (std::int64_t t = 0; t < run.tets; ++t) {
    put_msh_element(numbers, number++, part.tets[next_tet++], part);
  }
  file.write(places.tets[index], numbers.bytes());
  for (const ElementType type : cell_block_types) {
    if (run.others[type] == 0) continue;
    NumberText cells = style;
    number = first.block[type] + run.first_in_block[type];
    for (std::int64_t i = 0; i < run.others[type]; ++i) {
      put_msh_element(cells, number++, type, part, next[type]++);
    }
    file.write(places.cells[type][index], cells.bytes());
  }
}

void write_msh41(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path, const NumberText& style) {
  OutputFile file(path);
  const Places places = write_frame(file, outline, style);
  const MshNumbers first = first_msh_numbers(outline);
  const std::vector<RegionRun> runs = region_runs(outline);
  TF_CHECK(outline.parts.size() == source.size());
  TF_CHECK(places.tets.size() == runs.size());
  std::size_t run = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    write_nodes(file, part, places, style);
    write_faces(file, part, outline.parts[i], outline, places, style);
    std::size_t next_tet = 0;
    ByType<std::size_t> next;
    for (; run < runs.size() && runs[run].part == i; ++run) {
      write_run(file, part, runs[run], run, first, places, style, next_tet, next);
    }
  }
  TF_CHECK(run == runs.size());
  file.finish();
}

}  // namespace

void write_msh41_binary(const MeshSource& source, const MeshOutline& outline,
                        const std::filesystem::path& file) {
  write_msh41(source, outline, file, msh_style(outline, false));
}

void write_msh41_text(const MeshSource& source, const MeshOutline& outline,
                      const std::filesystem::path& file) {
  write_msh41(source, outline, file, msh_style(outline, true));
}

}  // namespace tetfarm
