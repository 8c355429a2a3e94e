#include <gmock/gmock.h>

#include "mesh/formats/msh/write_msh22.h"
#include "mesh/formats/msh/write_msh41.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

/// Reads $Nodes and $Elements of a 4.1 file into `mesh`; `patch_of` tells the patch of an entity.
template <class PatchOf>
void read_41(const std::string& bytes, bool is_text, std::map<std::int64_t, Vec3>& nodes,
             std::vector<std::pair<std::int64_t, std::array<std::int64_t, 4>>>& tets,
             std::vector<std::pair<std::int64_t, std::array<std::int64_t, 3>>>& faces,
             const PatchOf& patch_of) {
  FileNumbers file(bytes, is_text);
  file.skip_past("$Nodes\n");
  EXPECT_EQ(file.larges<4>()[0], 1);
  for (int i = 0; i < 3; ++i) file.small();
  std::vector<std::int64_t> tags(static_cast<std::size_t>(file.large()));
  for (std::int64_t& tag : tags) tag = file.large();
  for (const std::int64_t tag : tags) nodes[tag] = file.point();
  file.skip_past("$Elements\n");
  for (std::int64_t block = file.larges<4>()[0]; block > 0; --block) {
    const std::int64_t dimension = file.small();
    const std::int64_t entity = file.small();
    EXPECT_EQ(file.small(), dimension == 2 ? 2 : 4);
    for (std::int64_t i = file.large(); i > 0; --i) {
      const std::int64_t number = file.large();
      if (dimension == 3) {
        tets.emplace_back(number, file.larges<4>());
      } else {
        faces.emplace_back(patch_of(entity), file.larges<3>());
      }
    }
  }
  file.skip_past("$EndElements\n");
}

template <class Tets, class Faces>
MeshContent content_from(const std::map<std::int64_t, Vec3>& nodes, const Tets& tets,
                         const Faces& faces) {
  ReadMesh mesh(1);
  for (const auto& [tag, p] : nodes) mesh.node(p);
  for (const auto& [number, corners] : tets) mesh.tet(corners);
  for (const auto& [patch, corners] : faces) mesh.face(corners, patch);
  return content_of(mesh);
}

struct Lists {
  std::map<std::int64_t, Vec3> nodes;
  std::vector<std::pair<std::int64_t, std::array<std::int64_t, 4>>> tets;
  std::vector<std::pair<std::int64_t, std::array<std::int64_t, 3>>> faces;
};

TEST(WriteMsh41, text_and_binary_have_the_same_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  for (const std::string format : {"msh41", "msh41-text"}) {
    Lists lists;
    read_41(read_file(export_as(grid, folder, format, "a.msh")), format != "msh41", lists.nodes,
            lists.tets, lists.faces, [](std::int64_t entity) { return entity - 1; });
    EXPECT_EQ(content_from(lists.nodes, lists.tets, lists.faces), content_of(grid)) << format;
  }
}

TEST(WriteMsh41, the_reader_of_surfaces_finds_patches_by_name) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  for (const std::string format : {"msh41", "msh41-text", "msh22"}) {
    const SurfaceMesh surface = read_surface(export_as(grid, folder, format, "a.msh"));
    EXPECT_EQ(surface.triangles.size(), 192u) << format;
    EXPECT_THAT(surface.patch_names, testing::UnorderedElementsAre("low x", "elsewhere"));
    EXPECT_NEAR(enclosed_volume(surface.vertices, surface.triangles), 1, 1e-12);
  }
}

/// Of a split file: numbers and corners of its tets, and of those of other partitions.
using TetList = std::vector<std::pair<std::int64_t, std::array<std::int64_t, 4>>>;
struct SplitFile {
  std::map<std::int64_t, Vec3> nodes;
  TetList tets;
  TetList ghosts;
  std::vector<std::pair<std::int64_t, std::array<std::int64_t, 3>>> faces;
  std::map<std::int64_t, std::int64_t> owner_of_ghost;
};

SplitFile read_split(const std::filesystem::path& path, int partition, bool has_ghosts) {
  const std::string bytes = read_file(path);
  SplitFile split;
  TetList all;
  read_41(bytes, false, split.nodes, all, split.faces,
          [partition](std::int64_t entity) { return entity - 2 * partition - 1; });
  FileNumbers file(bytes, false);
  file.skip_past("$PartitionedEntities\n");
  EXPECT_EQ(file.large(), 3);
  EXPECT_EQ(file.large(), has_ghosts ? 1 : 0) << "entities of ghosts";
  split.tets = all;
  if (!has_ghosts) return split;
  EXPECT_EQ(file.small(), 4 + partition) << "behind the volumes 1 to 4";
  EXPECT_EQ(file.small(), partition);
  file.skip_past("$GhostElements\n");
  for (std::int64_t i = file.large(); i > 0; --i) {
    const std::int64_t number = file.large();
    split.owner_of_ghost[number] = file.small();
    EXPECT_EQ(file.large(), 1);
    EXPECT_EQ(file.small(), partition);
  }
  file.skip_past("$EndGhostElements\n");
  split.tets.clear();
  for (const auto& tet : all) {
    (split.owner_of_ghost.count(tet.first) > 0 ? split.ghosts : split.tets).push_back(tet);
  }
  return split;
}

TEST(WriteMsh41, split_files_have_as_ghosts_what_others_have_at_their_nodes) {
  const TempFolder folder;
  export_as(GridSource(cut_grid(4)), folder, "msh41-ghosts", "a.msh");
  std::vector<SplitFile> files;
  for (const int i : {1, 2, 3}) {
    files.push_back(read_split(folder.path() / ("a_" + std::to_string(i) + ".msh"), i, true));
  }
  for (std::size_t here = 0; here < 3; ++here) {
    std::set<std::int64_t> own;
    for (const auto& tet : files[here].tets) own.insert(tet.second.begin(), tet.second.end());
    TetList wanted;
    std::map<std::int64_t, std::int64_t> owners;
    for (std::size_t there = 0; there < 3; ++there) {
      if (there == here) continue;
      for (const auto& tet : files[there].tets) {
        if (std::none_of(tet.second.begin(), tet.second.end(),
                         [&](std::int64_t v) { return own.count(v) > 0; })) {
          continue;
        }
        wanted.push_back(tet);
        owners[tet.first] = static_cast<std::int64_t>(there) + 1;
        for (const std::int64_t v : tet.second) {
          EXPECT_EQ(files[here].nodes.at(v), files[there].nodes.at(v));
        }
      }
    }
    EXPECT_GT(wanted.size(), 50u);
    EXPECT_EQ(files[here].ghosts, wanted);
    EXPECT_EQ(files[here].owner_of_ghost, owners);
  }
}

TEST(WriteMsh41, split_files_together_are_the_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  export_as(grid, folder, "msh41-split", "a.msh");
  Lists lists;
  for (const int i : {1, 2, 3}) {
    const SplitFile file =
        read_split(folder.path() / ("a_" + std::to_string(i) + ".msh"), i, false);
    lists.nodes.insert(file.nodes.begin(), file.nodes.end());
    lists.tets.insert(lists.tets.end(), file.tets.begin(), file.tets.end());
    lists.faces.insert(lists.faces.end(), file.faces.begin(), file.faces.end());
  }
  EXPECT_EQ(lists.nodes.size(), 125u);
  std::set<std::int64_t> numbers;
  for (const auto& tet : lists.tets) numbers.insert(tet.first);
  EXPECT_EQ(numbers.size(), 384u) << "element numbers are those of the whole mesh";
  EXPECT_EQ(content_from(lists.nodes, lists.tets, lists.faces), content_of(grid));
}

TEST(WriteMsh22, has_the_same_mesh_and_its_partitions) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  FileNumbers file(read_file(export_as(grid, folder, "msh22", "a.msh")), true);
  ReadMesh mesh(1);
  file.skip_past("$Nodes\n");
  for (std::int64_t i = 1, nodes = file.large(); i <= nodes; ++i) {
    EXPECT_EQ(file.large(), i);
    mesh.node(file.point());
  }
  file.skip_past("$Elements\n");
  std::map<std::int64_t, std::int64_t> tets_of_partition;
  for (std::int64_t i = 1, elements = file.large(); i <= elements; ++i) {
    EXPECT_EQ(file.large(), i);
    if (file.large() == 2) {
      const auto tags = file.larges<3>();
      mesh.face(file.larges<3>(), tags[1] - 1);
    } else {
      ++tets_of_partition[file.larges<5>()[4]];
      mesh.tet(file.larges<4>());
    }
  }
  EXPECT_EQ(content_of(mesh), content_of(grid));
  ASSERT_EQ(tets_of_partition.size(), 3u);
  EXPECT_EQ(tets_of_partition[2], std::ssize(grid.parts[1].tets));
}

}  // namespace
}  // namespace tetfarm
