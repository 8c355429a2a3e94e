#include "mesh/formats/openfoam/processor_numbers.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {

void ProcessorNumbers::refuse(std::int32_t a, std::int32_t b, const std::string& what) const {
  throw InvalidInput("processors " + std::to_string(a) + " and " + std::to_string(b) + " " + what,
                     name_);
}

std::vector<ProcessorNumbers::Ids> ProcessorNumbers::ids_of(const Processor& processor,
                                                            const ProcessorPatch& patch) const {
  const auto id_of = [&](std::int32_t node) {
    const auto found = std::lower_bound(processor.shared.begin(), processor.shared.end(), node);
    TF_CHECK(found != processor.shared.end() && *found == node);
    return static_cast<std::int64_t>(processor.first_id) + (found - processor.shared.begin());
  };
  std::vector<Ids> ids;
  ids.reserve(patch.faces.size());
  for (const FaceNodes<std::int32_t>& face : patch.faces) ids.push_back(face.renumbered(id_of));
  return ids;
}

void ProcessorNumbers::add(std::int64_t nodes, const std::vector<ProcessorPatch>& patches) {
  const auto here = static_cast<std::int32_t>(processors_.size());
  Processor processor;
  processor.nodes = nodes;
  processor.first_id = parent_.size();
  std::vector<std::int32_t>& shared = processor.shared;
  for (const ProcessorPatch& patch : patches) {
    for (const auto& face : patch.faces) shared.insert(shared.end(), face.begin(), face.end());
  }
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  shared.shrink_to_fit();
  for (std::size_t i = 0; i < shared.size(); ++i) parent_.push_back(parent_.size());
  for (const ProcessorPatch& patch : patches) {
    std::vector<Ids> ids = ids_of(processor, patch);
    if (patch.neighbour < here) {
      join(patch.neighbour, here, ids);
    } else if (patch.neighbour == here ||
               !waiting_.emplace(std::pair(here, patch.neighbour), std::move(ids)).second) {
      refuse(here, patch.neighbour, "do not have exactly one patch between them");
    }
  }
  processors_.push_back(std::move(processor));
}

void ProcessorNumbers::join(std::int32_t lower, std::int32_t higher, const std::vector<Ids>& here) {
  const auto there = waiting_.find({lower, higher});
  if (there == waiting_.end()) refuse(lower, higher, "do not have exactly one patch between them");
  if (there->second.size() != here.size()) {
    refuse(lower, higher,
           "have " + std::to_string(there->second.size()) + " and " + std::to_string(here.size()) +
               " faces between them");
  }
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Ids& theirs = there->second[i];
    const Ids ours = here[i].turned();
    if (theirs.size() != ours.size()) {
      refuse(lower, higher, "have a triangle and a quad in the same place between them");
    }
    for (std::size_t k = 0; k < ours.size(); ++k) {
      unite(static_cast<std::size_t>(theirs[k]), static_cast<std::size_t>(ours[k]));
    }
  }
  waiting_.erase(there);
}

std::size_t ProcessorNumbers::root_of(std::size_t id) {
  while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
  return id;
}

void ProcessorNumbers::unite(std::size_t a, std::size_t b) {
  const auto [lower, higher] = std::minmax({root_of(a), root_of(b)});
  parent_[higher] = lower;
}

void ProcessorNumbers::finish() {
  if (!waiting_.empty()) {
    const auto [lower, higher] = waiting_.begin()->first;
    refuse(lower, higher, "do not have exactly one patch between them");
  }
  number_.resize(parent_.size());
  std::int64_t next = 0;
  for (Processor& processor : processors_) number(processor, next);
}

void ProcessorNumbers::number(Processor& processor, std::int64_t& next) {
  processor.first_number = next;
  std::vector<std::int64_t> numbers;
  std::int64_t known = 0;
  for (std::size_t i = 0; i < processor.shared.size(); ++i) {
    const std::size_t id = processor.first_id + i;
    const std::size_t root = root_of(id);
    if (root == id) {
      number_[id] = next + processor.shared[i] - known;
    } else {
      number_[id] = number_[root];
      ++known;
    }
    numbers.push_back(number_[id]);
  }
  next += processor.nodes - known;
  std::sort(numbers.begin(), numbers.end());
  if (std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end()) return;
  throw InvalidInput("two points of processor " + std::to_string(&processor - processors_.data()) +
                         " coincide by the faces between processors",
                     name_);
}

std::vector<std::int64_t> ProcessorNumbers::local2global(std::size_t index) const {
  TF_CHECK(number_.size() == parent_.size());  // finish() came before
  const Processor& processor = processors_.at(index);
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(processor.nodes), -1);
  for (std::size_t i = 0; i < processor.shared.size(); ++i) {
    const std::size_t id = processor.first_id + i;
    if (parent_[id] == id) continue;
    numbers[static_cast<std::size_t>(processor.shared[i])] = number_[id];
  }
  std::int64_t next = processor.first_number;
  for (std::int64_t& number : numbers) {
    if (number < 0) number = next++;
  }
  return numbers;
}

}  // namespace tetfarm
