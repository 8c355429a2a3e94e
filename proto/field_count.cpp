#include "proto/field_count.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>

#include <cstdint>

#include "base/check.h"
#include "proto/messages.pb.h"

namespace tetfarm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::io::CodedInputStream;

/// How a field's bytes lie, the low bits of its tag.
enum WireType : std::uint32_t { varint = 0, fixed64 = 1, bytes_with_length = 2, fixed32 = 5 };
constexpr std::uint32_t wire_type_bits = 3;

class FieldCount {
 public:
  explicit FieldCount(std::string_view bytes)
      : stream_(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                static_cast<int>(bytes.size())) {}

  bool is_above_limit() {
    TF_CHECK(count_ == 0);  // one count reads its bytes once
    add(wire::Envelope::descriptor());
    return count_ > max_fields;
  }

 private:
  /// The fields of a message of that type, up to the end of what may be read. False when the bytes
  /// end or make no sense, or there are enough. Messages hold each other only a few deep.
  bool add(const Descriptor* type) {
    while (const std::uint32_t tag = stream_.ReadTag()) {
      TF_CHECK(type != nullptr);
      if (++count_ > max_fields || !pass(tag, type)) return false;
    }
    return true;
  }
  bool pass(std::uint32_t tag, const Descriptor* type) {
    std::uint64_t number = 0;
    std::uint32_t word = 0;
    switch (tag & ((1U << wire_type_bits) - 1)) {
      case varint:
        return stream_.ReadVarint64(&number);
      case fixed64:
        return stream_.ReadLittleEndian64(&number);
      case fixed32:
        return stream_.ReadLittleEndian32(&word);
      case bytes_with_length:
        return stream_.ReadVarint32(&word) &&
               pass_part(type->FindFieldByNumber(static_cast<int>(tag >> wire_type_bits)),
                         static_cast<int>(word));
      default:
        return true;  // a group begins or ends: its fields follow
    }
  }
  bool pass_part(const FieldDescriptor* field, int size) {
    if (size < 0) return false;
    if (field == nullptr || field->message_type() == nullptr) return stream_.Skip(size);
    const CodedInputStream::Limit outer = stream_.PushLimit(size);
    const bool is_whole = add(field->message_type());
    stream_.PopLimit(outer);
    return is_whole;
  }

  CodedInputStream stream_;
  std::size_t count_ = 0;
};

}  // namespace

bool has_too_many_fields(std::string_view bytes) { return FieldCount(bytes).is_above_limit(); }

}  // namespace tetfarm
