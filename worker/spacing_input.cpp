#include "worker/spacing_input.h"

namespace tetfarm {

SpacingField spacing_input(const TaskIo& io, const TaskFile& file) {
  return io.look_into(file, [&](const std::filesystem::path& path) {
    return SpacingField::from_file(path, io.name_of(file));
  });
}

}  // namespace tetfarm
