/// The HDF5 library may crash, leak or go round in circles on a damaged file. What is read for a
/// person is therefore walked once by a process that may end so without harm.
#pragma once

#include <string>

namespace tetfarm {

/// Opens everything that is in the file, and reads its attributes and the first number of each
/// array, in a copy of this process. Costs a fork and the file's structure, not its arrays.
/// @throws InvalidInput when the library refuses the file, ends by a signal, or takes minutes;
/// IoError when no process can be started.
void expect_sound_hdf5(const std::string& path);

}  // namespace tetfarm
