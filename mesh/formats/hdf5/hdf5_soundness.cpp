#include "mesh/formats/hdf5/hdf5_soundness.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "base/child_process.h"
#include "base/error.h"
#include "base/retry_on_eintr.h"
#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {
namespace {

constexpr unsigned longest_walk = 120;  ///< seconds
/// The largest single value that is read: a text of an attribute, a number.
constexpr std::size_t largest_value = std::size_t{1} << 20;

bool has_fixed_size(hid_t type) {
  return H5Tdetect_class(type, H5T_VLEN) == 0 && H5Tis_variable_str(type) == 0 &&
         H5Tdetect_class(type, H5T_REFERENCE) == 0;
}

bool may_read(hid_t type, hssize_t values) {
  const std::size_t size = H5Tget_size(type);
  return size > 0 && size <= largest_value && has_fixed_size(type) && values > 0 &&
         static_cast<std::size_t>(values) <= largest_value / size;
}

herr_t read_attribute(hid_t object, const char* name, const H5A_info_t*, void*) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  if (!attribute.is_open() || !type.is_open() || !space.is_open()) return -1;
  const hssize_t values = H5Sget_simple_extent_npoints(space.get());
  if (!may_read(type.get(), values)) return 0;
  std::string bytes(H5Tget_size(type.get()) * static_cast<std::size_t>(values), '\0');
  return H5Aread(attribute.get(), type.get(), bytes.data()) < 0 ? -1 : 0;
}

herr_t read_first_number(hid_t dataset) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const Hdf5Handle there(H5Dget_space(dataset), H5Sclose);
  if (!type.is_open() || !there.is_open()) return -1;
  const int rank = H5Sget_simple_extent_ndims(there.get());
  if (rank < 0) return -1;
  if (H5Sget_simple_extent_npoints(there.get()) <= 0 || !may_read(type.get(), 1)) return 0;
  const std::array<hsize_t, H5S_MAX_RANK> origin = {};
  std::array<hsize_t, H5S_MAX_RANK> one;
  one.fill(1);
  if (rank > 0 && H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, origin.data(), nullptr,
                                      one.data(), nullptr) < 0) {
    return -1;
  }
  const Hdf5Handle here(H5Screate(H5S_SCALAR), H5Sclose);
  std::string bytes(H5Tget_size(type.get()), '\0');
  return H5Dread(dataset, type.get(), here.get(), there.get(), H5P_DEFAULT, bytes.data());
}

herr_t visit(hid_t group, const char* name, const H5O_info_t* info, void*) {
  const Hdf5Handle object(H5Oopen(group, name, H5P_DEFAULT), H5Oclose);
  if (!object.is_open()) return -1;
  if (info->type == H5O_TYPE_DATASET && read_first_number(object.get()) < 0) return -1;
  hsize_t place = 0;
  return H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_NATIVE, &place, read_attribute, nullptr);
}

bool can_walk(const char* path) {
  const Hdf5Handle file(H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  return file.is_open() &&
         H5Ovisit2(file.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit, nullptr, H5O_INFO_BASIC) >= 0;
}

/// Of the child: nothing that it says is shown, and it may not outlive its parent.
[[noreturn]] void walk(const char* path, pid_t parent) {
  live_with_parent(parent);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::alarm(longest_walk);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  ::_exit(can_walk(path) ? 0 : 1);
}

}  // namespace

void expect_sound_hdf5(const std::string& path) {
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw IoError("cannot start a process to read", path, errno);
  if (process == 0) walk(path.c_str(), parent);
  int status = 0;
  retry_on_eintr([&] { return ::waitpid(process, &status, 0); });
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    throw InvalidInput(signal == SIGALRM
                           ? "is a damaged HDF5 file: the library never finishes reading it"
                           : "is a damaged HDF5 file: the library is killed by signal " +
                                 std::to_string(signal) + " (" + ::strsignal(signal) +
                                 ") while reading it",
                       path);
  }
  if (WEXITSTATUS(status) != 0) throw InvalidInput("is not an HDF5 file, or a damaged one", path);
}

}  // namespace tetfarm
