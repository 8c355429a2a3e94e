/// The tree of nodes that a CGNS file is, as groups of an HDF5 file.
///
/// Source: CGNS "SIDS-to-HDF5 file mapping". A node has a name, a label, a type and data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {

/// The name of a section that is not a patch's own: "GridPyramids", and "GridQuads_2" for the quads
/// of a patch that has triangles too.
std::string cgns_section(ElementType type);

class CgnsTree {
 public:
  /// Truncates. Every failure throws IoError.
  explicit CgnsTree(const std::filesystem::path& path);

  /// A node without data; `path` is "Base/Zone1", "" for the root.
  void node(const std::string& parent, const std::string& name, const std::string& label);
  void text_node(const std::string& parent, const std::string& name, const std::string& label,
                 const std::string& text);
  void small_node(const std::string& parent, const std::string& name, const std::string& label,
                  const std::vector<std::int32_t>& values);
  /// With `rows` > 0 a table of so many rows, column after column; 0: a list.
  void large_node(const std::string& parent, const std::string& name, const std::string& label,
                  const std::vector<std::int64_t>& values, std::size_t rows = 0);
  void double_node(const std::string& parent, const std::string& name, const std::string& label,
                   const std::vector<double>& values);
  void version_node(float version);
  /// An array to be filled later; returns where in the file it begins. @pre count > 0
  std::int64_t room_for_doubles(const std::string& parent, const std::string& name,
                                std::int64_t count);
  std::int64_t room_for_large(const std::string& parent, const std::string& name,
                              std::int64_t count);
  std::int64_t room_for_small(const std::string& parent, const std::string& name,
                              std::int64_t count);
  /// A boundary condition over the elements `first` to `last` of Base/Zone1, which has a ZoneBC,
  /// and a family for it. @param location "FaceCenter" @param type of boundary condition, of both;
  /// "": what it means is for the user to say.
  void boundary(const std::string& name, std::int64_t first, std::int64_t last,
                const std::string& location, const std::string& type = {});
  void close();

 private:
  Hdf5Handle make(const std::string& parent, const std::string& name, const std::string& label,
                  const std::string& type);
  void fill(hid_t group, hid_t type, const std::vector<hsize_t>& size, const void* data);
  std::int64_t room(const std::string& parent, const std::string& name, const std::string& type,
                    hid_t number, std::int64_t count);
  void attribute(hid_t group, const char* name, const std::string& text, std::size_t bytes);
  hid_t checked(hid_t result) const;

  std::string path_;
  Hdf5Handle file_;
};

}  // namespace tetfarm
