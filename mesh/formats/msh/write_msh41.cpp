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
  std::vector<std::int64_t> triangles;  ///< of each patch
  std::vector<std::int64_t> tets;       ///< of each run of a region in a part
};

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
  std::int64_t blocks = std::ssize(runs);
  for (const std::int64_t faces : outline.faces_of_patch) blocks += faces > 0 ? 1 : 0;
  const std::int64_t elements = outline.boundary_triangles + outline.tets;
  put_msh_counts(numbers, blocks, elements, 1, elements);
  for (std::size_t i = 0; i < outline.faces_of_patch.size(); ++i) {
    const std::int64_t faces = outline.faces_of_patch[i];
    if (faces > 0) put_msh_block(numbers, {2, static_cast<int>(i + 1), msh_triangle_type, faces});
    end.write(numbers.take());
    places.triangles.push_back(end.leave(faces * style.record_bytes(4, 0)));
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    put_msh_block(numbers, {3, static_cast<int>(i + 1), msh_tet_type, runs[i].tets});
    end.write(numbers.take());
    places.tets.push_back(end.leave(runs[i].tets * style.record_bytes(5, 0)));
  }
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

}  // namespace

void write_msh41(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path, MshEncoding encoding) {
  OutputFile file(path);
  const NumberText style = msh_style(outline, encoding == MshEncoding::text);
  const Places places = write_frame(file, outline, style);
  const std::vector<std::int64_t> first_triangle = first_msh_triangles(outline);
  const std::vector<RegionRun> runs = region_runs(outline);
  TF_CHECK(outline.parts.size() == source.size());
  TF_CHECK(places.tets.size() == runs.size());
  std::size_t run = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    write_nodes(file, part, places, style);
    const auto faces = faces_by_patch(part, outline.patch_names.size());
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      NumberText numbers = style;
      const std::int64_t before = outline.parts[i].first_face_of_patch[patch];
      std::int64_t number = first_triangle[patch] + before;
      for (const std::size_t face : faces[patch]) {
        put_msh_element(numbers, number++, part.faces[face], part);
      }
      file.write(places.triangles[patch] + before * style.record_bytes(4, 0), numbers.bytes());
    }
    std::size_t next = 0;
    for (; run < runs.size() && runs[run].part == i; ++run) {
      NumberText numbers = style;
      std::int64_t number = 1 + outline.boundary_triangles + runs[run].first_tet;
      for (std::int64_t t = 0; t < runs[run].tets; ++t) {
        put_msh_element(numbers, number++, part.tets[next++], part);
      }
      file.write(places.tets[run], numbers.bytes());
    }
  }
  TF_CHECK(run == runs.size());
  file.finish();
}

}  // namespace tetfarm
