/// What `tetfarm doctor` finds out about addresses: whether a coordinator answers at one, which
/// program it is, and what its clock says; whether a coordinator could listen at one, and who does
/// already.
#pragma once

#include <cstdint>
#include <string>

#include "cli/command_line.h"
#include "cli/findings.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// What asking took, by our clocks.
struct AskedWhen {
  std::int64_t wall_ms = 0;  ///< in the middle
  std::int64_t took_ms = 0;
};

/// What a coordinator's answer tells of it. @param endpoint where it answered
Findings findings_of_coordinator(const std::string& endpoint, const wire::StatusReply& farm,
                                 const AskedWhen& asked);

/// Asks it. @param store that it uses, for its key; may be empty. @throws Error when it is not
/// there, or does not want to speak with us.
Findings look_at_coordinator(const ClientOptions& client, const std::string& store);

/// Whether a coordinator could listen there. @throws UsageError for what is no address.
Finding look_at_listening(const std::string& endpoint);

}  // namespace tetfarm
