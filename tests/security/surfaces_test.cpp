// Files that lie: surfaces whose headers promise what no file holds, archives that unpack without
// end, results that were damaged. The built program must say what is wrong, soon and in little
// memory.
#include <sys/resource.h>
#include <zlib.h>

#include <cstring>
#include <random>

#include "base/sanitizers.h"
#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::TemporaryFolder;

constexpr int exit_failed = 1;
constexpr int exit_bad_geometry = 3;
constexpr double soon_s = 60;
[[maybe_unused]] constexpr std::uint64_t most_bytes = std::uint64_t{300} << 20U;

/// No process that this one has waited for ever held more than `most_bytes`.
void expect_little_memory() {
  if (is_sanitized) return;
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  EXPECT_LE(static_cast<std::uint64_t>(usage.ru_maxrss) << 10U, most_bytes);
}

/// A number as it lies in a file, little end first.
template <class Number>
std::string raw(Number number) {
  return std::string(reinterpret_cast<const char*>(&number), sizeof number);
}

struct LyingFile {
  const char* case_name;
  const char* file_name;
  std::string bytes;
};

void PrintTo(const LyingFile& file, std::ostream* stream) { *stream << file.case_name; }

std::vector<LyingFile> lying_files() {
  const std::string ply = "ply\nformat binary_little_endian 1.0\n";
  const std::string coordinates = "property float x\nproperty float y\nproperty float z\n";
  const std::string corners = "property list uchar int vertex_indices\nend_header\n";
  const std::string msh = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  const std::string old_msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string endless = "18446744073709551615";
  const std::string four_billion = "4294967295";
  return {
      {"stl_with_four_billion_triangles", "a.stl",
       std::string(80, ' ') + raw(std::uint32_t{0xFFFFFFFF}) + std::string(100, '\0')},
      {"stl_without_an_end", "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2"},
      {"stl_of_one_endless_line", "a.stl", "solid " + std::string(5'000'000, 'a')},
      {"off_with_endless_counts", "a.off", "OFF\n" + endless + " " + endless + " 0\n0 0 0\n"},
      {"off_with_four_billion_corners", "a.off",
       "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + four_billion + " 0 1 2\n"},
      {"off_with_a_corner_that_is_not_there", "a.off",
       "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2147483647\n"},
      {"off_with_a_negative_corner", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"},
      {"off_with_coordinates_that_are_no_numbers", "a.off",
       "OFF\n3 1 0\nnan inf 0\n1e999 0 0\n0 1 0\n3 0 1 2\n"},
      {"ply_with_endless_vertices", "a.ply",
       ply + "element vertex " + endless + "\n" + coordinates + "element face 1\n" + corners},
      {"ply_with_four_billion_faces", "a.ply",
       ply + "element vertex 1\n" + coordinates + "element face " + four_billion + "\n" + corners +
           std::string(12, '\0')},
      {"ply_with_a_list_that_is_longer_than_the_file", "a.ply",
       ply + "element vertex 1\n" + coordinates +
           "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
           std::string(12, '\0') + raw(std::uint32_t{0xFFFFFFFF})},
      {"ply_without_an_end_of_its_header", "a.ply", ply + std::string(1'000'000, 'c')},
      {"obj_with_corners_far_away", "a.obj", "v 0 0 0\nf 1 2 4294967297\nf -9 -8 -7\n"},
      {"msh_with_endless_nodes", "a.msh", msh + "$Nodes\n1 " + endless + " 1 " + endless + "\n"},
      {"msh_with_four_billion_blocks", "a.msh",
       msh + "$Elements\n" + four_billion + " " + four_billion + " 1 2\n"},
      {"old_msh_with_endless_elements", "a.msh",
       old_msh + "$Elements\n" + endless + "\n1 2 0 1 2 3\n"},
      {"old_msh_with_endless_tags", "a.msh",
       old_msh + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 2 2147483647 1 1 1\n"},
      {"ugrid_with_two_billion_nodes", "a.lb8.ugrid",
       raw(std::int32_t{0x7FFFFFFF}) + raw(std::int32_t{0x7FFFFFFF}) + std::string(20, '\0')},
      {"ugrid_with_negative_counts", "a.lb8.ugrid",
       raw(std::int32_t{-1}) + raw(std::int32_t{-1}) + std::string(20, '\0')},
      {"wide_ugrid_with_endless_counts", "a.lb8l.ugrid",
       raw(std::int64_t{0x7FFFFFFFFFFFFFFF}) + raw(std::int64_t{0x7FFFFFFFFFFFFFFF}) +
           std::string(40, '\0')},
      {"ugrid_of_text_with_endless_counts", "a.ugrid", endless + " " + endless + " 0 0 0 0 0\n"},
      {"medit_with_endless_vertices", "a.mesh",
       "MeshVersionFormatted 2\nDimension 3\nVertices\n" + endless + "\n0 0 0 0\n"},
      {"binary_medit_with_four_billion_vertices", "a.meshb",
       raw(std::int32_t{1}) + raw(std::int32_t{2}) + raw(std::int32_t{3}) + raw(std::int32_t{20}) +
           raw(std::int32_t{3}) + raw(std::int32_t{4}) + raw(std::int32_t{24}) +
           raw(std::uint32_t{0xFFFFFFFF})},
      {"binary_medit_whose_sections_lead_back", "a.meshb",
       raw(std::int32_t{1}) + raw(std::int32_t{2}) + raw(std::int32_t{3}) + raw(std::int32_t{8}) +
           raw(std::int32_t{3})},
      {"su2_with_endless_elements", "a.su2",
       "NDIME= 3\nNELEM= " + endless + "\nNPOIN= " + endless + "\nNMARK= " + endless + "\n"},
      {"tetgen_with_endless_facets", "a.poly",
       "1 3 0 0\n1 0 0 0\n" + endless + " 0\n" + endless + "\n"},
      {"fro_with_endless_counts", "a.fro", endless + " " + endless + " 1 0 0 0 0 0\n"},
      {"gzip_cut_short", "a.stl.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\0\3\1\2\3", 13)},
      {"gzip_of_nothing", "a.off.gz", std::string("\x1f\x8b", 2)},
  };
}

class LyingSurface : public ::testing::TestWithParam<LyingFile> {};

TEST_P(LyingSurface, is_refused_soon_and_in_little_memory) {
  const TemporaryFolder folder;
  test::write_contents(folder.path() / GetParam().file_name, GetParam().bytes);
  const Ended ended = test::run_program({"check", GetParam().file_name}, folder.path(), soon_s);
  EXPECT_EQ(ended.code, exit_bad_geometry) << ended.out << ended.err;
  EXPECT_NE(ended.err, "");
  expect_little_memory();
}

INSTANTIATE_TEST_SUITE_P(Security, LyingSurface, ::testing::ValuesIn(lying_files()),
                         [](const auto& lying) { return std::string(lying.param.case_name); });

TEST(Bomb, of_a_gibibyte_in_a_mebibyte_is_refused_before_it_is_unpacked) {
  const TemporaryFolder folder;
  const std::string member = (folder.path() / "member.gz").string();
  const std::string zeros(std::size_t{16} << 20U, '\0');
  gzFile packed = ::gzopen(member.c_str(), "wb9");
  ::gzwrite(packed, zeros.data(), static_cast<unsigned>(zeros.size()));
  ::gzclose(packed);
  std::string bomb;
  for (int i = 0; i < 64; ++i) bomb += test::contents(member);
  ASSERT_LT(bomb.size(), std::size_t{2} << 20U);
  test::write_contents(folder.path() / "bomb.stl.gz", bomb);
  const Ended ended = test::run_program({"check", "bomb.stl.gz"}, folder.path(), soon_s);
  EXPECT_EQ(ended.code, exit_bad_geometry) << ended.err;
  expect_little_memory();
}

/// The mesh of a small run, and what becomes of commands that read it when it is damaged.
class DamagedResult : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    ASSERT_EQ(test::run_program({"shape", "sphere-in-sphere", "-o", "s.stl"}, folder_->path()).code,
              0);
    const Ended ended = test::run_program(
        {"run", "s.stl", "-o", "out", "-j", "1", "--progress", "none"}, folder_->path());
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (const auto& file : fs::recursive_directory_iterator(folder_->path() / "out")) {
      if (file.path().extension() == ".vtkhdf") whole_ = test::contents(file.path());
    }
    ASSERT_GT(whole_.size(), 1000U);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  /// No command is ended by a signal or takes long; what they say is up to the damage.
  static void expect_survived(const std::string& bytes) {
    test::write_contents(folder_->path() / "damaged.vtkhdf", bytes);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"quality", "damaged.vtkhdf"},
          {"export", "damaged.vtkhdf", "--format", "su2", "-o", "damaged.su2"}}) {
      const Ended ended = test::run_program(words, folder_->path(), soon_s);
      EXPECT_GE(ended.code, 0) << words[0] << " hangs";
      EXPECT_LT(ended.code, 126) << words[0] << " was killed by a signal";
    }
    expect_little_memory();
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::string whole_;
};

std::unique_ptr<TemporaryFolder> DamagedResult::folder_;
std::string DamagedResult::whole_;

TEST_F(DamagedResult, that_was_cut_short_ends_no_command_by_a_signal) {
  for (const double part : {0.0, 0.01, 0.1, 0.5, 0.999}) {
    expect_survived(
        whole_.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole_.size()))));
  }
}

TEST_F(DamagedResult, with_bytes_changed_ends_no_command_by_a_signal) {
  std::mt19937 random(3);
  for (int round = 0; round < 6; ++round) {
    std::string bytes = whole_;
    for (int i = 0; i < 8; ++i) {
      // Most of the structure lies at the beginning.
      const std::size_t at = random() % (round % 2 == 0 ? 4096 : bytes.size());
      bytes[at] = static_cast<char>(random());
    }
    expect_survived(bytes);
  }
}

TEST_F(DamagedResult, that_is_another_kind_of_file_is_refused) {
  for (const std::string& bytes : {std::string(), std::string("solid a"), std::string(5000, '\0'),
                                   whole_.substr(0, 8) + std::string(5000, '\xff')}) {
    test::write_contents(folder_->path() / "other.vtkhdf", bytes);
    const Ended ended = test::run_program({"quality", "other.vtkhdf"}, folder_->path(), soon_s);
    EXPECT_TRUE(ended.code == exit_failed || ended.code == exit_bad_geometry) << ended.code;
    EXPECT_NE(ended.err, "");
  }
}

}  // namespace
}  // namespace tetfarm
