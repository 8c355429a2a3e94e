#include "mesh/formats/vtkhdf/shared_vtkhdf.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/cut_grid.h"

namespace tetfarm {
namespace {

/// A grid whose parts are written to one file, by hand.
class SharedVtkhdfFile : public testing::Test {
 protected:
  SharedVtkhdfFile() {
    count_faces();
    for (const LeafNumbers& leaf : numbering_.leaves) parts_.push_back(grid_.reader()(leaf).part);
    const auto writer = write_vtkhdf(folder_.path() / "alone", grid_.counts(),
                                     grid_.surface.patch_names, grid_.surface.region_names);
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
  first[1].offset += 8;
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

}  // namespace
}  // namespace tetfarm
