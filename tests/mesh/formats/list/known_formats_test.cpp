#include "mesh/formats/list/known_formats.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <string>

#include "base/file_system.h"
#include "mesh/formats/list/all_formats.h"
#include "mesh/formats/list/format_by_ending.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/surfaces/surface_formats.h"

namespace tetfarm {
namespace {

using ::testing::ContainerEq;
using ::testing::HasSubstr;

using Words = std::set<std::string>;
using IsWanted = bool (*)(const Format& format);

bool reads_surfaces(const Format& format) { return format.read_surface != nullptr; }
bool reads_meshes(const Format& format) { return format.open_mesh != nullptr; }
bool writes_meshes(const Format& format) { return format.write_mesh != nullptr; }

Words endings_of(IsWanted is_wanted) {
  Words endings;
  for (const Format& format : all_formats) {
    if (!is_wanted(format)) continue;
    for (const std::string_view ending : format.endings) {
      if (!ending.empty()) endings.emplace(ending);
    }
  }
  return endings;
}

TEST(KnownFormats, are_all_formats_with_what_can_be_done_with_each) {
  const std::span<const KnownFormat> known = known_formats();
  ASSERT_EQ(known.size(), all_formats.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const Format& format = all_formats[i];
    SCOPED_TRACE(format.name);
    EXPECT_EQ(known[i].name, format.name);
    EXPECT_EQ(known[i].reads_surfaces, format.read_surface != nullptr);
    EXPECT_EQ(known[i].writes_surfaces, format.write_surface != nullptr);
    EXPECT_EQ(known[i].reads_meshes, format.open_mesh != nullptr);
    EXPECT_EQ(known[i].writes_meshes, format.write_mesh != nullptr);
  }
}

TEST(AllFormats, have_a_name_each_and_say_what_they_are) {
  Words names;
  for (const Format& format : all_formats) {
    EXPECT_TRUE(names.emplace(format.name).second) << format.name;
    EXPECT_FALSE(format.what.empty()) << format.name;
    const bool can_be_used = format.read_surface != nullptr || format.open_mesh != nullptr ||
                             format.write_surface != nullptr || format.write_mesh != nullptr;
    EXPECT_TRUE(can_be_used) << format.name;
  }
}

TEST(AllFormats, are_each_told_by_their_endings_and_no_two_by_the_same) {
  for (const IsWanted is_wanted : {reads_surfaces, reads_meshes, writes_meshes}) {
    for (const Format& format : all_formats) {
      if (!is_wanted(format)) continue;
      for (const std::string_view ending : format.endings) {
        if (ending.empty()) continue;
        const Format* told = format_by_ending(all_formats, "a" + std::string(ending), is_wanted);
        ASSERT_NE(told, nullptr) << ending;
        EXPECT_EQ(told->name, format.name) << ending;
      }
    }
  }
}

TEST(AllFormats, that_are_files_have_an_ending_and_those_that_are_folders_none) {
  for (const Format& format : written_formats()) {
    EXPECT_EQ(format.written_ending().empty(), format.layout == FormatLayout::folder)
        << format.name;
  }
  for (const Format& format : all_formats) {
    EXPECT_EQ(format.folders.empty(), format.is_mesh_folder == nullptr) << format.name;
  }
}

TEST(FormatByEnding, is_that_of_the_longest_ending) {
  EXPECT_EQ(format_by_ending(all_formats, "a.b8.ugrid", reads_surfaces)->name, "b8.ugrid");
  EXPECT_EQ(format_by_ending(all_formats, "a.ugrid", reads_surfaces)->name, "ugrid");
  EXPECT_EQ(format_by_ending(all_formats, "a.lb8l.ugrid", writes_meshes)->name, "lb8l.ugrid");
  EXPECT_EQ(format_by_ending(all_formats, "a.ugrid", writes_meshes), nullptr);
  EXPECT_EQ(format_by_ending(all_formats, "", writes_meshes), nullptr);
}

TEST(SurfaceFormats, keep_nothing_that_only_meshes_need) {
  for (const Format& format : surface_formats()) {
    EXPECT_EQ(format.open_mesh, nullptr) << format.name;
    EXPECT_EQ(format.write_mesh, nullptr) << format.name;
  }
  EXPECT_THAT(readable_surfaces(), HasSubstr(".ply .ugrid .msh .su2"));
  EXPECT_THAT(writable_surfaces(), HasSubstr(".stl (with patches) or .off (without)"));
}

/// docs/file_formats.md, whose tables say what is known of the formats.
class FormatsInDocs : public testing::Test {
 protected:
  /// The cells of the rows of the first table below a heading.
  std::vector<std::vector<std::string>> table_below(const std::string& heading) const {
    std::vector<std::vector<std::string>> rows;
    std::size_t at = text_.find("\n" + heading + "\n");
    EXPECT_NE(at, std::string::npos) << heading;
    at = text_.find("\n|---", at);
    at = text_.find('\n', at + 1) + 1;
    for (; text_[at] == '|'; at = text_.find('\n', at) + 1) {
      std::vector<std::string>& row = rows.emplace_back();
      const std::size_t end = text_.find('\n', at);
      for (std::size_t cell = at + 2; cell < end;) {
        const std::size_t next = text_.find(" |", cell);
        row.push_back(text_.substr(cell, next - cell));
        cell = next + 3;
      }
    }
    return rows;
  }

  /// What stands in `code` in the first cells and begins with a dot.
  static Words endings_in(const std::vector<std::vector<std::string>>& rows) {
    Words endings;
    for (const std::vector<std::string>& row : rows) {
      std::size_t at = 0;
      while ((at = row[0].find('`', at)) != std::string::npos) {
        const std::size_t end = row[0].find('`', at + 1);
        if (row[0][at + 1] == '.') endings.insert(row[0].substr(at + 1, end - at - 1));
        at = end + 1;
      }
    }
    return endings;
  }

 private:
  const std::string text_ = read_file(TETFARM_SOURCE_DIR "/docs/file_formats.md");
};

TEST_F(FormatsInDocs, have_a_row_for_every_ending_of_surfaces) {
  EXPECT_THAT(endings_in(table_below("## Surfaces that are read")),
              ContainerEq(endings_of(reads_surfaces)));
}

TEST_F(FormatsInDocs, have_a_row_for_every_ending_of_meshes) {
  EXPECT_THAT(endings_in(table_below("## Meshes that are read")),
              ContainerEq(endings_of(reads_meshes)));
}

std::string in_code(std::string_view word) {
  return word.empty() ? "—" : "`" + std::string(word) + "`";
}

TEST_F(FormatsInDocs, have_a_row_for_every_format_that_is_written_with_what_it_holds) {
  std::vector<std::vector<std::string>> wanted;
  for (const Format& format : written_formats()) {
    wanted.push_back({in_code(format.name), in_code(format.endings[0]),
                      format.layout == FormatLayout::one_file        ? "one file"
                      : format.layout == FormatLayout::several_files ? "several files"
                                                                     : "a folder",
                      std::to_string(format.integer_bits),
                      format.cells == FormatCells::all ? "all" : "tetrahedra",
                      format.holds_parts ? "yes" : "no"});
  }
  auto rows = table_below("## Other formats");
  for (std::vector<std::string>& row : rows) row.resize(wanted[0].size());
  EXPECT_THAT(rows, ContainerEq(wanted));
}

}  // namespace
}  // namespace tetfarm
