#include "proto/text_limits.h"

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/utf8.h"

namespace tetfarm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr std::size_t longest_message = 4096;
constexpr std::size_t longest_log = 8192;
constexpr int most_files = 1 << 16;  // a few for each sub-domain

constexpr std::array<TextLimit, 19> texts = {{
    {"Artifact.name", 300},  // of a result: the job's name and an ending
    {"Hello.program_version", 64, TooLong::cut},
    {"Hello.host", 255},
    {"Hello.store_probe", 64},
    {"Hello.probe_text", 256},
    {"Hello.nonce", 128},
    {"Hello.tag", 200},
    {"Doing.stage", 64, TooLong::cut},
    {"Done.numbers.key", 255},
    {"Done.texts.key", 255},
    {"Done.texts", std::size_t{8} << 20U},  // `order` has a line for each leaf
    {"Done.log", longest_log, TooLong::cut_at_front},
    {"Failed.message", longest_message, TooLong::cut},
    {"Failed.log", longest_log, TooLong::cut_at_front},
    {"FileChunk.bytes", std::size_t{1} << 20U},  // what is no chunk is asked for again
    {"Submit.job_toml", std::size_t{1} << 20U},  // as mesh/job_file/toml_limits.h
    {"Submit.name", 255},
    {"Submit.key", 255},
    {"Submit.surface_path", 4096},  // PATH_MAX
}};

constexpr std::array<CountLimit, 7> counts = {{
    {"Done.outputs", most_files},
    {"Done.numbers", 1 << 16},  // several for each region
    {"Done.texts", 1 << 16},
    {"Failed.evidence", 100},
    {"Failed.damaged_inputs", most_files},
    {"Submit.inputs", 100},
    {"Submit.after", 100},
}};

/// "Hello.host"; of the entries of a map "Done.texts" and "Done.texts.key".
std::string name_of(const FieldDescriptor& field) {
  const Descriptor& message = *field.containing_type();
  const Descriptor* outer = message.containing_type();
  for (int i = 0; outer != nullptr && i < outer->field_count(); ++i) {
    const FieldDescriptor& map = *outer->field(i);
    if (!map.is_map() || map.message_type() != &message) continue;
    return name_of(map) + (field.name() == "key" ? ".key" : "");
  }
  return message.name() + "." + field.name();
}

TextLimit limit_of(const FieldDescriptor& field) {
  const std::string name = name_of(field);
  for (const TextLimit& limit : texts) {
    if (limit.field == name) return limit;
  }
  return {"", most_bytes_of_text, TooLong::refused};
}

int most_of(const FieldDescriptor& field) {
  const std::string name = name_of(field);
  for (const CountLimit& limit : counts) {
    if (limit.field == name) return limit.most;
  }
  return most_of_field;
}

/// Looked up once for each field.
template <class Limit>
class Known {
 public:
  explicit Known(Limit (*look_up)(const FieldDescriptor&)) : look_up_(look_up) {}
  Limit of(const FieldDescriptor& field) {
    const auto found = limits_.find(&field);
    return found != limits_.end() ? found->second
                                  : limits_.emplace(&field, look_up_(field)).first->second;
  }

 private:
  Limit (*look_up_)(const FieldDescriptor&);
  std::unordered_map<const FieldDescriptor*, Limit> limits_;
};

std::string cut(const std::string& text, const TextLimit& limit) {
  TF_CHECK(text.size() > limit.most_bytes && limit.then != TooLong::refused);
  if (limit.then == TooLong::cut) return std::string(cut_utf8(text, limit.most_bytes));
  return text.substr(text.size() - limit.most_bytes);
}

class Walk {
 public:
  /// What is wrong in the message; "" when nothing is.
  std::string look_at(Message& message) {
    const Reflection& reflection = *message.GetReflection();
    std::vector<const FieldDescriptor*> fields;
    reflection.ListFields(message, &fields);
    for (const FieldDescriptor* field : fields) {
      std::string trouble = look_at(message, *field);
      if (!trouble.empty()) return trouble;
    }
    return {};
  }

 private:
  std::string look_at(Message& message, const FieldDescriptor& field) {
    const Reflection& reflection = *message.GetReflection();
    const bool is_text = field.cpp_type() == FieldDescriptor::CPPTYPE_STRING;
    const bool is_message = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (!field.is_repeated()) {
      if (is_text) return look_at_text(message, field, -1);
      return is_message ? look_at(*reflection.MutableMessage(&message, &field)) : "";
    }
    const int count = reflection.FieldSize(message, &field);
    if (count > counts_.of(field)) {
      return name_of(field) + " has " + std::to_string(count) + " entries, more than the " +
             std::to_string(counts_.of(field)) + " allowed";
    }
    for (int i = 0; i < count && (is_text || is_message); ++i) {
      std::string trouble = is_text
                                ? look_at_text(message, field, i)
                                : look_at(*reflection.MutableRepeatedMessage(&message, &field, i));
      if (!trouble.empty()) return trouble;
    }
    return {};
  }

  /// @param i of a repeated field; -1 of another.
  std::string look_at_text(Message& message, const FieldDescriptor& field, int i) {
    const Reflection& reflection = *message.GetReflection();
    std::string copy;
    TF_CHECK(field.is_repeated() == (i >= 0));
    const std::string& text =
        i < 0 ? reflection.GetStringReference(message, &field, &copy)
              : reflection.GetRepeatedStringReference(message, &field, i, &copy);
    const TextLimit limit = texts_.of(field);
    if (text.size() <= limit.most_bytes) return {};
    if (limit.then == TooLong::refused) {
      return name_of(field) + " has " + std::to_string(text.size()) + " bytes, more than the " +
             std::to_string(limit.most_bytes) + " allowed";
    }
    std::string rest = cut(text, limit);
    if (i < 0) {
      reflection.SetString(&message, &field, std::move(rest));
    } else {
      reflection.SetRepeatedString(&message, &field, i, std::move(rest));
    }
    return {};
  }

  Known<TextLimit> texts_{limit_of};
  Known<int> counts_{most_of};
};

}  // namespace

std::span<const TextLimit> text_limits() { return texts; }
std::span<const CountLimit> count_limits() { return counts; }

std::string apply_text_limits(wire::Envelope& envelope) {
  thread_local Walk walk;
  return walk.look_at(envelope);
}

}  // namespace tetfarm
