#include "mesh/formats/hdf5/hdf5_file.h"

#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
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

/// A file with a list of two texts of any length, and one of two rows of two numbers.
void write_odd_arrays(const std::string& path) {
  const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  const std::array<hsize_t, 2> size = {2, 2};
  const Hdf5Handle list(H5Screate_simple(1, size.data(), nullptr), H5Sclose);
  const Hdf5Handle texts(H5Dcreate2(file.get(), "texts", type.get(), list.get(), H5P_DEFAULT,
                                    H5P_DEFAULT, H5P_DEFAULT),
                         H5Dclose);
  const std::array<const char*, 2> words = {"one", "two"};
  ASSERT_GE(H5Dwrite(texts.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, words.data()), 0);
  const Hdf5Handle table(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
  const Hdf5Handle rows(H5Dcreate2(file.get(), "rows", H5T_IEEE_F64LE, table.get(), H5P_DEFAULT,
                                   H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  const std::array<double, 4> numbers = {1, 2, 3, 4};
  ASSERT_GE(H5Dwrite(rows.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
            0);
}

TEST(Hdf5Input, refuses_texts_of_any_length_and_rows_of_another) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  write_odd_arrays(path);
  const Hdf5Input file(path);
  const auto said_of = [](const auto& read) -> std::string {
    try {
      read();
    } catch (const InvalidInput& error) {
      const std::string what = error.what();
      return what.substr(what.find(": ") + 2);
    }
    return "";
  };
  const std::string shape = "rows does not have the shape of such an array";
  EXPECT_EQ(said_of([&] { file.texts("texts"); }), "texts is not a list of texts of fixed length");
  EXPECT_EQ(said_of([&] { file.texts("rows"); }), "rows is not a list of texts of fixed length");
  EXPECT_EQ(said_of([&] { file.rows("rows", 3); }), shape);
  EXPECT_EQ(said_of([&] { file.rows("rows"); }), shape);
  EXPECT_EQ(said_of([&] { file.rows("texts", 2); }),
            "texts does not have the shape of such an array");
  EXPECT_EQ(said_of([&] { file.list<std::int32_t>("none"); }), "no array none");
  EXPECT_EQ(said_of([&] { file.rows("none/of/these"); }), "no array none/of/these");
  EXPECT_EQ(said_of([&] { file.text_attribute("none", "Type"); }), "no attribute Type of none");
  EXPECT_EQ(said_of([&] { file.text_attribute("rows", "Type"); }), "no attribute Type of rows");
  for (const auto& [first, count] : {std::pair{-1, 1}, {0, -1}, {3, 0}, {1, 2}, {2, 1}}) {
    EXPECT_EQ(said_of([&, from = first, of = count] { file.rows("rows", 2).check(from, of); }),
              "rows ends too early")
        << first << " " << count;
  }
  EXPECT_EQ(said_of([&] { file.rows("rows", 2).check(2, 0); }), "");
  EXPECT_FALSE(file.has("none"));
  EXPECT_FALSE(file.has("rows/none"));
  EXPECT_TRUE(file.has("rows"));
  EXPECT_EQ(file.slice<double>("rows", 1, 1, 2), (std::vector<double>{3, 4}));
}

TEST(Hdf5Input, texts_of_attributes_end_where_the_zeros_begin) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  for (const std::string text : {"", "Grid", "twelve bytes"}) {
    write_padded_attribute(path, text);
    EXPECT_EQ(Hdf5Input(path).text_attribute("G", "Type"), text);
  }
}

TEST(Hdf5Output, gives_back_texts_of_any_length_and_lists) {
  const TempFolder folder;
  const std::string path = (folder.path() / "a.h5").string();
  Hdf5Output output(path);
  output.add_texts("texts", {"", "a", "blank at the end "});
  output.add_texts("none", {});
  output.close();
  const Hdf5Input file(path);
  EXPECT_EQ(file.texts("texts"), (std::vector<std::string>{"", "a", "blank at the end "}));
  EXPECT_EQ(file.texts("none"), std::vector<std::string>());
}

}  // namespace
}  // namespace tetfarm
