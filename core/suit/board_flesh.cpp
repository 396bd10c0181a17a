// SPDX-License-Identifier: Apache-2.0
#include "core/suit/board_flesh.h"

#include "core/math/json.h"
#include "core/suit/json_object.h"

namespace noctule {
namespace {

nlohmann::json columnsOf(const Matrix36& matrix) {
    nlohmann::json list = nlohmann::json::array();
    for (Eigen::Index f = 0; f < 6; ++f)
        list.push_back(json::fromVector(matrix.col(f)));
    return list;
}

Matrix36 readColumns(JsonObject& json, const char* member) {
    const nlohmann::json list = json.array(member, true);
    Matrix36 matrix = Matrix36::Zero();
    for (size_t f = 0; f < 6; ++f) {
        const auto column = list.size() == 6 ? json::vector3(list[f]) : std::nullopt;
        if (!column) {
            json.fail(ErrorKind::kUnreadable, member, "must be six entries of three finite numbers");
            return Matrix36::Zero();
        }
        matrix.col(static_cast<Eigen::Index>(f)) = *column;
    }
    return matrix;
}

}  // namespace

nlohmann::json toJson(const BoardFlesh& flesh) {
    nlohmann::json joints = nlohmann::json::array();
    for (const std::string& joint : flesh.joints)
        joints.push_back(joint.empty() ? nlohmann::json() : nlohmann::json(joint));
    return {
        {"joints", joints}, {"tilt_rad", columnsOf(flesh.tilt_rad)}, {"shift_m", columnsOf(flesh.shift_m)}};
}

std::optional<BoardFlesh> fleshFromJson(const nlohmann::json& json, const std::string& where,
                                        std::optional<Error>& first_error) {
    if (json.empty())
        return std::nullopt;
    JsonObject object(json, where, first_error);
    BoardFlesh flesh;
    const nlohmann::json joints = object.array("joints", true);
    for (size_t end = 0; end < 2; ++end) {
        if (joints.size() != 2 || !(joints[end].is_string() || joints[end].is_null()))
            object.fail(ErrorKind::kUnreadable, "joints", "must be two names, null where there is none");
        else if (joints[end].is_string())
            flesh.joints[end] = joints[end].get<std::string>();
    }
    flesh.tilt_rad = readColumns(object, "tilt_rad");
    flesh.shift_m = readColumns(object, "shift_m");
    return flesh;
}

}  // namespace noctule
