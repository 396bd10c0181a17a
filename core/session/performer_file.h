// SPDX-License-Identifier: Apache-2.0
// A performer as session.json holds it (README.md): name, notes, measures in metres, suit.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/session/session.h"

namespace noctule {

nlohmann::json toJson(const Performer& performer);
/// `where` names the file in errors (kUnreadable, kUnusable).
Result<Performer> performerFromJson(const nlohmann::json& json, const std::string& where);

/// The members of `json` that are not among `known`.
UnknownMembers unknownMembers(const nlohmann::json& json, std::initializer_list<const char*> known);

}  // namespace noctule
