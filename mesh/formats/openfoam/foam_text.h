/// The text of an OpenFOAM file: words and marks, lists, entries of dictionaries.
///
/// Source: OpenFOAM user guide, "Basic input/output file format". Comments are passed over; binary
/// files are refused. Every failure throws InvalidInput with the file and the line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "mesh/formats/mesh_text.h"

namespace tetfarm {

class FoamText {
 public:
  /// Reads the header. @throws IoError, InvalidInput, as all that follows.
  explicit FoamText(const std::filesystem::path& path);

  const std::string& name() const { return text_.name(); }
  /// One of ( ) { } ;, a text in quotes, or what lies between those and blanks. It lasts as long as
  /// this. Fails at the end of the file.
  std::string_view token();
  void expect(std::string_view token);
  /// The count of a list and its bracket; fails when the file cannot hold as many records.
  std::int64_t begin_list(std::int64_t least_bytes_each);
  void end_list() { expect(")"); }
  double coordinate() { return in_.to_coordinate(token()); }
  std::int64_t to_integer(std::string_view token) const {
    return in_.to_integer(token, "a number");
  }
  std::int64_t integer() { return to_integer(token()); }
  /// A number from 0 that is below `end`, which is at most 2^31 - 1.
  std::int32_t label(std::int64_t end);
  /// "{ KEY VALUE; … }": `read` gets each key and the first token of its value, and returns whether
  /// it has read the rest with its semicolon. Dictionaries inside are passed over.
  void read_dictionary(const std::function<bool(std::string_view, std::string_view)>& read);
  /// To be called after each record (MeshText).
  void pass() { text_.pass(); }
  [[noreturn]] void fail(const std::string& what) const { in_.fail(what); }

 private:
  bool skip_comment();
  std::string_view quotation();
  void skip_value(std::string_view token);

  MeshText text_;
  InputScanner& in_;
  std::string_view rest_;  ///< of the word that the last token was cut from
};

}  // namespace tetfarm
