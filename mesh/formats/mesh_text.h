/// The bytes of a file, brought into memory by the system as they are looked at, and scanned from
/// the beginning to the end; what lies behind is let go.
#pragma once

#include <filesystem>
#include <string>

#include "base/mapped_file.h"
#include "mesh/formats/input_scanner.h"

namespace tetfarm {

class MeshText {
 public:
  /// `comment` as of InputScanner. @throws IoError.
  explicit MeshText(const std::filesystem::path& path, char comment = '\0');
  MeshText(const MeshText&) = delete;
  MeshText& operator=(const MeshText&) = delete;

  InputScanner& scanner() { return scanner_; }
  const std::string& name() const { return name_; }
  /// To be called after each record: now and then it lets go what has been read, which is read
  /// from the disk again if a message has to count its lines.
  void pass() {
    if (++passed_ % 65536 == 0) let_go();
  }

 private:
  void let_go() const;

  std::string name_;
  MappedFile file_;
  InputScanner scanner_;
  std::size_t passed_ = 0;
};

}  // namespace tetfarm
