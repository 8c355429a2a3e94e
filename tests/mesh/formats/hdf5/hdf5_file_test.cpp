#include "mesh/formats/hdf5/hdf5_file.h"

#include <gtest/gtest.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// A file with an attribute of twelve bytes: the text, and zeros after it.
void write_padded_attribute(const std::string& path, const std::string& text) {
  const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle group(H5Gcreate2(file.get(), "G", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  std::string padded = text;
  padded.resize(12, '\0');
  H5Tset_size(type.get(), padded.size());
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      H5Acreate2(group.get(), "Type", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  ASSERT_GE(H5Awrite(attribute.get(), type.get(), padded.data()), 0);
}

TEST(Hdf5Input, texts_of_attributes_end_where_the_zeros_begin) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  for (const std::string text : {"", "Grid", "twelve bytes"}) {
    write_padded_attribute(path, text);
    EXPECT_EQ(Hdf5Input(path).text_attribute("G", "Type"), text);
  }
}

}  // namespace
}  // namespace tetfarm
