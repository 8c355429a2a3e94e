/// Reads the next part of a mesh while this one is written: reading, and turning into the other
/// format, take about the same time.
///
/// Threads are here because the rooms of the mesh have none. What is written does not depend on
/// them.
#pragma once

#include <future>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Two parts are in memory, the one that was asked for and the next.
class ReadAhead : public MeshSource {
 public:
  /// @pre source->takes_threads().
  explicit ReadAhead(std::unique_ptr<MeshSource> source);

  std::size_t size() const override { return source_->size(); }
  /// What reading the part ahead threw is thrown when it is asked for.
  NumberedPart part(std::size_t i) const override;
  CountedPart counted_part(std::size_t i) const override { return source_->counted_part(i); }
  std::vector<std::string> complaints() const override { return source_->complaints(); }
  bool knows_subdomains() const override { return source_->knows_subdomains(); }
  std::vector<CellMark> cell_marks() const override { return source_->cell_marks(); }
  bool has_feet() const override { return source_->has_feet(); }
  std::vector<std::string> patch_names() const override { return source_->patch_names(); }
  std::vector<PatchType> patch_types() const override { return source_->patch_types(); }
  std::vector<std::string> region_names() const override { return source_->region_names(); }

 private:
  std::unique_ptr<MeshSource> source_;
  mutable std::size_t ahead_ = 0;
  mutable std::future<NumberedPart> next_;  ///< of the part `ahead_`; ends before the source does
};

}  // namespace tetfarm
