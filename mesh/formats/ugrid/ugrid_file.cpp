#include "mesh/formats/ugrid/ugrid_file.h"

#include <cmath>
#include <limits>
#include <vector>

namespace tetfarm {
namespace {

struct NamedForm {
  std::string_view ending;
  UgridForm form;
};
constexpr std::array<NamedForm, 6> forms = {{{".b8.ugrid", {true, false, false}},
                                             {".lb8.ugrid", {false, false, false}},
                                             {".b8l.ugrid", {true, true, false}},
                                             {".lb8l.ugrid", {false, true, false}},
                                             {".b4.ugrid", {true, false, true}},
                                             {".lb4.ugrid", {false, false, true}}}};

}  // namespace

std::optional<UgridForm> ugrid_form(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  for (const auto& [ending, form] : forms) {
    if (name.ends_with(ending)) return form;
  }
  return std::nullopt;
}

UgridFile::UgridFile(const std::filesystem::path& path, UgridForm form) : file_(path), form_(form) {
  read_counts();
}

UgridFile::UgridFile(std::string_view bytes, const std::string& name, UgridForm form)
    : file_(bytes, name), form_(form) {
  read_counts();
}

void UgridFile::read_counts() {
  std::array<std::int64_t, 7> counts{};
  read_integers(0, counts);
  // A list of so many would not fit in a file: the sums of places cannot overflow.
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 1024;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::int64_t place = static_cast<std::int64_t>(i) * integer_bytes();
    if (counts[i] < 0) file_.fail("a count is negative", place);
    if (counts[i] > most) file_.fail("a count is larger than the file", place);
  }
  counts_ = {counts[0], counts[1], counts[2], counts[3], counts[4], counts[5], counts[6]};
  if (tet_place(0) > file_.size()) {
    file_.fail("the counts are of " + std::to_string(tet_place(0)) +
                   " bytes and more, but the file has only " + std::to_string(file_.size()),
               0);
  }
}

std::int64_t UgridFile::node_place(std::int64_t node) const {
  return 7 * integer_bytes() + node * node_bytes();
}
std::int64_t UgridFile::triangle_place(std::int64_t triangle) const {
  return node_place(counts_.nodes) + triangle * 3 * integer_bytes();
}
std::int64_t UgridFile::patch_place(std::int64_t face) const {
  return triangle_place(counts_.triangles) + (counts_.quadrangles * 4 + face) * integer_bytes();
}
std::int64_t UgridFile::tet_place(std::int64_t tet) const {
  return patch_place(counts_.triangles + counts_.quadrangles) + tet * 4 * integer_bytes();
}
std::int64_t UgridFile::expected_size() const {
  return tet_place(counts_.tets) +
         (counts_.pyramids * 5 + counts_.prisms * 6 + counts_.hexahedra * 8) * integer_bytes();
}

template <class Number>
void UgridFile::read(std::int64_t place, std::span<Number> into) const {
  file_.read(place, into.data(), into.size_bytes());
  if (form_.big_endian) turn_bytes(into);
}

void UgridFile::read_integers(std::int64_t place, std::span<std::int64_t> into) const {
  if (form_.wide) return read(place, into);
  std::vector<std::int32_t> numbers(into.size());
  read(place, std::span(numbers));
  std::copy(numbers.begin(), numbers.end(), into.begin());
}

void UgridFile::read_nodes(std::int64_t first, std::span<Vec3> into) const {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const std::int64_t place = node_place(first);
  const std::span<double> numbers(reinterpret_cast<double*>(into.data()), 3 * into.size());
  if (form_.short_reals) {
    std::vector<float> shorts(numbers.size());
    read(place, std::span(shorts));
    std::copy(shorts.begin(), shorts.end(), numbers.begin());
  } else {
    read(place, numbers);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) continue;
    file_.fail("a coordinate is " + std::to_string(numbers[i]),
               place + static_cast<std::int64_t>(i) * node_bytes() / 3);
  }
}

void UgridFile::read_triangles(std::int64_t first,
                               std::span<std::array<std::int64_t, 3>> into) const {
  read_integers(triangle_place(first),
                {reinterpret_cast<std::int64_t*>(into.data()), 3 * into.size()});
}

void UgridFile::read_patches(std::int64_t first, std::span<std::int64_t> into) const {
  read_integers(patch_place(first), into);
}

void UgridFile::read_tets(std::int64_t first, std::span<std::array<std::int64_t, 4>> into) const {
  read_integers(tet_place(first), {reinterpret_cast<std::int64_t*>(into.data()), 4 * into.size()});
}

std::int64_t UgridListCounts::of(ElementType type) const {
  const std::array all = {nodes, triangles, quadrangles, tets, pyramids, prisms, hexahedra};
  const std::int32_t code = code_of(ElementCodes::ugrid, type);
  return code == 0 ? 0 : all[static_cast<std::size_t>(code)];
}

/// Cells lie behind one another, type after type; faces before their patches.
std::int64_t UgridFile::element_place(ElementType type, std::int64_t i) const {
  std::int64_t place = is_cell(type) ? tet_place(0) : triangle_place(0);
  for (const ElementType before : all_element_types) {
    if (before == type) break;
    if (is_cell(before) != is_cell(type)) continue;
    place += counts_.of(before) * static_cast<std::int64_t>(nodes_of(before)) * integer_bytes();
  }
  return place + i * static_cast<std::int64_t>(nodes_of(type)) * integer_bytes();
}

void UgridFile::read_elements(ElementType type, std::int64_t first,
                              std::span<std::int64_t> into) const {
  read_integers(element_place(type, first), into);
}

void UgridFile::fail_at_quadrangle(const std::string& what, std::int64_t quadrangle) const {
  file_.fail(what, element_place(ElementType::quad, quadrangle));
}

void UgridFile::fail_at_corner(const std::string& what, std::int64_t triangle,
                               std::size_t corner) const {
  file_.fail(what, triangle_place(triangle) + static_cast<std::int64_t>(corner) * integer_bytes());
}

}  // namespace tetfarm
