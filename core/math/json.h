// SPDX-License-Identifier: Apache-2.0
// Parsing JSON from outside and reading small members of it without exceptions: every function returns false
// (or nothing) when the member is missing, of another type or not finite, and the caller names the thing in
// its error.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/job/limits.h"
#include "core/math/conventions.h"

namespace noctule::json {

using Json = nlohmann::json;

/// Whether no list or object lies deeper than limits::kJsonDepth: copying and writing JSON call themselves.
inline bool isShallow(std::string_view text) {
    int depth = 0;
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"')
            quoted = !quoted;
        else if (quoted)
            i += c == '\\';
        else if (c == '[' || c == '{')
            ++depth;
        else if (c == ']' || c == '}')
            --depth;
        if (depth > limits::kJsonDepth)
            return false;
    }
    return true;
}

/// Text from outside; discarded when it is no JSON, too long or too deep.
inline Json parse(std::string_view text) {
    if (text.size() > limits::kJsonBytes || !isShallow(text))
        return Json::value_t::discarded;
    return Json::parse(text, nullptr, false);
}

/// Null for what is missing or not finite.
template <class T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}
inline Json orNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}
inline Json orNull(const std::optional<double>& value) {
    return value ? orNull(*value) : Json(nullptr);
}
/// Null for no text.
inline Json textOrNull(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

/// A finite number.
inline std::optional<double> number(const Json& value) {
    if (!value.is_number())
        return std::nullopt;
    const double d = value.get<double>();
    return std::isfinite(d) ? std::optional<double>(d) : std::nullopt;
}

inline std::optional<double> number(const Json& object, const char* member) {
    const auto found = object.is_object() ? object.find(member) : object.end();
    return found == object.end() ? std::nullopt : number(*found);
}

inline std::optional<std::string> text(const Json& object, const char* member) {
    const auto found = object.is_object() ? object.find(member) : object.end();
    return found == object.end() || !found->is_string()
               ? std::nullopt
               : std::optional<std::string>(found->get<std::string>());
}

/// [x, y, z], all finite.
inline std::optional<Vector3d> vector3(const Json& value) {
    if (!value.is_array() || value.size() != 3)
        return std::nullopt;
    Vector3d v;
    for (int i = 0; i < 3; ++i) {
        const auto d = number(value[static_cast<size_t>(i)]);
        if (!d)
            return std::nullopt;
        v[i] = *d;
    }
    return v;
}

inline std::optional<Vector3d> vector3(const Json& object, const char* member) {
    const auto found = object.is_object() ? object.find(member) : object.end();
    return found == object.end() ? std::nullopt : vector3(*found);
}

/// [w, x, y, z]; normalised; nothing when its norm is not 1 within 1 %.
inline std::optional<Quaterniond> quaternion(const Json& value) {
    if (!value.is_array() || value.size() != 4)
        return std::nullopt;
    double c[4];
    for (size_t i = 0; i < 4; ++i) {
        const auto d = number(value[i]);
        if (!d)
            return std::nullopt;
        c[i] = *d;
    }
    const Quaterniond q(c[0], c[1], c[2], c[3]);
    const double deviation = std::abs(q.norm() - 1);
    if (deviation > 0.01)
        return std::nullopt;
    return deviation < 1e-12 ? q : q.normalized();  // what was unit stays the same to the bit
}

inline std::optional<Quaterniond> quaternion(const Json& object, const char* member) {
    const auto found = object.is_object() ? object.find(member) : object.end();
    return found == object.end() ? std::nullopt : quaternion(*found);
}

inline Json fromVector(const Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}
inline Json fromQuaternion(const Quaterniond& q) {
    return Json::array({q.w(), q.x(), q.y(), q.z()});
}

}  // namespace noctule::json
