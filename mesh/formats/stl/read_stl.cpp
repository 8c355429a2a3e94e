#include "mesh/formats/stl/read_stl.h"

#include <cmath>
#include <cstring>

#include "base/error.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/vertex_welding.h"

namespace tetfarm {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

std::uint64_t triangle_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size - sizeof count, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + facet_size * triangle_count(bytes);
}

bool is_ascii(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (start == bytes.npos) return false;
  std::string word(bytes.substr(start, 5));
  for (char& c : word) c = static_cast<char>(c | 0x20);
  // A binary file of the wrong size may begin with "solid" too, but a text has no zero bytes.
  return word == "solid" && bytes.substr(0, header_size).find('\0') == bytes.npos;
}

SurfaceMesh read_binary(std::string_view bytes, const std::string& name) {
  const std::size_t count = triangle_count(bytes);
  SurfaceMesh surface;
  surface.triangles.reserve(count);
  VertexWelding welding(count / 2 + 2);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 9> xyz;
    const std::size_t offset = header_size + facet_size * i + 12;
    std::memcpy(xyz.data(), bytes.data() + offset, sizeof xyz);
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = {xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        throw InvalidInput("triangle " + std::to_string(i) + " has a coordinate that is not finite",
                           name + ": byte " + std::to_string(offset + 12 * k),
                           {static_cast<std::int64_t>(i)});
      }
      triangle[k] = welding.add(p);
    }
    surface.triangles.push_back(triangle);
  }
  surface.vertices = welding.take_points();
  return surface;
}

bool same_word(std::string_view word, std::string_view lower_case) {
  if (word == lower_case) return true;
  if (word.size() != lower_case.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if ((word[i] | 0x20) != lower_case[i]) return false;
  }
  return true;
}

void expect(InputScanner& scanner, std::string_view keyword) {
  const std::string_view word = scanner.word();
  if (same_word(word, keyword)) return;
  scanner.fail("expected " + std::string(keyword) + ", found " + quoted(word));
}

/// From behind the word "facet". The normal is passed over: it may be anything, even "nan", and
/// some programs write none.
Triangle read_facet(InputScanner& scanner, VertexWelding& welding) {
  const std::string_view word = scanner.word();
  if (same_word(word, "normal")) {
    for (int i = 0; i < 3; ++i) scanner.word();
    expect(scanner, "outer");
  } else if (!same_word(word, "outer")) {
    scanner.fail("expected normal, found " + quoted(word));
  }
  expect(scanner, "loop");
  Triangle triangle;
  for (std::int32_t& vertex : triangle) {
    expect(scanner, "vertex");
    const double x = scanner.coordinate();
    const double y = scanner.coordinate();
    vertex = welding.add({x, y, scanner.coordinate()});
  }
  expect(scanner, "endloop");
  expect(scanner, "endfacet");
  return triangle;
}

SurfaceMesh read_ascii(std::string_view bytes, const std::string& name) {
  constexpr std::size_t usual_facet_size = 200;
  InputScanner scanner(bytes, name);
  SurfaceMesh surface;
  PatchNames patches;
  VertexWelding welding(bytes.size() / usual_facet_size / 2 + 2);
  surface.triangles.reserve(bytes.size() / usual_facet_size);
  surface.patch_of_triangle.reserve(bytes.size() / usual_facet_size);
  while (!scanner.at_end()) {
    expect(scanner, "solid");
    const std::string_view solid = scanner.rest_of_line();
    std::int32_t patch = -1;
    for (;;) {
      const std::string_view word = scanner.word();
      if (same_word(word, "endsolid")) break;
      if (!same_word(word, "facet")) {
        scanner.fail("expected facet or endsolid, found " + quoted(word));
      }
      surface.triangles.push_back(read_facet(scanner, welding));
      if (patch < 0) patch = patches.number_of(solid);
      surface.patch_of_triangle.push_back(patch);
    }
    scanner.rest_of_line();
  }
  surface.vertices = welding.take_points();
  surface.patch_names = patches.take();
  return surface;
}

}  // namespace

SurfaceMesh read_stl(std::string_view bytes, const std::string& name) {
  if (is_binary(bytes)) return read_binary(bytes, name);
  if (is_ascii(bytes)) return read_ascii(bytes, name);
  if (bytes.size() < header_size) {
    throw InvalidInput("is not STL: it does not begin with \"solid\", and its " +
                           std::to_string(bytes.size()) +
                           " bytes are fewer than a binary header has",
                       name);
  }
  const std::uint64_t count = triangle_count(bytes);
  throw InvalidInput(
      "is not STL: it is not text that begins with \"solid\", and a binary file with the " +
          std::to_string(count) + " triangles that its header gives has " +
          std::to_string(header_size + facet_size * count) + " bytes, this one " +
          std::to_string(bytes.size()),
      name + ": byte 80");
}

}  // namespace tetfarm
