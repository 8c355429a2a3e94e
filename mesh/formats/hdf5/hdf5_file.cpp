#include "mesh/formats/hdf5/hdf5_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/hdf5/hdf5_soundness.h"

namespace tetfarm {
namespace {

/// HDF5 prints its stack of errors unless told not to. And it ends itself with the process, which
/// crashes when a file could not be closed, as on a full disk: the process would be said to have
/// crashed, whatever it had told before. There is nothing to end: each file is closed where it was
/// opened.
void tame() {
  static const herr_t once = H5dont_atexit();  // before all other calls
  static_cast<void>(once);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Handle space(const std::vector<hsize_t>& size) {
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose};
}

std::vector<hsize_t> size_of(hid_t dataset) {
  const Hdf5Handle here(H5Dget_space(dataset), H5Sclose);
  const int dimensions = H5Sget_simple_extent_ndims(here.get());
  std::vector<hsize_t> size(dimensions > 0 ? static_cast<std::size_t>(dimensions) : 0);
  if (!size.empty()) H5Sget_simple_extent_dims(here.get(), size.data(), nullptr);
  return size;
}

/// Text of a fixed length without an end mark.
Hdf5Handle text_type(std::size_t length) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(length, 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  return type;
}

/// Properties of an array; the time of its making is not kept.
Hdf5Handle of_no_time() {
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  return properties;
}

/// Bytes of a chunk of the array as it is read; 0 of one without chunks, or with huge ones.
std::size_t chunk_bytes(hid_t dataset) {
  constexpr std::size_t most = std::size_t{1} << 26;
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) return 0;
  std::array<hsize_t, H5S_MAX_RANK> size{};
  const int rank = H5Pget_chunk(properties.get(), H5S_MAX_RANK, size.data());
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  std::size_t bytes = rank > 0 ? H5Tget_size(type.get()) : 0;
  for (int k = 0; k < rank && bytes <= most; ++k) bytes *= size[static_cast<std::size_t>(k)];
  return bytes <= most ? bytes : 0;
}

/// The cache holds the one chunk that two pieces may share; arrays without chunks need none.
Hdf5Handle open_for_pieces(hid_t file, const std::string& name) {
  const Hdf5Handle whole(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const std::size_t chunk = whole.is_open() ? chunk_bytes(whole.get()) : 0;
  const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(access.get(), chunk > 0 ? 1 : 0, chunk, H5D_CHUNK_CACHE_W0_DEFAULT);
  return {H5Dopen2(file, name.c_str(), access.get()), H5Dclose};
}

/// Rows first … first + count - 1 of the dataset's space.
Hdf5Handle select_rows(hid_t dataset, hsize_t first, hsize_t count, hsize_t columns,
                       std::size_t rank) {
  Hdf5Handle all(H5Dget_space(dataset), H5Sclose);
  const std::array<hsize_t, 2> start = {first, 0};
  const std::array<hsize_t, 2> size = {count, columns};
  if (rank > 2 || H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(),
                                      nullptr) < 0) {
    return {};
  }
  return all;
}

}  // namespace

bool hdf5_takes_threads() {
  hbool_t takes = 0;
  return H5is_library_threadsafe(&takes) >= 0 && takes;
}

Hdf5Output::Hdf5Output(std::string path) : path_(std::move(path)) {
  tame();
  errno = 0;
  file_ = {H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
  checked(file_.get());
}

hid_t Hdf5Output::checked(hid_t result) const {
  if (result < 0) throw IoError("cannot write", path_, errno != 0 ? errno : EIO);
  return result;
}

void Hdf5Output::make_group(const std::string& name) {
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(properties.get(), false));
  const Hdf5Handle group(
      H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Gclose);
  checked(group.get());
}

void Hdf5Output::add_text_attribute(const std::string& group, const std::string& name,
                                    const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle one(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate_by_name(file_.get(), group.c_str(), name.c_str(), type.get(),
                                               one.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  checked(attribute.get());
  checked(H5Awrite(attribute.get(), type.get(), text.c_str()));
}

void Hdf5Output::add_attribute(const std::string& group, const std::string& name,
                               const std::vector<std::int64_t>& values) {
  const Hdf5Handle size = space({values.size()});
  const Hdf5Handle attribute(
      H5Acreate_by_name(file_.get(), group.c_str(), name.c_str(), H5T_STD_I64LE, size.get(),
                        H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  checked(attribute.get());
  checked(H5Awrite(attribute.get(), H5T_STD_I64LE, values.data()));
}

void Hdf5Output::add_texts(const std::string& name, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string all;
  for (const std::string& text : texts) all += text + std::string(length - text.size(), '\0');
  const Hdf5Handle type = text_type(length);
  const Hdf5Handle size = space({texts.size()});
  const Hdf5Handle properties = of_no_time();
  const Hdf5Handle dataset(H5Dcreate2(file_.get(), name.c_str(), type.get(), size.get(),
                                      H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                           H5Dclose);
  checked(dataset.get());
  if (texts.empty()) return;
  checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()));
}

void Hdf5Output::add_array(const std::string& name, hid_t type, const void* numbers,
                           std::size_t count) {
  TF_CHECK(numbers != nullptr || count == 0);
  const Hdf5Handle size = space({count});
  const Hdf5Handle properties = of_no_time();
  const Hdf5Handle dataset(H5Dcreate2(file_.get(), name.c_str(), type, size.get(), H5P_DEFAULT,
                                      properties.get(), H5P_DEFAULT),
                           H5Dclose);
  checked(dataset.get());
  if (count == 0) return;
  checked(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers));
}

std::int64_t Hdf5Output::room_for(const std::string& name, hid_t type, std::int64_t rows,
                                  int columns) {
  TF_CHECK(rows >= 0 && columns >= 1);
  std::vector<hsize_t> size = {static_cast<hsize_t>(rows)};
  if (columns > 1) size.push_back(static_cast<hsize_t>(columns));
  const Hdf5Handle here = space(size);
  const Hdf5Handle properties = of_no_time();
  H5Pset_layout(properties.get(), H5D_CONTIGUOUS);
  H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER);
  const Hdf5Handle dataset(H5Dcreate2(file_.get(), name.c_str(), type, here.get(), H5P_DEFAULT,
                                      properties.get(), H5P_DEFAULT),
                           H5Dclose);
  checked(dataset.get());
  if (rows == 0) return 0;
  const haddr_t place = H5Dget_offset(dataset.get());
  if (place == HADDR_UNDEF) throw IoError("cannot write", path_, EIO);
  return static_cast<std::int64_t>(place);
}

Hdf5Chunks Hdf5Output::packed_array(const std::string& name, hid_t type, std::int64_t rows) {
  constexpr std::int64_t most_rows_of_chunk = 65536;
  TF_CHECK(rows >= 0);
  const Hdf5Handle properties = of_no_time();
  const std::int64_t chunk_rows = std::clamp(rows, std::int64_t{1}, most_rows_of_chunk);
  if (rows > 0) {
    const auto chunk = static_cast<hsize_t>(chunk_rows);
    checked(H5Pset_chunk(properties.get(), 1, &chunk));
    checked(H5Pset_shuffle(properties.get()));
    checked(H5Pset_deflate(properties.get(), hdf5_deflate_level));
  }
  const Hdf5Handle here = space({static_cast<hsize_t>(rows)});
  Hdf5Handle dataset(H5Dcreate2(file_.get(), name.c_str(), type, here.get(), H5P_DEFAULT,
                                properties.get(), H5P_DEFAULT),
                     H5Dclose);
  checked(dataset.get());
  return {path_, std::move(dataset), chunk_rows};
}

void Hdf5Chunks::write(std::int64_t number, const std::string& packed) {
  const auto first = static_cast<hsize_t>(number * chunk_rows_);
  errno = 0;
  if (H5Dwrite_chunk(dataset_.get(), H5P_DEFAULT, 0, &first, packed.size(), packed.data()) < 0) {
    throw IoError("cannot write", path_, errno != 0 ? errno : EIO);
  }
}

void Hdf5Output::close() {
  TF_CHECK(file_.is_open());  // closed once
  errno = 0;
  checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL));
  checked(H5Fclose(file_.release()));
}

Hdf5Input::Hdf5Input(std::string path) : path_(std::move(path)) {
  tame();
  if (::access(path_.c_str(), R_OK) != 0) throw IoError("cannot read", path_, errno);
  expect_sound_hdf5(path_);
  file_ = {H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
  if (!file_.is_open()) fail("is not an HDF5 file, or a damaged one");
}

void Hdf5Input::fail(const std::string& what) const { throw InvalidInput(what, path_); }

bool Hdf5Input::has(const std::string& name) const {
  for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.get(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string Hdf5Input::text_attribute(const std::string& group, const std::string& name) const {
  const Hdf5Handle attribute(has(group) ? H5Aopen_by_name(file_.get(), group.c_str(), name.c_str(),
                                                          H5P_DEFAULT, H5P_DEFAULT)
                                        : -1,
                             H5Aclose);
  if (!attribute.is_open()) fail("no attribute " + name + " of " + group);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) {
    fail("attribute " + name + " is not a text of fixed length");
  }
  std::string text(H5Tget_size(type.get()), '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0) fail("cannot read " + name);
  return text.substr(0, text.find('\0'));
}

Hdf5Handle Hdf5Input::open(const std::string& name) const {
  Hdf5Handle dataset(has(name) ? H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (!dataset.is_open()) fail("no array " + name);
  return dataset;
}

std::vector<std::string> Hdf5Input::texts(const std::string& name) const {
  const Hdf5Handle dataset = open(name);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  const std::vector<hsize_t> size = size_of(dataset.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
      size.size() != 1) {
    fail(name + " is not a list of texts of fixed length");
  }
  const std::size_t length = H5Tget_size(type.get());
  std::string all(length * size[0], '\0');
  if (H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) {
    fail("cannot read " + name);
  }
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < size[0]; ++i) {
    const std::string text = all.substr(i * length, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::size_t Hdf5Input::rows_of(const std::string& name, int columns) const {
  const std::vector<hsize_t> size = size_of(open(name).get());
  const bool is_right = columns == 1 ? size.size() == 1
                                     : size.size() == 2 && size[1] == static_cast<hsize_t>(columns);
  if (!is_right) fail(name + " does not have the shape of such an array");
  return size[0];
}

std::size_t Hdf5Input::rows_of_list(const std::string& name) const {
  constexpr std::size_t most = std::size_t{1} << 24;
  const std::size_t rows = rows_of(name, 1);
  if (rows > most)
    fail(name + " has " + std::to_string(rows) + " numbers, more than " + std::to_string(most));
  return rows;
}

void Hdf5Input::read(const std::string& name, hid_t type, void* numbers) const {
  const Hdf5Handle dataset = open(name);
  if (H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) < 0) {
    fail("cannot read " + name);
  }
}

Hdf5Rows::Hdf5Rows(const Hdf5Input& file, std::string name, int columns)
    : file_(file),
      name_(std::move(name)),
      rows_(static_cast<std::int64_t>(file.rows_of(name_, columns))),
      columns_(columns) {
  TF_CHECK(columns >= 1);
  dataset_ = open_for_pieces(file.file_.get(), name_);
  if (!dataset_.is_open()) file.fail("no array " + name_);
}

std::size_t Hdf5Rows::number_size() const {
  const Hdf5Handle type(H5Dget_type(dataset_.get()), H5Tclose);
  return H5Tget_size(type.get());
}

void Hdf5Rows::check(std::int64_t first, std::int64_t count) const {
  if (first < 0 || count < 0 || first > rows_ || count > rows_ - first) {
    file_.fail(name_ + " ends too early");
  }
}

void Hdf5Rows::read(hid_t type, std::int64_t first, std::int64_t count, void* numbers) const {
  check(first, count);
  if (count == 0) return;
  std::vector<hsize_t> size = {static_cast<hsize_t>(count)};
  if (columns_ > 1) size.push_back(static_cast<hsize_t>(columns_));
  const Hdf5Handle there =
      select_rows(dataset_.get(), static_cast<hsize_t>(first), static_cast<hsize_t>(count),
                  static_cast<hsize_t>(columns_), size.size());
  const Hdf5Handle here = space(size);
  if (!there.is_open() ||
      H5Dread(dataset_.get(), type, here.get(), there.get(), H5P_DEFAULT, numbers) < 0) {
    file_.fail("cannot read " + name_);
  }
}

}  // namespace tetfarm
