/// Who may send what: the roles of those who hold a key, and the one table of messages.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

enum class Role {
  worker,     ///< takes tasks and gives results
  submitter,  ///< submits, fetches results, cancels and looks
  viewer,     ///< looks
};

inline constexpr std::array<Role, 3> all_roles = {Role::worker, Role::submitter, Role::viewer};

const char* name_of(Role role);
std::optional<Role> role_of_name(const std::string& name);

/// Whether a peer of that role may send a message of that kind to the coordinator. What only the
/// coordinator says, and kinds that the table does not know, nobody may.
bool may_send(Role role, wire::Envelope::BodyCase kind);

/// The same of a message: files of an attempt are workers' business, those of no attempt clients'.
bool may_send(Role role, const wire::Envelope& envelope);

/// Whether it is about a file of a client: a result of a job, or a surface.
bool is_of_client(const wire::Envelope& envelope);

/// Whether anybody may send it to the coordinator.
bool is_for_the_coordinator(wire::Envelope::BodyCase kind);

/// The field's name in messages.proto: "submit".
std::string name_of(wire::Envelope::BodyCase kind);

}  // namespace tetfarm
