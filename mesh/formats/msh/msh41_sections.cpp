#include "mesh/formats/msh/msh41_sections.h"

#include <algorithm>

namespace tetfarm {
namespace {

std::string quoted_name(const std::string& name) {
  std::string quoted;
  for (const char c : name) quoted += c == '"' || c == '\n' ? '_' : c;
  return '"' + quoted + '"';
}

}  // namespace

NumberText msh_style(const MeshOutline& outline, bool is_text) {
  if (!is_text) return NumberText::raw();
  return NumberText::text(std::max(outline.nodes, outline.cells() + outline.boundary_faces()));
}

std::string msh_section_end(const std::string& name, const NumberText& style) {
  return (style.is_text() ? "$End" : "\n$End") + name + "\n";
}

std::string msh_head(const MeshOutline& outline, const NumberText& style) {
  NumberText head = style;
  head.words(style.is_text() ? "$MeshFormat\n4.1 0 8\n" : "$MeshFormat\n4.1 1 8\n");
  if (!style.is_text()) {
    head.small(1);
    head.words("\n");
  }
  head.words("$EndMeshFormat\n$PhysicalNames\n" +
             std::to_string(outline.patch_names.size() + outline.region_names.size()) + "\n");
  const auto names = [&](const char* dimension, const std::vector<std::string>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      head.words(dimension + std::to_string(i + 1) + " " + quoted_name(all[i]) + "\n");
    }
  };
  names("2 ", outline.patch_names);
  names("3 ", outline.region_names);
  head.words("$EndPhysicalNames\n");
  return head.take();
}

void put_msh_box(NumberText& numbers, const Box3& box) {
  for (const Vec3& corner : {box.low, box.high}) {
    for (const double x : {corner.x, corner.y, corner.z}) numbers.real(box.empty() ? 0 : x);
  }
}

Box3 box_of(const MeshOutline& outline) {
  Box3 box;
  for (const PartOutline& part : outline.parts) {
    if (!part.box.empty()) box.add(part.box);
  }
  return box;
}

std::string msh_entities(const MeshOutline& outline, const std::vector<MshVolume>& volumes,
                         const NumberText& style) {
  NumberText numbers = style;
  const auto put = [&](std::int32_t tag, const Box3& box, std::int32_t physical) {
    numbers.small(tag);
    put_msh_box(numbers, box);
    numbers.integer(1);
    numbers.small(physical);
    numbers.integer(0);
    numbers.end_record();
  };
  numbers.words("$Entities\n");
  numbers.integer(0);
  numbers.integer(0);
  numbers.integer(std::ssize(outline.patch_names));
  numbers.integer(std::ssize(volumes));
  numbers.end_record();
  const Box3 all = box_of(outline);
  for (std::int32_t i = 1; i <= std::ssize(outline.patch_names); ++i) put(i, all, i);
  for (std::int32_t i = 1; i <= std::ssize(volumes); ++i) {
    const MshVolume& volume = volumes[static_cast<std::size_t>(i - 1)];
    put(i, volume.box, volume.region);
  }
  numbers.words(msh_section_end("Entities", style));
  return numbers.take();
}

void put_msh_block(NumberText& numbers, const MshBlockHead& head) {
  numbers.small(head.dimension);
  numbers.small(head.entity);
  numbers.small(head.type_or_parametric);
  numbers.integer(head.count);
  numbers.end_record();
}

void put_msh_counts(NumberText& numbers, std::int64_t blocks, std::int64_t items,
                    std::int64_t first, std::int64_t last) {
  for (const std::int64_t count : {blocks, items, first, last}) numbers.integer(count);
  numbers.end_record();
}

MshNumbers first_msh_numbers(const MeshOutline& outline) {
  MshNumbers first;
  std::int64_t next = 1 + outline.boundary_triangles;
  for (const ElementType type : face_block_types) {
    first.block[type] = next;
    next += outline.blocks[type].count;
  }
  first.tet = next;
  next += outline.tets;
  for (const ElementType type : cell_block_types) {
    first.block[type] = next;
    next += outline.blocks[type].count;
  }
  return first;
}

std::vector<std::int64_t> first_msh_triangles(const MeshOutline& outline) {
  std::vector<std::int64_t> first = {1};
  for (const std::int64_t faces : outline.faces_of_patch) first.push_back(first.back() + faces);
  return first;
}

}  // namespace tetfarm
