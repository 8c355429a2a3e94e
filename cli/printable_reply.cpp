#include "cli/printable_reply.h"

#include <google/protobuf/descriptor.h>

#include <string>
#include <vector>

#include "base/printable_text.h"

namespace tetfarm {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

std::string shown(const FieldDescriptor& field, const std::string& text) {
  return printable(text, field.name() == "log" ? Lines::kept : Lines::escaped);
}

void make_field_printable(Message& message, const FieldDescriptor& field) {
  const Reflection& reflection = *message.GetReflection();
  const int count = field.is_repeated() ? reflection.FieldSize(message, &field) : 1;
  for (int i = 0; i < count; ++i) {
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      make_printable(field.is_repeated() ? *reflection.MutableRepeatedMessage(&message, &field, i)
                                         : *reflection.MutableMessage(&message, &field));
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING && field.is_repeated()) {
      reflection.SetRepeatedString(&message, &field, i,
                                   shown(field, reflection.GetRepeatedString(message, &field, i)));
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
      reflection.SetString(&message, &field, shown(field, reflection.GetString(message, &field)));
    }
  }
}

}  // namespace

void make_printable(Message& message) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) make_field_printable(message, *field);
}

}  // namespace tetfarm
