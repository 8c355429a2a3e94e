/// All that an HDF5 file holds, as lines of text: its bytes depend on the library's version.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/formats/hdf5/hdf5_file.h"
#include "tests/mesh/formats/mesh_listing.h"

namespace tetfarm {

inline std::string hdf5_type_text(hid_t type) {
  const std::string bytes = std::to_string(8 * H5Tget_size(type));
  const std::string order = H5Tget_order(type) == H5T_ORDER_BE ? " big endian" : "";
  switch (H5Tget_class(type)) {
    case H5T_INTEGER:
      return (H5Tget_sign(type) == H5T_SGN_NONE ? "unsigned" : "integer") + bytes + order;
    case H5T_FLOAT:
      return "real" + bytes + order;
    case H5T_STRING:
      return "text" + std::to_string(H5Tget_size(type));
    default:
      return "other";
  }
}

inline std::string hdf5_space_text(hid_t space) {
  std::vector<hsize_t> size(
      static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  if (!size.empty()) H5Sget_simple_extent_dims(space, size.data(), nullptr);
  std::string text;
  for (const hsize_t length : size) text += "[" + std::to_string(length) + "]";
  return text;
}

/// What is read is turned into one of three kinds by `read(type, memory)`.
template <class Read>
std::string hdf5_values_text(hid_t type, std::size_t count, const Read& read) {
  std::string text;
  if (H5Tget_class(type) == H5T_STRING) {
    const std::size_t length = H5Tget_size(type);
    std::string all(length * count, '?');
    read(type, all.data());
    for (std::size_t i = 0; i < count; ++i) {
      std::string one = all.substr(i * length, length);
      std::replace(one.begin(), one.end(), '\0', '~');
      text += " \"" + one + "\"";
    }
  } else if (H5Tget_class(type) == H5T_FLOAT) {
    std::vector<double> all(count);
    read(H5T_NATIVE_DOUBLE, all.data());
    for (const double value : all) text += " " + digits_of(value);
  } else {
    std::vector<std::int64_t> all(count);
    read(H5T_NATIVE_INT64, all.data());
    for (const std::int64_t value : all) text += " " + std::to_string(value);
  }
  return text;
}

/// Which are printed before what the object holds.
inline herr_t list_hdf5_attribute(hid_t object, const char* name, const H5A_info_t*, void* text) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
  *static_cast<std::string*>(text) +=
      "  @" + std::string(name) + " " + hdf5_type_text(type.get()) + hdf5_space_text(space.get()) +
      hdf5_values_text(type.get(), count,
                       [&](hid_t memory, void* into) { H5Aread(attribute.get(), memory, into); }) +
      "\n";
  return 0;
}

inline void list_hdf5_object(hid_t parent, const std::string& name, const std::string& path,
                             std::string& text);

/// Members in the order in which they were made where that is kept, else by name.
inline void list_hdf5_group(hid_t group, const std::string& path, std::string& text) {
  const Hdf5Handle made(H5Gget_create_plist(group), H5Pclose);
  unsigned flags = 0;
  H5Pget_link_creation_order(made.get(), &flags);
  const H5_index_t order =
      (flags & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  text += order == H5_INDEX_CRT_ORDER ? path + " group in order\n" : path + " group\n";
  hsize_t first_attribute = 0;
  H5Aiterate2(group, H5_INDEX_NAME, H5_ITER_INC, &first_attribute, list_hdf5_attribute, &text);
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* kept) -> herr_t {
    static_cast<std::vector<std::string>*>(kept)->emplace_back(name);
    return 0;
  };
  hsize_t first = 0;
  H5Literate(group, order, H5_ITER_INC, &first, keep, &names);
  for (const std::string& name : names) list_hdf5_object(group, name, path + "/" + name, text);
}

inline void list_hdf5_object(hid_t parent, const std::string& name, const std::string& path,
                             std::string& text) {
  const Hdf5Handle object(H5Oopen(parent, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (H5Iget_type(object.get()) == H5I_GROUP) {
    list_hdf5_group(object.get(), path, text);
    return;
  }
  const Hdf5Handle type(H5Dget_type(object.get()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(object.get()), H5Sclose);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
  text += path + " " + hdf5_type_text(type.get()) + hdf5_space_text(space.get()) +
          hdf5_values_text(type.get(), count,
                           [&](hid_t memory, void* into) {
                             H5Dread(object.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, into);
                           }) +
          "\n";
  hsize_t first = 0;
  H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, &first, list_hdf5_attribute, &text);
}

inline std::string hdf5_listing(const std::string& path) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle root(H5Gopen2(file.get(), "/", H5P_DEFAULT), H5Gclose);
  std::string text;
  list_hdf5_group(root.get(), "", text);
  return text;
}

}  // namespace tetfarm
