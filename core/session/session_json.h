// SPDX-License-Identifier: Apache-2.0
// session.json as a document, without the folder (README.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/session/session.h"

namespace noctule {

inline constexpr int kSessionVersion = 1;

nlohmann::json toJson(const Session& session);
/// `where` names the file in errors: kUnreadable when it is damaged, kUnusable when a newer program wrote it.
Result<Session> sessionFromJson(const nlohmann::json& json, const std::string& where);
Result<Session> sessionFromText(const std::string& text, const std::string& where);

}  // namespace noctule
