/// The numbering of a job as a file: read whole by who puts the mesh together, and by each leaf at
/// the cost of what the leaf has, whatever the number of leaves.
///
/// Tables in tree order answer a leaf by binary search; the text of the whole numbering comes
/// behind them. The grammar is in store/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/artifacts/block_file.h"
#include "mesh/assemble/leaf_numbering.h"

namespace tetfarm {

std::string numbering_to_bytes(const Numbering& numbering);

/// Also of a text alone, for jobs that were begun by an older version: that does not have the
/// figures of the surface (add_surface_figures). @throws CorruptFile naming `name`, also where the
/// tables say anything else than the text. Cost: O(n log n).
Numbering numbering_from_bytes(std::string_view bytes, const std::string& name);

/// Whether a file that begins like this is such a text: it has no tables for leaves.
bool is_numbering_text(std::string_view begin);

/// How many entries the tables have, and where they begin.
struct NumberingTables {
  std::uint64_t unused = 0;
  std::uint64_t forced = 0;
  std::uint64_t cuts = 0;
  std::uint64_t leaves = 0;
  std::uint64_t dropped = 0;
  std::uint64_t others = 0;  ///< so many of layer_types are told of each leaf

  std::uint64_t unused_at() const;
  std::uint64_t forced_at() const;
  std::uint64_t cuts_at() const;
  std::uint64_t leaves_at() const;
  std::uint64_t dropped_at() const;
  std::uint64_t text_at() const;
};

/// A file of a numbering, open to answer a leaf. @throws CorruptFile naming `name`, IoError.
class NumberingFile {
 public:
  /// Reads the sizes of the whole.
  NumberingFile(const std::filesystem::path& path, const std::string& name);

  const MeshTotals& whole() const { return whole_; }
  /// The same as leaf_numbering of the whole. @throws Error as that does.
  /// Cost: O(n log m) for n nodes that are asked for and m entries in the tables, in memory of the
  /// nodes; the blocks of the file that are read are fewer where the nodes' numbers are near to
  /// each other.
  LeafNumbering leaf(const LeafQuestion& question);
  std::uint64_t bytes_read() const { return file_.bytes_read(); }

 private:
  struct Owner;
  struct Leaf;
  struct LeafWithOthers;
  void add_nodes(const LeafQuestion& question, LeafNumbering& result);
  Owner find_owner(const Origin& origin);
  Owner cut_at(std::uint64_t i);
  LeafWithOthers leaf_at(std::uint64_t i);
  TreePath path_of_leaf(std::uint64_t i);
  const Owner& checked(const Owner& owner) const;
  DroppedRange dropped_range(const Owner& owner, std::uint64_t i);
  std::int64_t number_of(const Owner& owner, const Origin& origin);
  std::int64_t number_on_surface(const Origin& origin);
  bool is_forced(const ForcedNode& node);

  BlockFile file_;
  NumberingTables tables_;
  MeshTotals whole_;
  std::int64_t surface_nodes_ = 0;
  bool counts_faces_ = false;
};

}  // namespace tetfarm
