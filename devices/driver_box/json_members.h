// SPDX-License-Identifier: Apache-2.0
// Reads the members of a JSON payload and remembers the first that is not what it should be, so that a reader
// is a plain list of members: look at firstBad() once, at the end. Missing and null are the same; unknown
// members are ignored. Numbers must be finite and lie between the given limits. README.md, sections 2, 3
// and 5.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "devices/driver_box/wire.h"

namespace noctule::link {

inline constexpr int kHighestSampleRate_hz = 10'000'000;

/// Discarded when the payload is no JSON object. What is nested deeper than any suit is left out.
nlohmann::json parseObject(ByteView payload);
Bytes toBytes(const nlohmann::json& json);

/// kUnreadable: `where` sent something that is not what it should be.
Error damagedMessage(const std::string& where, const std::string& what);
/// To be asked first: of another protocol no other member can be trusted. `message`: "HELLO".
std::optional<Error> refusedProtocol(const nlohmann::json& json, const std::string& where,
                                     const std::string& message);

class JsonMembers {
public:
    /// The object must outlive this reader.
    explicit JsonMembers(const nlohmann::json& object) : object_(object) {}

    std::string text(const char* name);
    std::string requiredText(const char* name);  ///< not empty
    double real(const char* name, double fallback, double lowest, double highest);
    int integer(const char* name, int fallback, int lowest, int highest);
    std::vector<int> integers(const char* name, int lowest, int highest, size_t most);
    std::vector<std::string> texts(const char* name, size_t most);  ///< other entries are left out
    bool flag(const char* name);                                    ///< false when missing
    bool has(const char* name) const { return find(name) != nullptr; }

    /// The name of the first member that is not what it should be; empty: all are good.
    const std::string& firstBad() const { return first_bad_; }

private:
    const nlohmann::json* find(const char* name) const;
    /// Empty when missing, and when it is none or longer than `most`, which is bad.
    const nlohmann::json& array(const char* name, size_t most);
    double checked(const nlohmann::json* value, const char* name, double fallback, double lowest,
                   double highest);
    int whole(const nlohmann::json* value, const char* name, int fallback, int lowest, int highest);
    void bad(const char* name);

    const nlohmann::json& object_;
    std::string first_bad_;
};

}  // namespace noctule::link
