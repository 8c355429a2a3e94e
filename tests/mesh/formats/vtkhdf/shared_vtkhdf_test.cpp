#include "mesh/formats/vtkhdf/shared_vtkhdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"
#include "mesh/formats/vtkhdf/vtkhdf_source.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"
#include "mesh/quality/mesh_check.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/cut_grid.h"
#include "tests/mesh/assemble/hybrid_core.h"

namespace tetfarm {
namespace {

/// A grid whose parts are written to one file, by hand.
class SharedVtkhdfFile : public testing::Test {
 protected:
  SharedVtkhdfFile() {
    count_faces();
    for (const LeafNumbers& leaf : numbering_.leaves) parts_.push_back(grid_.reader()(leaf).part);
    const auto writer = write_vtkhdf(folder_.path() / "alone", grid_.counts(),
                                     {grid_.surface.patch_names, grid_.surface.region_names});
    for (const NumberedPart& part : parts_) writer->add(part);
    writer->finish();
  }

  void count_faces() {
    std::int64_t next = 0;
    for (LeafNumbers& leaf : numbering_.leaves) {
      leaf.faces = std::ssize(grid_.reader()(leaf).part.faces);
      leaf.first_face = next;
      next += *leaf.faces;
    }
  }

  std::vector<FileRange> place(std::size_t part) {
    return place_cells(file_, parts_[part], leaf(part), names_);
  }

  LeafNumbering leaf(std::size_t part) const {
    return leaf_numbering(numbering_, {numbering_.leaves.at(part).path, 1, {}});
  }

  enum class PlacedTets { stay_away, come_too };

  /// Finishes the file; the parts that are in `placed` need no tets. How many were read whole.
  int finish(const std::map<std::size_t, std::vector<FileRange>>& placed,
             PlacedTets tets = PlacedTets::stay_away) {
    int read = 0;
    SharedVtkhdf shared(file_, grid_.counts(), names_, [&](std::size_t part) {
      ++read;
      return parts_[part];
    });
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      NumberedPart part = parts_[i];
      const auto found = placed.find(i);
      const bool is_placed = found != placed.end() && shared.takes(i, found->second);
      if (is_placed && tets == PlacedTets::stay_away) part.tets.clear();
      shared.add(part);
    }
    shared.finish();
    EXPECT_EQ(shared.finished().hash, hash128(result()));
    EXPECT_EQ(shared.finished().size, std::ssize(result()));
    return read;
  }

  void damage(std::int64_t place) {
    std::string bytes = result();
    char& byte = bytes.at(static_cast<std::size_t>(place));
    byte = static_cast<char>(byte ^ 1);
    write_file_atomically(file_.path, bytes);
  }

  std::string result() { return read_file(file_.path); }
  std::string alone() { return read_file(folder_.path() / "alone"); }

  CutGrid grid_ = cut_grid(5);
  Numbering numbering_ = grid_.numbering();
  VtkhdfNames names_ = {grid_.surface.patch_names, grid_.surface.region_names};
  std::vector<NumberedPart> parts_;
  TempFolder folder_;
  SharedFile file_ = {folder_.path() / "shared", folder_.path() / "frame"};
};

TEST_F(SharedVtkhdfFile, has_the_bytes_of_one_that_was_written_alone) {
  const auto last = place(2);
  const auto first = place(0);
  const auto middle = place(1);
  EXPECT_EQ(finish({{0, first}, {1, middle}, {2, last}}), 0);
  EXPECT_EQ(result(), alone());
  EXPECT_FALSE(std::filesystem::exists(file_.scratch));
}

TEST_F(SharedVtkhdfFile, has_the_feet_of_nodes_that_come_with_the_rest_of_the_part) {
  names_.has_feet = true;
  const auto first = place(0);
  for (std::size_t v = 0; v < parts_[0].nodes.size(); ++v) {
    parts_[0].feet.add(parts_[0].local2global[v], static_cast<std::int32_t>(v));
  }
  damage(first.front().offset + 20);
  EXPECT_EQ(finish({{0, first}}), 1) << "places of cells depend on how many nodes there are";
  const auto read = open_vtkhdf(file_.path, {});
  EXPECT_EQ(read->part(0).feet, parts_[0].feet);
  EXPECT_EQ(read->part(1).feet.foot.front(), no_foot);
  const auto writer = write_vtkhdf(folder_.path() / "alone", grid_.counts(), names_);
  for (const NumberedPart& part : parts_) writer->add(part);
  writer->finish();
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, nobody_need_have_placed_anything) {
  EXPECT_EQ(finish({}), 0);
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, what_was_lost_or_damaged_is_written_again) {
  const auto first = place(0);
  const auto last = place(2);
  damage(last.front().offset + 20);
  EXPECT_EQ(finish({{0, first}, {2, last}}), 1);
  EXPECT_EQ(result(), alone());
  remove_file(file_.path);
  EXPECT_EQ(finish({{0, first}, {2, last}}), 2);
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, placed_cells_are_not_written_again_when_their_tets_come_for_another_file) {
  const auto first = place(0);
  damage(first.front().offset + 20);
  EXPECT_EQ(finish({{0, first}}, PlacedTets::come_too), 1) << "damage was written over unseen";
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, a_task_that_goes_on_after_the_file_is_finished_does_no_harm) {
  const auto first = place(0);
  finish({{0, first}});
  EXPECT_EQ(place(0), first);
  place(1);
  EXPECT_EQ(finish({{0, first}}), 0);
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, other_places_are_not_believed) {
  auto first = place(0);
  first.front().offset += 8;
  EXPECT_EQ(finish({{0, first}}), 0);
  EXPECT_EQ(result(), alone());
}

TEST_F(SharedVtkhdfFile, tets_that_nobody_placed_are_missed) {
  SharedVtkhdf shared(file_, grid_.counts(), names_, [&](std::size_t i) { return parts_[i]; });
  NumberedPart part = parts_[1];
  part.tets.clear();
  EXPECT_THROW(shared.add(part), Error);
}

TEST_F(SharedVtkhdfFile, where_nothing_may_be_written_the_same_is_told) {
  const auto first = place(0);
  remove_file(file_.path);
  SharedFile nowhere = file_;
  nowhere.path.clear();
  EXPECT_EQ(place_cells(nowhere, parts_[0], leaf(0), names_), first);
  EXPECT_FALSE(std::filesystem::exists(file_.path));
}

TEST_F(SharedVtkhdfFile, a_file_in_the_making_is_no_mesh) {
  place(0);
  place(1);
  place(2);
  EXPECT_THROW(read_vtkhdf(file_.path), InvalidInput);
}

/// Sub-domains of tets of which the last has cells of every type inside.
struct HybridJob {
  CutGrid grid = cut_grid(5);
  Numbering numbering = grid.numbering();
  std::vector<Portion> portions;

  explicit HybridJob(bool is_hex) {
    for (const LeafNumbers& leaf : numbering.leaves) portions.push_back(grid.reader()(leaf));
    Portion& last = portions.back();
    HybridCore(last, 5, {3, 3, 2}, is_hex);
    LeafNumbers& leaf = numbering.leaves.back();
    numbering.tets += std::ssize(last.part.tets) - leaf.tets;
    leaf.tets = std::ssize(last.part.tets);
    numbering.nodes =
        1 + *std::max_element(last.part.local2global.begin(), last.part.local2global.end());
    last.shapes = {};
    ElementCounts first{};
    first[ElementType::tet] = leaf.first_tet;
    take_figures(std::vector<bool>(last.part.nodes.size()), first, last);
    leaf.others = last.others;
  }

  /// As a file, and through the files of its portions where those go from task to task.
  GlobalMeshSummary assemble(const std::filesystem::path& path) const {
    std::vector<VtkhdfCounts> counts;
    for (const Portion& portion : portions) counts.push_back(vtkhdf_counts(portion.part));
    const auto read = [&](const LeafNumbers& leaf) {
      for (const Portion& portion : portions) {
        if (numbering.leaves[static_cast<std::size_t>(portion.part.number)].path != leaf.path)
          continue;
        Portion copy = portion_from_bytes(portion_to_bytes(portion), "portion");
        add_portion_cells(portion_cells_to_bytes(portion), "cells", copy);
        return copy;
      }
      throw Error(ExitCode::failed, "no such leaf");
    };
    SharedVtkhdf file({path, path.string() + ".frame"}, counts,
                      {grid.surface.patch_names, grid.surface.region_names},
                      [&](std::size_t part) { return portions[part].part; });
    GlobalMeshWriter* writer = &file;
    return assemble_global_mesh(grid.surface, numbering, read, {&writer, 1});
  }
};

TEST(SharedVtkhdf, sub_domains_with_cells_of_every_type_are_assembled_to_a_right_mesh) {
  for (const bool is_hex : {true, false}) {
    const TempFolder folder;
    const HybridJob job(is_hex);
    const GlobalMeshSummary summary = job.assemble(folder.path() / "mesh.vtkhdf");
    EXPECT_EQ(summary.others[ElementType::hex], is_hex ? 1 : 0);
    EXPECT_EQ(summary.others[ElementType::prism], is_hex ? 0 : 2);
    EXPECT_EQ(summary.others[ElementType::pyramid], is_hex ? 6 : 4);
    const auto source = open_vtkhdf(folder.path() / "mesh.vtkhdf", folder.path());
    MeshCheck check(*source);
    for (std::size_t i = 0; i < source->size(); ++i) check.add(source->part(i));
    const MeshCheckResult result = check.finish();
    EXPECT_THAT(result.complaints, testing::IsEmpty());
    EXPECT_EQ(result.digest, summary.digest);
    EXPECT_NEAR(result.volume, 1, 1e-12);
  }
}

TEST(SharedVtkhdf, a_cell_that_does_not_fit_its_neighbours_is_not_assembled) {
  const TempFolder folder;
  HybridJob job(true);
  Portion& last = job.portions.back();
  std::swap(last.part.blocks[ElementType::hex].nodes[1],
            last.part.blocks[ElementType::hex].nodes[3]);
  last.shapes = {};
  take_figures(std::vector<bool>(last.part.nodes.size()), {}, last);
  EXPECT_THAT([&] { job.assemble(folder.path() / "mesh.vtkhdf"); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("faces of neighbours differ")));
}

}  // namespace
}  // namespace tetfarm
