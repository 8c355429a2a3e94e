/// What a task is given and what it makes, as typed fields on both sides of the wire.
///
/// A contract is a struct with a member `describe`, which names each of its fields once; from that
/// come its words (names and values, as they travel and are kept in the database) and, out of
/// words, the struct. Whatever a contract does not allow is a breach, which names the field: what
/// is missing, is no number or is out of its bounds, and, of what a task is given, what nobody
/// asked for. Of what it made more numbers and texts may be there, for people. Each kind has its
/// two contracts in tasks/KIND_contract.h.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetfarm {

/// An immutable file of the store, under whatever name a task knows it.
struct TaskFile {
  std::string hash;
  std::uint64_t size = 0;

  friend bool operator==(const TaskFile&, const TaskFile&) = default;
};

/// A file of each leaf, or of some, by heap number: "mesh:5".
using LeafFiles = std::map<std::uint64_t, TaskFile>;

struct LeafFilesField {
  const char* prefix = "";  ///< ends in ':'
  LeafFiles* files = nullptr;
};

/// In which order the leaves are named.
struct LeafOrder {
  bool of_tree = false;     ///< depth first; otherwise by rising heap number
  std::uint64_t first = 0;  ///< this one before all others; 0: none
};

struct TaskWords {
  std::vector<std::pair<std::string, TaskFile>> files;  ///< in the order of the contract
  std::map<std::string, std::string> texts;             ///< of what is given also the numbers
  std::map<std::string, double> numbers;                ///< of what is made

  friend bool operator==(const TaskWords&, const TaskWords&) = default;
};

/// The most that a number may be where a contract names no other limit: all of them are exact.
inline constexpr std::uint64_t most_of_a_count = std::uint64_t{1} << 53U;

/// Leaves and groups of a job.
inline constexpr std::uint64_t most_parts = 1'000'000;

/// What `describe` calls, for each field. An optional one may be missing.
class ContractFields {
 public:
  ContractFields() = default;
  ContractFields(const ContractFields&) = delete;
  ContractFields& operator=(const ContractFields&) = delete;
  virtual ~ContractFields() = default;

  virtual void file(const char* name, TaskFile& file) = 0;
  virtual void file(const char* name, std::optional<TaskFile>& file) = 0;
  /// Leaf by leaf, of each leaf in the order of the fields: "core:4", "elements:4", "core:5" … None
  /// at all is allowed.
  virtual void files_by_leaf(std::vector<LeafFilesField> fields, LeafOrder order) = 0;
  /// A whole number from 0 to `most`.
  virtual void count(const char* name, std::uint64_t& value, std::uint64_t most) = 0;
  virtual void count(const char* name, std::optional<std::uint64_t>& value, std::uint64_t most) = 0;
  /// A finite number that is not negative.
  virtual void amount(const char* name, double& value) = 0;
  virtual void flag(const char* name, bool& value) = 0;
  virtual void text(const char* name, std::string& text) = 0;
  virtual void text(const char* name, std::optional<std::string>& text) = 0;

  void files(const char* prefix, LeafFiles& files) { files_by_leaf({{prefix, &files}}, {}); }
  void files_by_leaf(std::vector<LeafFilesField> fields) { files_by_leaf(std::move(fields), {}); }
  void count(const char* name, std::uint64_t& value) { count(name, value, most_of_a_count); }
  void count(const char* name, std::optional<std::uint64_t>& value) {
    count(name, value, most_of_a_count);
  }
};

/// How numbers travel.
enum class ContractSide {
  given,  ///< among the texts, as decimals
  made,   ///< as numbers
};

using DescribeContract = void (*)(void* contract, ContractFields& fields);

/// What the templates below do. `contract` is not changed when words are made.
TaskWords words_of(void* contract, DescribeContract describe, ContractSide side);
std::string read_contract(const TaskWords& words, void* contract, DescribeContract describe,
                          ContractSide side);

const char* name_of_field(void* contract, DescribeContract describe, const void* field);

template <class Contract>
void describe_contract(void* contract, ContractFields& fields) {
  static_cast<Contract*>(contract)->describe(fields);
}

/// @pre its numbers are within their bounds. Cost: O(fields and files).
template <class Contract>
TaskWords to_words(Contract contract) {
  return words_of(&contract, &describe_contract<Contract>, Contract::side);
}

/// What words say, as far as they keep to the contract.
template <class Contract>
struct ContractReading {
  Contract contract;
  std::string breach;  ///< the first one: "the number 'work' is missing"; "": none
};

/// Cost: O(n log n) for n words.
template <class Contract>
ContractReading<Contract> from_words(const TaskWords& words) {
  ContractReading<Contract> reading;
  reading.breach =
      read_contract(words, &reading.contract, &describe_contract<Contract>, Contract::side);
  return reading;
}

/// The name under which a field of the contract travels, of files of leaves the prefix: for who
/// wants one field of many. @pre `describe` names it, whatever else is there. Cost: O(fields).
template <class Contract, class Field>
const char* field_name(Field Contract::*field) {
  Contract contract;
  return name_of_field(&contract, &describe_contract<Contract>, &(contract.*field));
}

/// A whole number from 0 to `most` out of the text or number that travelled; nothing where it is
/// none. Cost: O(digits).
std::optional<std::uint64_t> whole_count(double value, std::uint64_t most = most_of_a_count);
std::optional<std::uint64_t> whole_count(const std::string& text,
                                         std::uint64_t most = most_of_a_count);

}  // namespace tetfarm
