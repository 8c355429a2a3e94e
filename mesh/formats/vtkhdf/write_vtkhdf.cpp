#include "mesh/formats/vtkhdf/write_vtkhdf.h"

#include <string_view>

#include "base/error.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

namespace tetfarm {
namespace {

class VtkhdfWriter : public GlobalMeshWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& path, std::span<const VtkhdfCounts> parts,
               const VtkhdfNames& names)
      : parts_(parts.begin(), parts.end()),
        before_(before_each(parts)),
        places_(write_vtkhdf_frame(path, parts, names)),
        file_(path, OutputFile::Start::as_it_is) {
    // HDF5 knows its files by their first eight bytes: until the last is written it is none.
    file_.write(0, std::string(hdf5_signature.size(), '\0'));
  }

  void add(const NumberedPart& part) override {
    const auto number = static_cast<std::size_t>(part.number);
    const VtkhdfCounts& counts = parts_.at(number);
    if (vtkhdf_counts(part) != counts) {
      throw Error(ExitCode::failed, "a sub-domain has different counts from those announced");
    }
    write_vtkhdf_cells(places_, before_[number], part, &file_);
    write_vtkhdf_points(places_, before_[number], part, file_);
  }

  void finish() override {
    file_.write(0, hdf5_signature);
    file_.finish();
  }

 private:
  std::vector<VtkhdfCounts> parts_;
  std::vector<VtkhdfBefore> before_;
  VtkhdfPlaces places_;
  OutputFile file_;
};

}  // namespace

std::unique_ptr<GlobalMeshWriter> write_vtkhdf(const std::filesystem::path& path,
                                               std::span<const VtkhdfCounts> parts,
                                               const VtkhdfNames& names) {
  return std::make_unique<VtkhdfWriter>(path, parts, names);
}

}  // namespace tetfarm
