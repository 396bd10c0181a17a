// SPDX-License-Identifier: Apache-2.0
#include "core/suit/json_object.h"

#include <Eigen/LU>
#include <cmath>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"

namespace noctule {

namespace {

// Files carry units with few digits; what is a unit to rounding stays bit for bit, so that reading what we
// wrote changes nothing.
constexpr double kUnitTolerance = 1e-12;
constexpr double kShortest = 1e-6;

}  // namespace

JsonObject::JsonObject(const nlohmann::json& json, std::string what, std::optional<Error>& first_error)
    : json_(json), what_(std::move(what)), first_error_(first_error) {
    if (!json_.is_object() && !first_error_)
        first_error_ = Error{ErrorKind::kUnreadable, what_ + ": is not a JSON object",
                             "See core/recording/README.md for the format"};
}

void JsonObject::fail(ErrorKind kind, const char* member, const std::string& must) {
    if (!first_error_)
        first_error_ = Error{kind, what_ + ": '" + member + "' " + must, "Correct this member and try again"};
}

const nlohmann::json* JsonObject::find(const char* member) const {
    if (first_error_ || !json_.is_object())
        return nullptr;
    const auto found = json_.find(member);
    return found == json_.end() || found->is_null() ? nullptr : &*found;
}

bool JsonObject::present(const char* member) {
    if (find(member))
        return true;
    fail(ErrorKind::kUnreadable, member, "is missing");
    return false;
}

void JsonObject::expectFormat(const std::string& format, int version, const char* is_not,
                              const char* remedy) {
    const nlohmann::json* found_format = find("format");
    if (!first_error_ && (!found_format || *found_format != format))
        first_error_ = Error{ErrorKind::kUnreadable, what_ + ": " + is_not, remedy};
    const double found = numberOr("version", version);
    if (found >= version + 1 || found < version)
        fail(ErrorKind::kUnreadable, "version", "must be " + std::to_string(version) + " in this program");
}

std::string JsonObject::text(const char* member) {
    const std::string value = present(member) ? textOr(member, "") : "";
    if (value.empty())
        fail(ErrorKind::kUnreadable, member, "must not be empty");
    return value;
}

std::string JsonObject::textOr(const char* member, const std::string& fallback) {
    const nlohmann::json* found = find(member);
    if (!found)
        return fallback;
    if (found->is_string())
        return found->get<std::string>();
    fail(ErrorKind::kUnreadable, member, "must be text");
    return fallback;
}

std::string JsonObject::name(const char* member) {
    return shortText(text(member), limits::kName);
}

std::string JsonObject::nameOr(const char* member, const std::string& fallback) {
    return shortText(textOr(member, fallback), limits::kName);
}

std::string JsonObject::nullableName(const char* member) {
    if (!first_error_ && !json_.contains(member))
        fail(ErrorKind::kUnreadable, member, "is missing");
    return nameOr(member, "");
}

double JsonObject::number(const char* member) {
    return present(member) ? numberOr(member, 0) : 0;
}

double JsonObject::numberOr(const char* member, double fallback) {
    const nlohmann::json* found = find(member);
    const auto value = found ? json::number(*found) : fallback;
    if (!value)
        fail(ErrorKind::kUnreadable, member, "must be a finite number");
    return value.value_or(fallback);
}

double JsonObject::positiveOr(const char* member, double fallback) {
    const double value = numberOr(member, fallback);
    if (!(value > 0))
        fail(ErrorKind::kUnusable, member, "must be greater than zero");
    return value;
}

std::optional<double> JsonObject::optionalPositive(const char* member) {
    if (!find(member))
        return std::nullopt;
    return positiveOr(member, 1);
}

Vector3d JsonObject::vector(const char* member) {
    return present(member) ? optionalVector(member).value_or(Vector3d::Zero()) : Vector3d::Zero();
}

std::optional<Vector3d> JsonObject::optionalVector(const char* member) {
    const nlohmann::json* found = find(member);
    const auto value = found ? json::vector3(*found) : std::nullopt;
    if (found && !value)
        fail(ErrorKind::kUnreadable, member, "must be three finite numbers");
    return value;
}

Vector3d JsonObject::unitVector(const char* member) {
    const Vector3d value = vector(member);
    const double length = value.norm();
    if (!(length > kShortest) || !std::isfinite(length)) {
        fail(ErrorKind::kUnusable, member, "must have a direction, its length is zero");
        return Vector3d::UnitZ();
    }
    return std::abs(length - 1) < kUnitTolerance ? value : Vector3d(value / length);
}

Matrix3d JsonObject::matrix(const char* member) {
    const nlohmann::json rows = array(member, true);
    Matrix3d value = Matrix3d::Identity();
    for (size_t row = 0; row < 3; ++row) {
        const auto entries = rows.size() == 3 ? json::vector3(rows[row]) : std::nullopt;
        if (!entries) {
            fail(ErrorKind::kUnreadable, member, "must be three rows of three finite numbers");
            return Matrix3d::Identity();
        }
        value.row(static_cast<int>(row)) = entries->transpose();
    }
    // Scaled by its size: these matrices hold scales of 1e-2 and less.
    const double size = value.cwiseAbs().maxCoeff();
    if (!(size > 0) || !(std::abs((value / size).determinant()) > 1e-9))
        fail(ErrorKind::kUnusable, member, "must be invertible");
    return value;
}

std::optional<Quaterniond> JsonObject::optionalQuaternion(const char* member) {
    const nlohmann::json* found = find(member);
    const auto value = found ? json::quaternion(*found) : std::nullopt;
    if (found && !value)
        fail(ErrorKind::kUnreadable, member, "must be a unit quaternion w, x, y, z");
    return value;
}

Quaterniond JsonObject::quaternion(const char* member) {
    return present(member) ? optionalQuaternion(member).value_or(Quaterniond::Identity())
                           : Quaterniond::Identity();
}

nlohmann::json JsonObject::array(const char* member, bool required) {
    if (required && !present(member))
        return nlohmann::json::array();
    const nlohmann::json* found = find(member);
    if (found && !found->is_array())
        fail(ErrorKind::kUnreadable, member, "must be a list");
    return found && found->is_array() ? *found : nlohmann::json::array();
}

nlohmann::json JsonObject::objectOrEmpty(const char* member) {
    const nlohmann::json* found = find(member);
    if (found && !found->is_object())
        fail(ErrorKind::kUnreadable, member, "must be an object");
    return found && found->is_object() ? *found : nlohmann::json::object();
}

}  // namespace noctule
