// SPDX-License-Identifier: Apache-2.0
#include "core/session/session_body.h"

#include "core/suit/json_object.h"

namespace noctule {

nlohmann::json toJson(const SessionBody& body) {
    nlohmann::json json{{"mesh", body.mesh},
                        {"blending", body.blending == Blending::kDualQuaternion ? "dual" : "linear"}};
    if (body.choices.bones)
        json["bones"] = toJson(*body.choices.bones);
    if (body.choices.landmarks)
        json["landmarks"] = toJson(*body.choices.landmarks);
    return json;
}

Result<SessionBody> sessionBodyFromJson(const nlohmann::json& json, const std::string& where) {
    SessionBody body;
    if (json.is_null())
        return body;
    std::optional<Error> error;
    JsonObject object(json, where, error);
    body.mesh = object.textOr("mesh", "");
    body.blending =
        object.textOr("blending", "linear") == "dual" ? Blending::kDualQuaternion : Blending::kLinear;
    if (error)
        return *error;
    if (json.contains("bones")) {
        auto bones = boneMapFromJson(json["bones"], where);
        if (!bones)
            return bones.error();
        body.choices.bones = std::move(*bones);
    }
    if (json.contains("landmarks")) {
        auto landmarks = landmarksFromJson(json["landmarks"], where);
        if (!landmarks)
            return landmarks.error();
        body.choices.landmarks = std::move(*landmarks);
    }
    return body;
}

std::string meshNameIn(const std::filesystem::path& folder, const std::filesystem::path& mesh) {
    const std::filesystem::path inside =
        mesh.lexically_normal().lexically_relative(folder.lexically_normal());
    return (inside.empty() || *inside.begin() == ".." ? mesh : inside).string();
}

}  // namespace noctule
