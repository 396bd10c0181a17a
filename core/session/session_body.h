// SPDX-License-Identifier: Apache-2.0
// The body that a session's views, pictures and exports show.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/mesh/rig/wearable.h"
#include "core/mesh/skinning.h"

namespace noctule {

struct SessionBody {
    /// Of its file, as chosen; empty: Noctule's own body. Within the session's folder it is relative to that.
    std::string mesh;
    WearingChoices choices;  ///< what was set by hand
    Blending blending = Blending::kLinear;

    bool operator==(const SessionBody&) const = default;
    bool isOurs() const { return mesh.empty(); }
    std::filesystem::path pathIn(const std::filesystem::path& folder) const { return folder / mesh; }
};

nlohmann::json toJson(const SessionBody& body);
/// kUnreadable; null is Noctule's own body.
Result<SessionBody> sessionBodyFromJson(const nlohmann::json& json, const std::string& where);

/// How a session in `folder` names this file.
std::string meshNameIn(const std::filesystem::path& folder, const std::filesystem::path& mesh);

}  // namespace noctule
