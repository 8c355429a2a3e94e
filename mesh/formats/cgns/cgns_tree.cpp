#include "mesh/formats/cgns/cgns_tree.h"

#include <algorithm>
#include <cerrno>

#include "base/error.h"

namespace tetfarm {
namespace {

constexpr std::size_t name_bytes = 33;
constexpr std::size_t type_bytes = 3;
constexpr const char* data_name = " data";

/// Readers walk over children in the order in which they were made, and need it to be kept.
Hdf5Handle keeping_order(hid_t kind) {
  Hdf5Handle properties(H5Pcreate(kind), H5Pclose);
  H5Pset_link_creation_order(properties.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(properties.get(), false);
  return properties;
}

}  // namespace

std::string cgns_section(ElementType type) {
  std::string name = "Grid" + std::string(element(type).plural);
  name[4] = static_cast<char>(name[4] - 'a' + 'A');
  return name;
}

CgnsTree::CgnsTree(const std::filesystem::path& path) : path_(path.string()) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  errno = 0;
  const Hdf5Handle properties = keeping_order(H5P_FILE_CREATE);
  file_ = {H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, properties.get(), H5P_DEFAULT), H5Fclose};
  checked(file_.get());
  const Hdf5Handle root(H5Gopen2(file_.get(), "/", H5P_DEFAULT), H5Gclose);
  attribute(root.get(), "name", "HDF5 MotherNode", name_bytes);
  attribute(root.get(), "label", "Root Node of HDF5 File", name_bytes);
  attribute(root.get(), "type", "MT", type_bytes);
  const auto text = [&](const char* name, std::string value) {
    value.resize(name_bytes, '\0');
    const hsize_t size = name_bytes;
    const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Hdf5Handle plain(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(plain.get(), false);
    const Hdf5Handle set(H5Dcreate2(root.get(), name, H5T_NATIVE_CHAR, space.get(), H5P_DEFAULT,
                                    plain.get(), H5P_DEFAULT),
                         H5Dclose);
    checked(set.get());
    checked(H5Dwrite(set.get(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()));
  };
  text(" format", "IEEE_LITTLE_32");
  text(" hdf5version", "HDF5 Version 1.10");
}

hid_t CgnsTree::checked(hid_t result) const {
  if (result < 0) throw IoError("cannot write", path_, errno != 0 ? errno : EIO);
  return result;
}

void CgnsTree::attribute(hid_t group, const char* name, const std::string& text,
                         std::size_t bytes) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), bytes);
  const Hdf5Handle one(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle here(H5Acreate2(group, name, type.get(), one.get(), H5P_DEFAULT, H5P_DEFAULT),
                        H5Aclose);
  checked(here.get());
  std::string padded = text;
  padded.resize(bytes, '\0');
  checked(H5Awrite(here.get(), type.get(), padded.data()));
}

Hdf5Handle CgnsTree::make(const std::string& parent, const std::string& name,
                          const std::string& label, const std::string& type) {
  const Hdf5Handle properties = keeping_order(H5P_GROUP_CREATE);
  const std::string path = parent.empty() ? "/" + name : "/" + parent + "/" + name;
  Hdf5Handle group(
      H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Gclose);
  checked(group.get());
  attribute(group.get(), "name", name, name_bytes);
  attribute(group.get(), "label", label, name_bytes);
  attribute(group.get(), "type", type, type_bytes);
  const hsize_t size = 1;
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Hdf5Handle flags(
      H5Acreate2(group.get(), "flags", H5T_STD_I32LE, space.get(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const std::int32_t ordered = 1;
  checked(flags.get());
  checked(H5Awrite(flags.get(), H5T_NATIVE_INT32, &ordered));
  return group;
}

void CgnsTree::fill(hid_t group, hid_t type, const std::vector<hsize_t>& size, const void* data) {
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                         H5Sclose);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  const Hdf5Handle set(
      H5Dcreate2(group, data_name, type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
      H5Dclose);
  checked(set.get());
  checked(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
}

void CgnsTree::node(const std::string& parent, const std::string& name, const std::string& label) {
  make(parent, name, label, "MT");
}

void CgnsTree::text_node(const std::string& parent, const std::string& name,
                         const std::string& label, const std::string& text) {
  const Hdf5Handle group = make(parent, name, label, "C1");
  fill(group.get(), H5T_NATIVE_CHAR, {text.size()}, text.data());
}

void CgnsTree::small_node(const std::string& parent, const std::string& name,
                          const std::string& label, const std::vector<std::int32_t>& values) {
  const Hdf5Handle group = make(parent, name, label, "I4");
  fill(group.get(), H5T_STD_I32LE, {values.size()}, values.data());
}

void CgnsTree::large_node(const std::string& parent, const std::string& name,
                          const std::string& label, const std::vector<std::int64_t>& values,
                          std::size_t rows) {
  const Hdf5Handle group = make(parent, name, label, "I8");
  // HDF5's last index runs fastest, CGNS's first.
  const std::vector<hsize_t> size = rows == 0 ? std::vector<hsize_t>{values.size()}
                                              : std::vector<hsize_t>{values.size() / rows, rows};
  fill(group.get(), H5T_STD_I64LE, size, values.data());
}

void CgnsTree::double_node(const std::string& parent, const std::string& name,
                           const std::string& label, const std::vector<double>& values) {
  const Hdf5Handle group = make(parent, name, label, "R8");
  fill(group.get(), H5T_IEEE_F64LE, {values.size()}, values.data());
}

void CgnsTree::version_node(float version) {
  const Hdf5Handle group = make("", "CGNSLibraryVersion", "CGNSLibraryVersion_t", "R4");
  fill(group.get(), H5T_IEEE_F32LE, {1}, &version);
}

std::int64_t CgnsTree::room(const std::string& parent, const std::string& name,
                            const std::string& type, hid_t number, std::int64_t count) {
  const Hdf5Handle group = make(parent, name, "DataArray_t", type);
  const auto size = static_cast<hsize_t>(count);
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  H5Pset_layout(properties.get(), H5D_CONTIGUOUS);
  H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER);
  const Hdf5Handle set(H5Dcreate2(group.get(), data_name, number, space.get(), H5P_DEFAULT,
                                  properties.get(), H5P_DEFAULT),
                       H5Dclose);
  checked(set.get());
  const haddr_t place = H5Dget_offset(set.get());
  if (place == HADDR_UNDEF) throw IoError("cannot write", path_, EIO);
  return static_cast<std::int64_t>(place);
}

std::int64_t CgnsTree::room_for_doubles(const std::string& parent, const std::string& name,
                                        std::int64_t count) {
  return room(parent, name, "R8", H5T_IEEE_F64LE, count);
}

std::int64_t CgnsTree::room_for_large(const std::string& parent, const std::string& name,
                                      std::int64_t count) {
  return room(parent, name, "I8", H5T_STD_I64LE, count);
}

std::int64_t CgnsTree::room_for_small(const std::string& parent, const std::string& name,
                                      std::int64_t count) {
  return room(parent, name, "I4", H5T_STD_I32LE, count);
}

void CgnsTree::boundary(const std::string& name, std::int64_t first, std::int64_t last,
                        const std::string& location, const std::string& type) {
  const std::string conditions = "Base/Zone1/ZoneBC";
  const std::string here = conditions + "/" + name;
  node("Base", name, "Family_t");
  if (!type.empty()) text_node("Base/" + name, "FamBC", "FamilyBC_t", type);
  text_node(conditions, name, "BC_t", type.empty() ? "FamilySpecified" : type);
  large_node(here, "PointRange", "IndexRange_t", {first, last}, 1);
  text_node(here, "GridLocation", "GridLocation_t", location);
  text_node(here, "FamilyName", "FamilyName_t", name);
}

void CgnsTree::close() {
  errno = 0;
  checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL));
  checked(H5Fclose(file_.release()));
}

}  // namespace tetfarm
