#include "mesh/formats/medit/medit_file.h"

#include <cmath>
#include <cstring>

namespace tetfarm {

MeditFile::MeditFile(const std::filesystem::path& path) : file_(path) { find_lists(); }

MeditFile::MeditFile(std::string_view bytes, const std::string& name, medit::World world)
    : file_(bytes, name), world_(world) {
  find_lists();
}

std::int64_t MeditFile::count(medit::Keyword list) const {
  const auto found = lists_.find(list);
  return found == lists_.end() ? 0 : found->second.count;
}

void MeditFile::find_lists() {
  const auto mark = file_.at<std::int32_t>(0);
  is_turned_ = mark == 0x01000000;
  if (mark != 1 && !is_turned_) file_.fail("is not a Medit file: it begins like neither form", 0);
  version_ = integer_at(4, 4);
  if (version_ < 1 || version_ > 4) {
    file_.fail("version " + std::to_string(version_) + " is not supported; 1 to 4 are", 4);
  }
  std::int64_t place = 8;
  while (place != 0 && place != file_.size()) place = read_keyword(place);
}

/// Returns where the next keyword is; 0 after the last.
std::int64_t MeditFile::read_keyword(std::int64_t place) {
  const auto keyword = static_cast<medit::Keyword>(integer_at(place, 4));
  if (keyword == medit::end) return 0;
  const std::int64_t next = integer_at(place + 4, place_bytes());
  if (next != 0 && (next <= place || next > file_.size())) {
    file_.fail("a list gives a wrong place for the next: byte " + std::to_string(next), place + 4);
  }
  const std::int64_t content = place + 4 + place_bytes();
  const std::int64_t end = next == 0 ? file_.size() : next;
  if (keyword == medit::dimension) {
    if (content + 4 > end) file_.fail("a list runs past the beginning of the next", place);
    read_dimension(content);
  } else if (record_bytes(keyword) > 0 ||
             (keyword == medit::fields_at_vertices && world_ == medit::World::plane)) {
    add_list(keyword, content, end);
  }
  return next;
}

void MeditFile::read_dimension(std::int64_t place) {
  dimension_ = integer_at(place, 4);
  if (dimension_ == 3) return;
  if (world_ == medit::World::space) file_.fail(std::string(medit::not_of_space), place);
  if (dimension_ != 2) file_.fail("the dimension is neither 2 nor 3", place);
}

std::int64_t MeditFile::read_kinds(std::int64_t place) {
  const std::int64_t fields = integer_at(place, 4);
  if (fields < 1 || fields > file_.size() / 4) file_.fail("a wrong number of fields", place);
  if (!kinds_.empty()) file_.fail("a second list of fields", place);
  for (std::int64_t k = 1; k <= fields; ++k) {
    const std::int64_t kind = integer_at(place + 4 * k, 4);
    if (kind < 1 || kind > 3) {
      file_.fail("a field is a number (1), a vector (2) or a symmetric tensor (3)", place + 4 * k);
    }
    kinds_.push_back(kind);
    reals_of_fields_ += kind;  // in the plane: 1, 2 and 3 numbers
  }
  return place + 4 + 4 * fields;
}

void MeditFile::add_list(medit::Keyword keyword, std::int64_t place, std::int64_t next) {
  List list{place + integer_bytes(), integer_at(place, integer_bytes())};
  if (keyword == medit::fields_at_vertices) {
    if (dimension_ != 2) file_.fail("the fields are not those of a plane mesh", place);
    list.place = read_kinds(list.place);
  }
  if (list.count < 0 || list.count > (file_.size() - list.place) / record_bytes(keyword)) {
    file_.fail("a count of " + std::to_string(list.count) + ", but the file has only " +
                   std::to_string(file_.size()) + " bytes",
               place);
  }
  if (list.place + list.count * record_bytes(keyword) > next) {
    file_.fail("a list runs past the beginning of the next", place);
  }
  if (!lists_.emplace(keyword, list).second) {
    file_.fail("a second list of the same kind (" + std::to_string(keyword) + ")", place);
  }
}

std::int64_t MeditFile::record_bytes(medit::Keyword list) const {
  switch (list) {
    case medit::vertices:
      return dimension_ * real_bytes() + integer_bytes();
    case medit::edges:
      return world_ == medit::World::plane ? 3 * integer_bytes() : 0;
    case medit::corners:
      return world_ == medit::World::plane ? integer_bytes() : 0;
    case medit::fields_at_vertices:
      return reals_of_fields_ * real_bytes();
    case medit::triangles:
      return 4 * integer_bytes();
    case medit::quadrangles:
    case medit::tetrahedra:
      return 5 * integer_bytes();
    case medit::pyramids:
      return 6 * integer_bytes();
    case medit::prisms:
      return 7 * integer_bytes();
    case medit::hexahedra:
      return 9 * integer_bytes();
    default:
      return 0;
  }
}

std::int64_t MeditFile::integer_at(std::int64_t place, std::int64_t bytes) const {
  if (bytes == 8) {
    std::array<std::int64_t, 1> wide{file_.at<std::int64_t>(place)};
    if (is_turned_) turn_bytes(std::span<std::int64_t>(wide));
    return wide[0];
  }
  std::array<std::int32_t, 1> narrow{file_.at<std::int32_t>(place)};
  if (is_turned_) turn_bytes(std::span<std::int32_t>(narrow));
  return narrow[0];
}

void MeditFile::read_integers(std::int64_t place, std::span<std::int64_t> into) const {
  if (integer_bytes() == 8) {
    file_.read(place, into.data(), into.size_bytes());
    if (is_turned_) turn_bytes(into);
    return;
  }
  std::vector<std::int32_t> numbers(into.size());
  file_.read(place, numbers.data(), 4 * numbers.size());
  if (is_turned_) turn_bytes(std::span(numbers));
  std::copy(numbers.begin(), numbers.end(), into.begin());
}

void MeditFile::read_vertices(std::int64_t first, std::span<Vec3> into) const {
  if (into.empty()) return;
  const std::int64_t bytes_each = record_bytes(medit::vertices);
  const std::int64_t place = lists_.at(medit::vertices).place + first * bytes_each;
  std::string bytes(into.size() * static_cast<std::size_t>(bytes_each), '\0');
  file_.read(place, bytes.data(), bytes.size());
  const char* next = bytes.data();
  for (std::size_t i = 0; i < into.size(); ++i) {
    std::array<double, 3> p{};
    const auto coordinates = std::span(p).first(static_cast<std::size_t>(dimension_));
    take_reals(next, coordinates);
    for (const double x : coordinates) {
      if (!std::isfinite(x)) {
        fail_at(medit::vertices, first + static_cast<std::int64_t>(i),
                "a coordinate is " + std::to_string(x));
      }
    }
    into[i] = {p[0], p[1], p[2]};
    next += bytes_each;
  }
}

void MeditFile::read_fields(std::int64_t first, std::span<double> into) const {
  if (into.empty()) return;
  const std::int64_t bytes_each = record_bytes(medit::fields_at_vertices);
  std::string bytes(into.size() * static_cast<std::size_t>(real_bytes()), '\0');
  file_.read(lists_.at(medit::fields_at_vertices).place + first * bytes_each, bytes.data(),
             bytes.size());
  take_reals(bytes.data(), into);
  for (std::size_t i = 0; i < into.size(); ++i) {
    if (std::isfinite(into[i])) continue;
    fail_at(medit::fields_at_vertices, first + static_cast<std::int64_t>(i) / reals_of_fields_,
            "a number is " + std::to_string(into[i]));
  }
}

void MeditFile::take_reals(const char* bytes, std::span<double> into) const {
  if (real_bytes() == 8) {
    std::memcpy(into.data(), bytes, into.size_bytes());
    if (is_turned_) turn_bytes(into);
    return;
  }
  for (double& value : into) {
    std::array<float, 1> narrow;
    std::memcpy(narrow.data(), bytes, sizeof narrow);
    if (is_turned_) turn_bytes(std::span<float>(narrow));
    value = narrow[0];
    bytes += sizeof narrow;
  }
}

void MeditFile::fail_at(medit::Keyword list, const std::string& what) const {
  file_.fail(what, lists_.at(list).place - integer_bytes());
}

void MeditFile::fail_at(medit::Keyword list, std::int64_t record, const std::string& what) const {
  file_.fail(what, lists_.at(list).place + record * record_bytes(list));
}

}  // namespace tetfarm
