#include "worker/leaf_inputs.h"

#include <utility>

#include "base/file_system.h"

namespace tetfarm {
namespace {

/// Enough to see by whom it was written.
constexpr std::size_t bytes_to_tell_versions = 64;

std::string begin_of(const TaskIo& io, const TaskFile& file) {
  return io.look_into(file, [](const std::filesystem::path& path) {
    return read_part_of_file(path, 0, bytes_to_tell_versions);
  });
}

template <class File>
File open(const TaskIo& io, const TaskFile& file) {
  return io.look_into(
      file, [&](const std::filesystem::path& path) { return File(path, io.name_of(file)); });
}

}  // namespace

SurfaceInput::SurfaceInput(const TaskIo& io, TaskFile surface)
    : io_(io), input_(std::move(surface)) {
  if (is_surface_without_blocks(begin_of(io, input_))) {
    whole_ = io.read(input_, surface_from_bytes);
  } else {
    file_ = open<SurfaceFile>(io, input_);
  }
}

SurfacePieces SurfaceInput::pieces(const WantedPieces& wanted) {
  if (whole_) return pieces_of(*whole_, wanted);
  return io_.look_into(input_, [&](const auto&) { return file_->read(wanted); });
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
    add_surface_figures(io_.read(input_, surface_from_bytes), numbering);
  }
}

NumberingInput::NumberingInput(const TaskIo& io, TaskFile numbering, const SurfaceInput& surface)
    : io_(io), input_(std::move(numbering)) {
  if (is_numbering_text(begin_of(io, input_))) {
    whole_ = io.read(input_, numbering_from_bytes);
    surface.add_figures(*whole_);
  } else {
    file_ = open<NumberingFile>(io, input_);
  }
}

std::int32_t NumberingInput::regions() const {
  return whole_ ? whole_->regions : file_->whole().regions;
}

LeafNumbering NumberingInput::leaf(const LeafQuestion& question) {
  if (whole_) return leaf_numbering(*whole_, question);
  return io_.look_into(input_, [&](const auto&) { return file_->leaf(question); });
}

}  // namespace tetfarm
