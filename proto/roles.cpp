#include "proto/roles.h"

#include <algorithm>

namespace tetfarm {
namespace {

using Kind = wire::Envelope;

struct Permission {
  wire::Envelope::BodyCase kind;
  bool worker;
  bool submitter;
  bool viewer;
};

constexpr std::array<Permission, 16> permissions = {{
    // kind                 worker submitter viewer
    {Kind::kHello, true, false, false},
    {Kind::kReady, true, false, false},
    {Kind::kDone, true, false, false},
    {Kind::kFailed, true, false, false},
    {Kind::kHeartbeat, true, false, false},
    {Kind::kGoodbye, true, false, false},
    {Kind::kFetchFile, true, true, false},
    {Kind::kOfferFile, true, true, false},
    {Kind::kFileChunk, true, true, false},
    {Kind::kSubmit, false, true, false},
    {Kind::kCancel, false, true, false},
    {Kind::kRetry, false, true, false},
    {Kind::kSetPriority, false, true, false},
    {Kind::kDrainWorkers, false, true, false},
    {Kind::kStatusRequest, false, true, true},
    {Kind::kQuery, false, true, true},
}};

const Permission* find(wire::Envelope::BodyCase kind) {
  const auto* const found = std::find_if(permissions.begin(), permissions.end(),
                                         [&](const Permission& line) { return line.kind == kind; });
  return found == permissions.end() ? nullptr : found;
}

}  // namespace

const char* name_of(Role role) {
  switch (role) {
    case Role::worker:
      return "worker";
    case Role::submitter:
      return "submitter";
    case Role::viewer:
      return "viewer";
  }
  return "nobody";
}

std::optional<Role> role_of_name(const std::string& name) {
  for (const Role role : all_roles) {
    if (name == name_of(role)) return role;
  }
  return std::nullopt;
}

bool may_send(Role role, wire::Envelope::BodyCase kind) {
  const Permission* line = find(kind);
  if (line == nullptr) return false;
  switch (role) {
    case Role::worker:
      return line->worker;
    case Role::submitter:
      return line->submitter;
    case Role::viewer:
      return line->viewer;
  }
  return false;
}

bool is_of_client(const wire::Envelope& envelope) {
  switch (envelope.body_case()) {
    case wire::Envelope::kFetchFile:
      return envelope.fetch_file().attempt() == 0;
    case wire::Envelope::kOfferFile:
      return envelope.offer_file().attempt() == 0;
    case wire::Envelope::kFileChunk:
      return envelope.file_chunk().attempt() == 0;
    default:
      return false;
  }
}

bool may_send(Role role, const wire::Envelope& envelope) {
  if (!may_send(role, envelope.body_case())) return false;
  switch (envelope.body_case()) {
    case wire::Envelope::kFetchFile:
    case wire::Envelope::kOfferFile:
    case wire::Envelope::kFileChunk:
      return is_of_client(envelope) == (role == Role::submitter);
    default:
      return true;
  }
}

bool is_for_the_coordinator(wire::Envelope::BodyCase kind) { return find(kind) != nullptr; }

std::string name_of(wire::Envelope::BodyCase kind) {
  const auto* field = wire::Envelope::descriptor()->FindFieldByNumber(static_cast<int>(kind));
  return field == nullptr ? "nothing" : field->name();
}

}  // namespace tetfarm
