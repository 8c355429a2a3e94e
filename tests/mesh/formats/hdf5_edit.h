/// Changes HDF5 files of tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {

/// Puts `value` at `index` of an array of integers.
inline void set_hdf5_number(const std::string& path, const std::string& array, std::size_t index,
                            std::int64_t value) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle data(H5Dopen2(file.get(), array.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(data.get()), H5Sclose);
  std::vector<std::int64_t> all(
      static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  ASSERT_GE(H5Dread(data.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
  all.at(index) = value;
  ASSERT_GE(H5Dwrite(data.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
}

/// Removes a group or an array.
inline void remove_from_hdf5(const std::string& path, const std::string& name) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  ASSERT_GE(H5Ldelete(file.get(), name.c_str(), H5P_DEFAULT), 0) << name;
}

/// Replaces an array by one with other numbers.
template <class T>
void replace_in_hdf5(const std::string& path, const std::string& name,
                     const std::vector<T>& numbers) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  ASSERT_GE(H5Ldelete(file.get(), name.c_str(), H5P_DEFAULT), 0) << name;
  const hsize_t size = numbers.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file.get(), name.c_str(), hdf5_type<T>(), space.get(),
                                   H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  ASSERT_GE(H5Dwrite(data.get(), hdf5_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
}

}  // namespace tetfarm
