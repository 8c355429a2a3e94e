#include "worker/leaf_inputs.h"

#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr const char* surface_name = "surface";
constexpr const char* numbering_name = "numbering";

/// Enough to see by whom it was written.
constexpr std::size_t bytes_to_tell_versions = 64;

std::string begin_of(const TaskIo& io, const std::string& name) {
  return io.look_into(name, [](const std::filesystem::path& path) {
    return read_part_of_file(path, 0, bytes_to_tell_versions);
  });
}

template <class File>
File open(const TaskIo& io, const std::string& name) {
  return io.look_into(name,
                      [&name](const std::filesystem::path& path) { return File(path, name); });
}

}  // namespace

SurfaceInput::SurfaceInput(const TaskIo& io) : io_(io) {
  if (is_surface_without_blocks(begin_of(io, surface_name))) {
    whole_ = surface_from_bytes(io.read(surface_name), surface_name);
  } else {
    file_ = open<SurfaceFile>(io, surface_name);
  }
}

SurfacePieces SurfaceInput::pieces(const WantedPieces& wanted) {
  if (whole_) return pieces_of(*whole_, wanted);
  return io_.look_into(surface_name, [&](const auto&) { return file_->read(wanted); });
}

const std::vector<std::string>& SurfaceInput::patch_names() const {
  return whole_ ? whole_->patch_names : file_->patch_names();
}

const std::vector<std::string>& SurfaceInput::region_names() const {
  return whole_ ? whole_->region_names : file_->region_names();
}

void SurfaceInput::add_figures(Numbering& numbering) const {
  if (whole_) {
    add_surface_figures(*whole_, numbering);
  } else {
    add_surface_figures(surface_from_bytes(io_.read(surface_name), surface_name), numbering);
  }
}

NumberingInput::NumberingInput(const TaskIo& io, const SurfaceInput& surface) : io_(io) {
  if (is_numbering_text(begin_of(io, numbering_name))) {
    whole_ = numbering_from_bytes(io.read(numbering_name), numbering_name);
    surface.add_figures(*whole_);
  } else {
    file_ = open<NumberingFile>(io, numbering_name);
  }
}

std::int32_t NumberingInput::regions() const {
  return whole_ ? whole_->regions : file_->whole().regions;
}

LeafNumbering NumberingInput::leaf(const LeafQuestion& question) {
  if (whole_) return leaf_numbering(*whole_, question);
  return io_.look_into(numbering_name, [&](const auto&) { return file_->leaf(question); });
}

}  // namespace tetfarm
