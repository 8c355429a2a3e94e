#include "mesh/assemble/numbering_file.h"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/random_numbering.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* table =
    "cut 1 10\ncut 2 20\ncut 3 30\nleaf 4 40 400 4\nleaf 5 50 500 5\njoined 6 4\nleaf 7 70 700 3\n"
    "dropped 1 2 2\ndropped 1 7 1\ndropped 5 1 19\n";

Numbering some_numbering() { return number_globally(surface_of_two_regions(), table); }

std::string old_file() {
  return read_file(std::string(TETFARM_SOURCE_DIR) +
                   "/tests/mesh/assemble/fixtures/numbering_version_1");
}

/// The content with the number at `offset` replaced, and right checksums.
template <class T>
std::string forge(std::string_view bytes, std::uint64_t offset, T value) {
  std::string content(content_of_blocks(bytes, "f"));
  std::memcpy(content.data() + offset, &value, sizeof value);
  return with_block_checksums(content);
}

// Counts of the tables come behind magic, version and five figures of the whole.
constexpr std::uint64_t figures_at = 12;
constexpr std::uint64_t counts_at = figures_at + 5 * 8;

NumberingTables tables_of(const Numbering& numbering) {
  NumberingTables tables;
  tables.others = told_layer_types(numbering.others);
  tables.unused = numbering.unused_vertices.size();
  tables.forced = numbering.forced.size();
  tables.cuts = numbering.cuts.size();
  tables.leaves = numbering.leaves.size();
  for (const CutNumbers& cut : numbering.cuts) tables.dropped += cut.nodes.dropped.size();
  for (const LeafNumbers& leaf : numbering.leaves) tables.dropped += leaf.nodes.dropped.size();
  return tables;
}

class NumberingFiles : public testing::Test {
 protected:
  NumberingFile open(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return {path_, "numbering"};
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "numbering";
};

TEST_F(NumberingFiles, answer_each_leaf_of_a_random_tree_as_the_whole_numbering_does) {
  const SurfaceMesh surface = surface_of_two_regions();
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomNumbering random(surface, seed, 1 + seed * seed / 4);
    const Numbering& numbering = random.numbering();
    NumberingFile file = open(numbering_to_bytes(numbering));
    for (int i = 0; i < 20; ++i) {
      const std::vector<Origin> nodes = random.some_nodes();
      const LeafQuestion question = {random.some_leaf(), 1 + i % 2, nodes};
      ASSERT_EQ(file.leaf(question), leaf_numbering(numbering, question)) << seed << ' ' << i;
      EXPECT_EQ(file.whole(), file.leaf(question).whole);
    }
  }
}

TEST_F(NumberingFiles, refuse_the_nodes_and_leaves_that_the_whole_numbering_refuses) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomNumbering random(surface_of_two_regions(), seed, 1 + seed);
    NumberingFile file = open(numbering_to_bytes(random.numbering()));
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
      const Origin origin = random.some_node();
      const LeafQuestion question = {random.some_leaf(), 1, std::span(&origin, 1)};
      if (random.is_node(origin)) {
        EXPECT_NO_THROW(file.leaf(question));
      } else {
        ++refused;
        EXPECT_THAT([&] { file.leaf(question); },
                    ThrowsMessage<Error>(HasSubstr("no node " + std::to_string(origin.index))));
      }
    }
    EXPECT_GT(refused, 0);
    for (const CutNumbers& cut : random.numbering().cuts) {
      EXPECT_THROW(file.leaf({cut.path, 1, {}}), Error);
    }
  }
}

TEST_F(NumberingFiles, read_whole_give_the_numbering_back) {
  const SurfaceMesh surface = surface_of_two_regions();
  for (unsigned seed = 0; seed < 60; ++seed) {
    const RandomNumbering random(surface, seed, 1 + seed * seed / 4);
    const Numbering& numbering = random.numbering();
    const std::string bytes = numbering_to_bytes(numbering);
    const Numbering again = numbering_from_bytes(bytes, "f");
    EXPECT_EQ(numbering_to_bytes(again), bytes) << seed;
    EXPECT_EQ(again.forced, numbering.forced);
    EXPECT_EQ(again.faces, meshed_sides(surface));
    EXPECT_EQ(again.regions, 2);
    EXPECT_EQ(again.nodes, numbering.nodes);
  }
}

TEST_F(NumberingFiles, are_read_in_few_blocks_by_a_leaf_however_many_leaves_there_are) {
  const SurfaceMesh surface = surface_of_two_regions();
  for (const std::size_t leaves : {100U, 10'000U}) {
    RandomNumbering random(surface, 1, leaves);
    const std::string bytes = numbering_to_bytes(random.numbering());
    NumberingFile file = open(bytes);
    std::vector<Origin> nodes;
    for (std::uint32_t v = 0; v < 40; ++v) nodes.push_back({0, v});
    file.leaf({random.some_leaf(), 1, nodes});
    EXPECT_LE(file.bytes_read(), 16 * block_size) << leaves;
    if (leaves > 1000) {
      EXPECT_GT(bytes.size(), 100 * block_size);
    }
  }
}

TEST_F(NumberingFiles, every_flipped_bit_and_every_truncation_is_refused_by_who_reads_all) {
  const std::string bytes = numbering_to_bytes(some_numbering());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    EXPECT_THROW(numbering_from_bytes(damaged, "f"), CorruptFile) << bit;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(numbering_from_bytes(bytes.substr(0, size), "f"), CorruptFile) << size;
  }
  EXPECT_THROW(numbering_from_bytes(bytes + "x", "f"), CorruptFile);
}

TEST_F(NumberingFiles, that_are_damaged_or_cut_short_are_refused_by_a_leaf) {
  const RandomNumbering random(surface_of_two_regions(), 2, 4000);
  const Numbering& numbering = random.numbering();
  const std::string bytes = numbering_to_bytes(numbering);
  const LeafNumbers& leaf = numbering.leaves.back();
  const std::uint64_t last_leaf =
      tables_of(numbering).leaves_at() + (numbering.leaves.size() - 1) * 64;
  EXPECT_NO_THROW(open(bytes).leaf({leaf.path, 1, {}}));
  std::string damaged = bytes;
  damaged[last_leaf + 40] ^= 1;
  EXPECT_THROW(open(damaged).leaf({leaf.path, 1, {}}), CorruptFile);
  EXPECT_NO_THROW(open(damaged).leaf({numbering.leaves.front().path, 1, {}})) << "elsewhere";
  for (std::size_t size = 0; size < bytes.size(); size += 5003) {
    EXPECT_THROW(open(bytes.substr(0, size)), CorruptFile) << size;
  }
}

TEST_F(NumberingFiles, with_tables_that_are_not_those_of_their_text_are_refused_by_who_reads_all) {
  const Numbering numbering = some_numbering();
  const std::string bytes = numbering_to_bytes(numbering);
  const NumberingTables tables = tables_of(numbering);
  for (std::uint64_t at = figures_at; at < tables.text_at(); at += 4) {
    const bool is_figure_of_surface = at >= figures_at + 16 && at < figures_at + 32;
    const bool is_forced = at >= tables.forced_at() && at < tables.cuts_at();
    if (is_figure_of_surface || is_forced) continue;  // of which the text says nothing
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    EXPECT_THROW(numbering_from_bytes(forge(bytes, at, value + 1), "f"), CorruptFile) << at;
  }
}

/// Pyramids and prisms beside some tets.
constexpr const char* table_with_layers =
    "cut 1 10\ncut 2 20\ncut 3 0\nleaf 4 40 400 4\nleaf 5 50 500 5\nleaf 6 8 9 1 60 600\n"
    "leaf 7 70 700 3 70 7\ndropped 2 2 2\ndropped 5 1 19\n";

/// And quads where layers run in planes: of one chunk, another has none.
constexpr const char* table_with_sides =
    "cut 1 10\ncut 2 20\ncut 3 0\nleaf 4 40 400 4\nleaf 5 50 500 5\nleaf 6 8 9 1 60 600 66\n"
    "leaf 7 70 700 3 70 7\ndropped 2 2 2\ndropped 5 1 19\n";

TEST_F(NumberingFiles, of_a_mesh_without_layers_have_the_bytes_that_they_always_had) {
  std::uint32_t version = 0;
  for (const auto& [lines, expected] :
       {std::pair{table, 2U}, {table_with_layers, 3U}, {table_with_sides, 4U}}) {
    const Numbering numbering = number_globally(surface_of_two_regions(), lines);
    const std::string bytes = numbering_to_bytes(numbering);
    std::memcpy(&version, bytes.data() + 8, sizeof version);
    EXPECT_EQ(version, expected);
    EXPECT_EQ(tables_of(numbering).leaves_at() % 4, 0U);
  }
}

TEST_F(NumberingFiles, with_layers_are_refused_where_a_byte_is_another_by_who_reads_all) {
  for (const char* lines : {table_with_layers, table_with_sides}) {
    const std::string bytes = numbering_to_bytes(number_globally(surface_of_two_regions(), lines));
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 1);
      EXPECT_THROW(numbering_from_bytes(damaged, "f"), CorruptFile) << at;
    }
    for (std::size_t size = 0; size < bytes.size(); size += 3) {
      EXPECT_THROW(numbering_from_bytes(bytes.substr(0, size), "f"), CorruptFile) << size;
    }
  }
}

TEST_F(NumberingFiles, tell_a_leaf_of_its_quads_and_of_those_before) {
  const Numbering numbering = number_globally(surface_of_two_regions(), table_with_sides);
  NumberingFile file = open(numbering_to_bytes(numbering));
  EXPECT_EQ(file.whole().others[ElementType::quad], 66);
  for (const std::uint64_t heap : {4U, 5U, 6U, 7U}) {
    const LeafQuestion question = {{heap}, 1, {}};
    EXPECT_EQ(file.leaf(question), leaf_numbering(numbering, question)) << heap;
  }
  EXPECT_EQ(file.leaf({{6}, 1, {}}).others[ElementType::quad], 66);
  EXPECT_EQ(file.leaf({{7}, 1, {}}).others[ElementType::quad], 0);
  EXPECT_EQ(file.leaf({{7}, 1, {}}).first_other[ElementType::quad], 66);
  EXPECT_EQ(file.leaf({{7}, 1, {}}).first_other[ElementType::prism], 600);
}

class LyingNumbering : public NumberingFiles, public testing::WithParamInterface<const char*> {};

TEST_P(LyingNumbering, never_breaks_a_leaf) {
  const Numbering numbering = number_globally(surface_of_two_regions(), GetParam());
  const std::string bytes = numbering_to_bytes(numbering);
  const std::vector<Origin> nodes = {{0, 3}, {1, 4}, {1, 9}, {2, 5}, {5, 40}, {5, 0}, {7, 1}};
  const auto ask = [&](const std::string& forged) {
    try {
      NumberingFile file = open(forged);
      for (const std::uint64_t leaf : {4U, 5U, 7U}) {
        const LeafNumbering answer = file.leaf({{leaf}, 1, nodes});
        EXPECT_EQ(answer.node_numbers.size(), nodes.size());
        EXPECT_GE(answer.kept_nodes, 0);
      }
    } catch (const Error&) {
      return;
    }
  };
  for (std::uint64_t at = figures_at; at < tables_of(numbering).text_at(); at += 8) {
    for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{7}, std::uint64_t{1} << 40,
                                      std::uint64_t{0x7fffffffffffffff}, ~std::uint64_t{0}}) {
      ask(forge(bytes, at, value));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(NumberingFiles, LyingNumbering,
                         testing::Values(table, table_with_layers, table_with_sides));

TEST_F(NumberingFiles, with_impossible_counts_are_refused) {
  const Numbering numbering = some_numbering();
  const std::string bytes = numbering_to_bytes(numbering);
  for (std::uint64_t field = 0; field < 10; ++field) {
    EXPECT_THROW(open(forge(bytes, figures_at + 8 * field, ~std::uint64_t{0})), CorruptFile)
        << field;
  }
  for (std::uint64_t field = 0; field < 5; ++field) {
    EXPECT_THROW(open(forge(bytes, counts_at + 8 * field, std::uint64_t{1'000'000})), CorruptFile)
        << field;
  }
  const std::uint64_t leaf = tables_of(numbering).leaves_at();
  for (const std::uint64_t place : {1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
    EXPECT_THROW(open(forge(bytes, leaf + 8 * place, std::uint64_t{1} << 62)).leaf({{4}, 1, {}}),
                 CorruptFile)
        << place;
  }
}

TEST_F(NumberingFiles, of_another_kind_are_called_that) {
  EXPECT_THAT([] { numbering_from_bytes("something else", "store/x"); },
              ThrowsMessage<CorruptFile>(
                  HasSubstr("store/x: does not begin like the expected kind of file")));
  EXPECT_THROW(open(old_file()), CorruptFile) << "a text has no tables";
}

/// As the version before wrote it.
TEST(NumberingText, of_an_earlier_version_is_read_whole) {
  const std::string text = old_file();
  EXPECT_TRUE(is_numbering_text(text));
  const Numbering numbering = numbering_from_bytes(text, "old");
  EXPECT_EQ(numbering_to_text(numbering), text);
  EXPECT_EQ(numbering.leaves.size(), 16U);
  EXPECT_EQ(numbering.surface_nodes, 52);
  EXPECT_EQ(numbering.nodes, 10184);
  EXPECT_EQ(numbering.tets, 57210);
  EXPECT_EQ(numbering.leaves.back().first_face, 96);
  const std::string bytes = numbering_to_bytes(numbering);
  EXPECT_FALSE(is_numbering_text(bytes));
  EXPECT_EQ(numbering_to_text(numbering_from_bytes(bytes, "new")), text);
}

TEST_F(NumberingFiles, without_a_leaf_or_with_forced_nodes_out_of_order_are_refused) {
  Numbering numbering = some_numbering();
  numbering.forced = {{2, 1}, {3, 1}};
  const std::string bytes = numbering_to_bytes(numbering);
  const std::uint64_t forced_at = tables_of(numbering).forced_at();
  EXPECT_EQ(numbering_from_bytes(bytes, "n").forced, numbering.forced);
  const std::string turned =
      forge(forge(bytes, forced_at, ForcedNode{3, 1}), forced_at + 8, ForcedNode{2, 1});
  EXPECT_THAT([&] { numbering_from_bytes(turned, "n"); },
              ThrowsMessage<CorruptFile>("n: has tables that are not those of its text"));
  EXPECT_THAT([&] { open(forge(bytes, counts_at + 24, std::uint64_t{0})); },
              ThrowsMessage<CorruptFile>("numbering: has no leaf or no region"));
  // Cut 1 drops node 7 of 10, here of 7.
  const std::string fewer = forge(bytes, tables_of(numbering).cuts_at() + 8, std::int64_t{7});
  const std::vector<Origin> asked = {{1, 6}};
  EXPECT_THAT(
      [&] {
        open(fewer).leaf({{4}, 1, asked});
      },
      ThrowsMessage<CorruptFile>("numbering: drops nodes that do not exist"));
}

}  // namespace
}  // namespace tetfarm
