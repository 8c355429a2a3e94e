#include "cli/read_ahead.h"

#include "base/check.h"

namespace tetfarm {

ReadAhead::ReadAhead(std::unique_ptr<MeshSource> source) : source_(std::move(source)) {
  TF_CHECK(source_->takes_threads());
}

NumberedPart ReadAhead::part(std::size_t i) const {
  std::future<NumberedPart> here = std::move(next_);
  const bool is_read = here.valid() && ahead_ == i;
  if (here.valid()) here.wait();
  NumberedPart part = is_read ? here.get() : source_->part(i);
  if (i + 1 < size()) {
    ahead_ = i + 1;
    next_ = std::async(std::launch::async, [this, i] { return source_->part(i + 1); });
  }
  return part;
}

}  // namespace tetfarm
