#include "mesh/formats/hdf5/hdf5_soundness.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// A file with an attribute of a group, and one of a data set.
void write_attributes(const std::string& path) {
  const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle group(H5Gcreate2(file.get(), "G", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  const std::array<hsize_t, 1> size = {2};
  const Hdf5Handle space(H5Screate_simple(1, size.data(), nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file.get(), "D", H5T_NATIVE_INT, space.get(), H5P_DEFAULT,
                                   H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  const std::array<int, 2> numbers = {1, 2};
  ASSERT_GE(H5Dwrite(data.get(), H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
  for (const auto& [object, name] : {std::pair(group.get(), "of_group"), {data.get(), "of_data"}}) {
    const Hdf5Handle attribute(
        H5Acreate2(object, name, H5T_NATIVE_INT, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(attribute.get(), H5T_NATIVE_INT, numbers.data()), 0);
  }
}

TEST(Hdf5Soundness, finds_a_damaged_attribute_of_a_group_and_of_a_data_set) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  write_attributes(path);
  EXPECT_NO_THROW(expect_sound_hdf5(path));
  const std::string bytes = read_file(path);
  for (const char* name : {"of_group", "of_data"}) {
    // The version of the message, before three sizes, which is followed by the name.
    std::string damaged = bytes;
    damaged.at(damaged.find(name) - 8) = 77;
    std::ofstream(path, std::ios::binary) << damaged;
    EXPECT_THROW(expect_sound_hdf5(path), InvalidInput) << name;
  }
}

TEST(Hdf5Soundness, is_not_of_a_file_of_something_else) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  std::ofstream(path) << "It was a dark and stormy night";
  EXPECT_THROW(expect_sound_hdf5(path), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
