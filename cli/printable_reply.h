/// Replies of the coordinator for people: every text in them came from somewhere else, and must
/// stay within its line.
#pragma once

#include <google/protobuf/message.h>

namespace tetfarm {

/// Makes every text in the message printable (base/printable_text.h), those in lists and maps too;
/// the logs of attempts keep their lines. Not for JSON, which escapes by itself.
void make_printable(google::protobuf::Message& message);

/// A copy of it, printable.
template <class Message>
Message printable_reply(Message message) {
  make_printable(message);
  return message;
}

}  // namespace tetfarm
