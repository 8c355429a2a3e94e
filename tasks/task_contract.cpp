#include "tasks/task_contract.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Heap numbers of sub-domains have 63 bits.
constexpr std::uint64_t heap_limit = std::uint64_t{1} << 63U;

/// Depth first, a node before its children, left before right.
bool comes_before_in_tree(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t way_to_a = a << static_cast<unsigned>(std::countl_zero(a));
  const std::uint64_t way_to_b = b << static_cast<unsigned>(std::countl_zero(b));
  return way_to_a == way_to_b ? a < b : way_to_a < way_to_b;
}

std::vector<std::uint64_t> leaves_of(const std::vector<LeafFilesField>& fields, LeafOrder order) {
  std::vector<std::uint64_t> leaves;
  for (const LeafFilesField& field : fields) {
    for (const auto& [heap, file] : *field.files) leaves.push_back(heap);
  }
  std::sort(leaves.begin(), leaves.end(), [order](std::uint64_t a, std::uint64_t b) {
    if ((a == order.first) != (b == order.first)) return a == order.first;
    return order.of_tree ? comes_before_in_tree(a, b) : a < b;
  });
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

class WordsWriter final : public ContractFields {
 public:
  explicit WordsWriter(ContractSide side) : side_(side) {}

  void file(const char* name, TaskFile& file) override { words_.files.emplace_back(name, file); }
  void file(const char* name, std::optional<TaskFile>& file) override {
    if (file) words_.files.emplace_back(name, *file);
  }
  void files_by_leaf(std::vector<LeafFilesField> fields, LeafOrder order) override {
    for (const std::uint64_t heap : leaves_of(fields, order)) {
      for (const LeafFilesField& field : fields) {
        const auto file = field.files->find(heap);
        if (file == field.files->end()) continue;
        words_.files.emplace_back(field.prefix + std::to_string(heap), file->second);
      }
    }
  }
  void count(const char* name, std::uint64_t& value, std::uint64_t most) override {
    TF_CHECK(value <= most);
    if (side_ == ContractSide::given) {
      words_.texts[name] = std::to_string(value);
    } else {
      words_.numbers[name] = static_cast<double>(value);
    }
  }
  void count(const char* name, std::optional<std::uint64_t>& value, std::uint64_t most) override {
    if (value) count(name, *value, most);
  }
  void amount(const char* name, double& value) override {
    TF_CHECK(std::isfinite(value) && value >= 0);
    if (side_ == ContractSide::made) {
      words_.numbers[name] = value;
      return;
    }
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    words_.texts[name] = std::string(digits.data(), end);
  }
  void flag(const char* name, bool& value) override {
    std::uint64_t number = value ? 1 : 0;
    count(name, number, 1);
  }
  void text(const char* name, std::string& text) override { words_.texts[name] = text; }
  void text(const char* name, std::optional<std::string>& text) override {
    if (text) words_.texts[name] = *text;
  }

  TaskWords words() && { return std::move(words_); }

 private:
  ContractSide side_;
  TaskWords words_;
};

class WordsReader final : public ContractFields {
 public:
  WordsReader(const TaskWords& words, ContractSide side) : words_(words), side_(side) {
    for (const auto& [name, file] : words.files) {
      if (!files_.emplace(name, &file).second) refuse("the file '" + name + "' is there twice");
    }
  }

  void file(const char* name, TaskFile& file) override {
    const TaskFile* found = find_file(name);
    if (found == nullptr) return refuse("the file '" + std::string(name) + "' is missing");
    file = *found;
  }
  void file(const char* name, std::optional<TaskFile>& file) override {
    if (const TaskFile* found = find_file(name)) file = *found;
  }
  void files_by_leaf(std::vector<LeafFilesField> fields, LeafOrder /*order*/) override {
    for (const LeafFilesField& field : fields) {
      const std::string_view start = field.prefix;
      TF_CHECK(start.ends_with(':'));
      for (auto next = files_.lower_bound(start); next != files_.end(); ++next) {
        const std::string& name = next->first;
        if (!name.starts_with(start)) break;
        if (const auto heap = heap_of(name, start)) field.files->emplace(*heap, *next->second);
        used_.insert(name);
      }
    }
  }
  void count(const char* name, std::uint64_t& value, std::uint64_t most) override {
    if (!has_number(name)) return refuse("the number '" + std::string(name) + "' is missing");
    value = whole(name, most);
  }
  void count(const char* name, std::optional<std::uint64_t>& value, std::uint64_t most) override {
    if (has_number(name)) value = whole(name, most);
  }
  void amount(const char* name, double& value) override {
    if (!has_number(name)) return refuse("the number '" + std::string(name) + "' is missing");
    value = number(name);
  }
  void flag(const char* name, bool& value) override {
    std::uint64_t number = 0;
    count(name, number, 1);
    value = number == 1;
  }
  void text(const char* name, std::string& text) override {
    const auto found = words_.texts.find(name);
    if (found == words_.texts.end()) {
      return refuse("the text '" + std::string(name) + "' is missing");
    }
    text = found->second;
    used_.insert(name);
  }
  void text(const char* name, std::optional<std::string>& text) override {
    if (!words_.texts.contains(name)) return;
    text.emplace();
    this->text(name, *text);
  }

  /// Of what a task is given all has to be used: what it does not know might decide.
  void require_nothing_else() {
    if (side_ == ContractSide::made) return;
    for (const auto& [name, file] : files_) {
      if (!used_.contains(name)) refuse("the file '" + name + "' is unknown");
    }
    for (const auto& [name, text] : words_.texts) {
      if (!used_.contains(name)) refuse("the parameter '" + name + "' is unknown");
    }
  }

  const std::string& breach() const { return breach_; }

 private:
  void refuse(const std::string& what) {
    if (breach_.empty()) breach_ = what;
  }

  const TaskFile* find_file(const char* name) {
    const auto found = files_.find(std::string_view(name));
    if (found == files_.end()) return nullptr;
    used_.insert(name);
    return found->second;
  }

  std::optional<std::uint64_t> heap_of(const std::string& name, std::string_view prefix) {
    std::uint64_t heap = 0;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, heap);
    if (error != std::errc{} || stop != end || heap == 0 || heap >= heap_limit ||
        name[prefix.size()] == '0') {
      refuse("the file '" + name + "' is of no sub-domain");
      return std::nullopt;
    }
    return heap;
  }

  bool has_number(const char* name) {
    const bool has =
        side_ == ContractSide::given ? words_.texts.contains(name) : words_.numbers.contains(name);
    if (has) used_.insert(name);
    return has;
  }

  double number(const char* name) {
    double value = 0;
    if (side_ == ContractSide::made) {
      value = words_.numbers.at(name);
    } else {
      const std::string& text = words_.texts.at(name);
      const char* end = text.data() + text.size();
      const auto [stop, error] = std::from_chars(text.data(), end, value);
      if (error != std::errc{} || stop != end) return refuse_number(name, "'" + text + "'");
    }
    if (!std::isfinite(value) || value < 0) return refuse_number(name, std::to_string(value));
    return value;
  }

  std::uint64_t whole(const char* name, std::uint64_t most) {
    if (side_ == ContractSide::given) {
      const std::string& text = words_.texts.at(name);
      const auto count = whole_count(text, most);
      if (!count) refuse_number(name, "'" + text + "'");
      return count.value_or(0);
    }
    const double value = words_.numbers.at(name);
    const auto count = whole_count(value, most);
    if (!count) refuse_number(name, std::to_string(value));
    return count.value_or(0);
  }

  double refuse_number(const char* name, const std::string& value) {
    refuse("the number '" + std::string(name) + "' cannot be " + value);
    return 0;
  }

  const TaskWords& words_;
  ContractSide side_;
  std::map<std::string, const TaskFile*, std::less<>> files_;
  std::set<std::string, std::less<>> used_;
  std::string breach_;
};

/// Finds the name of the field that lies at an address.
class FieldNamer final : public ContractFields {
 public:
  explicit FieldNamer(const void* field) : field_(field) {}

  void file(const char* name, TaskFile& file) override { look(name, &file); }
  void file(const char* name, std::optional<TaskFile>& file) override { look(name, &file); }
  void files_by_leaf(std::vector<LeafFilesField> fields, LeafOrder /*order*/) override {
    for (const LeafFilesField& field : fields) look(field.prefix, field.files);
  }
  void count(const char* name, std::uint64_t& value, std::uint64_t /*most*/) override {
    look(name, &value);
  }
  void count(const char* name, std::optional<std::uint64_t>& value,
             std::uint64_t /*most*/) override {
    look(name, &value);
  }
  void amount(const char* name, double& value) override { look(name, &value); }
  void flag(const char* name, bool& value) override { look(name, &value); }
  void text(const char* name, std::string& text) override { look(name, &text); }
  void text(const char* name, std::optional<std::string>& text) override { look(name, &text); }

  const char* name() const { return name_; }

 private:
  void look(const char* name, const void* field) {
    if (field == field_) name_ = name;
  }

  const void* field_;
  const char* name_ = nullptr;
};

}  // namespace

TaskWords words_of(void* contract, DescribeContract describe, ContractSide side) {
  WordsWriter writer(side);
  describe(contract, writer);
  return std::move(writer).words();
}

std::string read_contract(const TaskWords& words, void* contract, DescribeContract describe,
                          ContractSide side) {
  WordsReader reader(words, side);
  describe(contract, reader);
  reader.require_nothing_else();
  return reader.breach();
}

const char* name_of_field(void* contract, DescribeContract describe, const void* field) {
  FieldNamer namer(field);
  describe(contract, namer);
  TF_CHECK(namer.name() != nullptr);
  return namer.name();
}

std::optional<std::uint64_t> whole_count(double value, std::uint64_t most) {
  TF_CHECK(most <= most_of_a_count);
  if (!(value >= 0 && value <= static_cast<double>(most)) || value != std::floor(value)) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(value);
}

std::optional<std::uint64_t> whole_count(const std::string& text, std::uint64_t most) {
  std::uint64_t count = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  const bool is_whole = error == std::errc{} && stop == end && count <= most;
  return is_whole ? std::optional(count) : std::nullopt;
}

}  // namespace tetfarm
