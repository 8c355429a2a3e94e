#include "mesh/formats/write_msh41.h"

#include "mesh/formats/count_limit.h"
#include "mesh/formats/msh41_sections.h"
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

struct BlockHead {
  std::int32_t dimension = 0;
  std::int32_t entity = 0;
  std::int32_t type_or_parametric = 0;
  std::int64_t count = 0;
};

void put_block(NumberText& numbers, const BlockHead& head) {
  numbers.small(head.dimension);
  numbers.small(head.entity);
  numbers.small(head.type_or_parametric);
  numbers.integer(head.count);
  numbers.end_record();
}

void put_counts(NumberText& numbers, std::int64_t blocks, std::int64_t items, std::int64_t first,
                std::int64_t last) {
  for (const std::int64_t count : {blocks, items, first, last}) numbers.integer(count);
  numbers.end_record();
}

/// A file that grows at its end, with gaps to be filled later.
class GrowingEnd {
 public:
  explicit GrowingEnd(OutputFile& file) : file_(file) {}
  void write(const std::string& bytes) {
    file_.write(place_, bytes);
    place_ += std::ssize(bytes);
  }
  std::int64_t leave(std::int64_t bytes) { return std::exchange(place_, place_ + bytes); }

 private:
  OutputFile& file_;
  std::int64_t place_ = 0;
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
  put_counts(numbers, 1, outline.nodes, 1, outline.nodes);
  put_block(numbers, {3, 1, 0, outline.nodes});
  end.write(numbers.take());
  places.node_tags = end.leave(outline.nodes * style.record_bytes(1, 0));
  places.node_places = end.leave(outline.nodes * style.record_bytes(0, 3));
  numbers.words(msh_section_end("Nodes", style) + "$Elements\n");
  std::int64_t blocks = std::ssize(runs);
  for (const std::int64_t faces : outline.faces_of_patch) blocks += faces > 0 ? 1 : 0;
  const std::int64_t elements = outline.boundary_triangles + outline.tets;
  put_counts(numbers, blocks, elements, 1, elements);
  for (std::size_t i = 0; i < outline.faces_of_patch.size(); ++i) {
    const std::int64_t faces = outline.faces_of_patch[i];
    if (faces > 0) put_block(numbers, {2, static_cast<int>(i + 1), msh_triangle_type, faces});
    end.write(numbers.take());
    places.triangles.push_back(end.leave(faces * style.record_bytes(4, 0)));
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    put_block(numbers, {3, static_cast<int>(i + 1), msh_tet_type, runs[i].tets});
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

template <class Element>
void put_element(NumberText& numbers, std::int64_t number, const Element& element,
                 const NumberedPart& part) {
  numbers.integer(number);
  for (const std::int32_t v : element) numbers.integer(global_node(part, v) + 1);
  numbers.end_record();
}

/// Triangles are numbered patch after patch, then the tets.
std::vector<std::int64_t> first_numbers(const MeshOutline& outline) {
  std::vector<std::int64_t> first = {1};
  for (const std::int64_t faces : outline.faces_of_patch) first.push_back(first.back() + faces);
  return first;
}

}  // namespace

void write_msh41(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path, MshEncoding encoding) {
  OutputFile file(path);
  const NumberText style = msh_style(outline, encoding == MshEncoding::text);
  const Places places = write_frame(file, outline, style);
  const std::vector<std::int64_t> first_triangle = first_numbers(outline);
  const std::vector<RegionRun> runs = region_runs(outline);
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
        put_element(numbers, number++, part.faces[face], part);
      }
      file.write(places.triangles[patch] + before * style.record_bytes(4, 0), numbers.bytes());
    }
    std::size_t next = 0;
    for (; run < runs.size() && runs[run].part == i; ++run) {
      NumberText numbers = style;
      std::int64_t number = 1 + outline.boundary_triangles + runs[run].first_tet;
      for (std::int64_t t = 0; t < runs[run].tets; ++t) {
        put_element(numbers, number++, part.tets[next++], part);
      }
      file.write(places.tets[run], numbers.bytes());
    }
  }
  file.finish();
}

namespace {

/// A part has a surface entity for each patch and a volume entity for each region.
void refuse_more_entities_than_tags(const MeshOutline& outline) {
  const std::int64_t names =
      std::ssize(std::max(outline.patch_names, outline.region_names,
                          [](const auto& a, const auto& b) { return a.size() < b.size(); }));
  require_32_bits((std::ssize(outline.parts) + 1) * names, "entities", "Gmsh's split files",
                  "ask for fewer parts");
}

/// The tag of what a partition (from 1) has of a region (from 0): behind those of the regions.
std::int32_t volume_of(const MeshOutline& outline, std::int32_t partition, std::size_t region) {
  return static_cast<std::int32_t>(std::ssize(outline.region_names)) * partition +
         static_cast<std::int32_t>(region) + 1;
}

/// The volume that a partition's nodes are listed with.
std::int32_t first_volume(const MeshOutline& outline, std::size_t part) {
  const std::vector<std::int64_t>& tets = outline.parts[part].tets_of_region;
  std::size_t region = 0;
  while (region + 1 < tets.size() && tets[region] == 0) ++region;
  return volume_of(outline, static_cast<std::int32_t>(part + 1), region);
}

/// What a partition has of the whole mesh's entities: of each region and patch its part.
std::string partitioned_entities(const MeshOutline& outline, std::size_t index) {
  const PartOutline& part = outline.parts[index];
  const auto partition = static_cast<std::int32_t>(index + 1);
  const auto patches = static_cast<std::int32_t>(outline.patch_names.size());
  std::int32_t surfaces = 0;
  for (const std::int64_t faces : part.faces_of_patch) surfaces += faces > 0 ? 1 : 0;
  NumberText numbers = NumberText::raw();
  const auto put = [&](std::int32_t tag, std::int32_t dimension, std::int32_t parent) {
    for (const std::int32_t value : {tag, dimension, parent}) numbers.small(value);
    numbers.integer(1);
    numbers.small(partition);
    put_msh_box(numbers, part.box);
    numbers.integer(1);
    numbers.small(parent);
    numbers.integer(0);
  };
  numbers.words("$PartitionedEntities\n");
  numbers.integer(std::ssize(outline.parts));
  numbers.integer(0);
  const auto regions = static_cast<std::int32_t>(outline.region_names.size());
  std::int32_t volumes = 0;
  for (const std::int64_t tets : part.tets_of_region) volumes += tets > 0 ? 1 : 0;
  for (const std::int32_t count : {0, 0, surfaces, volumes}) numbers.integer(count);
  for (std::int32_t patch = 1; patch <= patches; ++patch) {
    if (part.faces_of_patch[static_cast<std::size_t>(patch - 1)] > 0) {
      put(patches * partition + patch, 2, patch);
    }
  }
  for (std::int32_t region = 1; region <= regions; ++region) {
    if (part.tets_of_region[static_cast<std::size_t>(region - 1)] > 0) {
      put(volume_of(outline, partition, static_cast<std::size_t>(region - 1)), 3, region);
    }
  }
  numbers.words(msh_section_end("PartitionedEntities", numbers));
  return numbers.take();
}

std::string nodes_of_partition(const NumberedPart& part, std::int32_t volume) {
  NumberText numbers = NumberText::raw();
  numbers.words("$Nodes\n");
  const auto [least, most] =
      std::minmax_element(part.local2global.begin(), part.local2global.end());
  const bool is_empty = part.nodes.empty();
  put_counts(numbers, 1, std::ssize(part.nodes), is_empty ? 0 : *least + 1,
             is_empty ? 0 : *most + 1);
  put_block(numbers, {3, volume, 0, std::ssize(part.nodes)});
  for (const std::int64_t number : part.local2global) numbers.integer(number + 1);
  for (const Vec3& p : part.nodes) {
    for (const double x : {p.x, p.y, p.z}) numbers.real(x);
  }
  numbers.words(msh_section_end("Nodes", numbers));
  return numbers.take();
}

/// `first_triangle` are the numbers of the first triangle of each patch.
std::string elements_of_partition(const NumberedPart& part, const MeshOutline& outline,
                                  const std::vector<std::int64_t>& first_triangle) {
  const auto partition = static_cast<std::int32_t>(part.number + 1);
  const auto patches = static_cast<std::int32_t>(outline.patch_names.size());
  const auto faces = faces_by_patch(part, outline.patch_names.size());
  const PartOutline& here = outline.parts[static_cast<std::size_t>(part.number)];
  std::int64_t blocks = 0;
  for (const std::int64_t tets : here.tets_of_region) blocks += tets > 0 ? 1 : 0;
  for (const auto& of_patch : faces) blocks += of_patch.empty() ? 0 : 1;
  NumberText numbers = NumberText::raw();
  numbers.words("$Elements\n");
  put_counts(numbers, blocks, std::ssize(part.tets) + std::ssize(part.faces), 1,
             outline.boundary_triangles + outline.tets);
  for (std::int32_t patch = 0; patch < patches; ++patch) {
    const auto& of_patch = faces[static_cast<std::size_t>(patch)];
    if (of_patch.empty()) continue;
    put_block(numbers,
              {2, patches * partition + patch + 1, msh_triangle_type, std::ssize(of_patch)});
    const auto index = static_cast<std::size_t>(patch);
    std::int64_t number = first_triangle[index] + here.first_face_of_patch[index];
    for (const std::size_t face : of_patch) {
      put_element(numbers, number++, part.faces[face], part);
    }
  }
  std::int64_t number = 1 + outline.boundary_triangles + here.first_tet;
  std::size_t next = 0;
  for (std::size_t region = 0; region < here.tets_of_region.size(); ++region) {
    const std::int64_t tets = here.tets_of_region[region];
    if (tets == 0) continue;
    put_block(numbers, {3, volume_of(outline, partition, region), msh_tet_type, tets});
    for (std::int64_t t = 0; t < tets; ++t) put_element(numbers, number++, part.tets[next++], part);
  }
  numbers.words(msh_section_end("Elements", numbers));
  return numbers.take();
}

}  // namespace

void write_msh41_split(const MeshSource& source, const MeshOutline& outline,
                       const std::filesystem::path& path) {
  refuse_more_entities_than_tags(outline);
  const NumberText raw = NumberText::raw();
  std::vector<MshVolume> regions;
  for (std::size_t i = 0; i < outline.region_names.size(); ++i) {
    regions.push_back({static_cast<std::int32_t>(i + 1), box_of(outline)});
  }
  const std::string head = msh_head(outline, raw) + msh_entities(outline, regions, raw);
  const std::vector<std::int64_t> first_triangle = first_numbers(outline);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const std::int32_t volume = first_volume(outline, i);
    const std::string name =
        path.stem().string() + "_" + std::to_string(i + 1) + path.extension().string();
    OutputFile file(path.parent_path() / name);
    GrowingEnd end(file);
    end.write(head + partitioned_entities(outline, i));
    end.write(nodes_of_partition(part, volume));
    end.write(elements_of_partition(part, outline, first_triangle));
    file.finish();
  }
}

}  // namespace tetfarm
