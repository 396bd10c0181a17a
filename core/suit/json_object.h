// SPDX-License-Identifier: Apache-2.0
// Reads the members of one JSON object and remembers the first mistake, so that a reader is a plain list of
// members. After a mistake every call returns its fallback; the caller looks at the error once, at the end.
// Missing and null are the same. Unknown members are ignored. Numbers must be finite.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/job/result.h"
#include "core/math/conventions.h"

namespace noctule {

class JsonObject {
public:
    /// `what` names the object in errors: "suit.json: board 'l_hand'".
    JsonObject(const nlohmann::json& json, std::string what, std::optional<Error>& first_error);

    /// Checks `format` and `version`: kUnreadable when it is something else or from a later major version.
    /// `is_not` and `remedy` tell of something else: "is not a suit", "Choose a file with a suit".
    void expectFormat(const std::string& format, int version, const char* is_not, const char* remedy);

    std::string text(const char* member);  ///< must be there and not be empty
    std::string textOr(const char* member, const std::string& fallback);
    /// As text() and textOr(), but what is longer than limits::kName is cut.
    std::string name(const char* member);
    std::string nameOr(const char* member, const std::string& fallback);
    std::string nullableName(const char* member);  ///< must be there; null is empty
    double number(const char* member);
    double numberOr(const char* member, double fallback);
    double positiveOr(const char* member, double fallback);
    std::optional<double> optionalPositive(const char* member);
    Vector3d vector(const char* member);
    std::optional<Vector3d> optionalVector(const char* member);
    Vector3d unitVector(const char* member);  ///< any length but zero; comes back as a unit vector
    Matrix3d matrix(const char* member);      ///< rows; must be invertible
    /// w,x,y,z of norm 1 within 1 %; comes back as a unit.
    std::optional<Quaterniond> optionalQuaternion(const char* member);
    Quaterniond quaternion(const char* member);
    /// Empty when missing and not required.
    nlohmann::json array(const char* member, bool required);
    nlohmann::json objectOrEmpty(const char* member);

    const std::string& what() const { return what_; }
    void setWhat(std::string what) { what_ = std::move(what); }
    void fail(ErrorKind kind, const char* member, const std::string& must);

private:
    const nlohmann::json* find(const char* member) const;
    bool present(const char* member);

    const nlohmann::json& json_;
    std::string what_;
    std::optional<Error>& first_error_;
};

}  // namespace noctule
