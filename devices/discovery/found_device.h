// SPDX-License-Identifier: Apache-2.0
// What discovery knows about a device before anybody connects: numbers are 0 and texts empty where it does
// not know.
#pragma once

#include <string>

namespace noctule {

struct FoundDevice {
    enum class Contact {
        kAnswers,   ///< it said itself what stands here
        kNotAsked,  ///< a serial port that may lead to a box; name and model are those of its USB plug
        kAsking,    ///< being probed
        kSilent,    ///< probed, and no box answered
    };

    std::string address;  ///< for makeDevice()
    std::string serial;   ///< by which a box is remembered: its address may change
    std::string name;
    std::string model;
    int boards = 0;
    int sources = 0;
    int sample_rate_hz = 0;
    bool busy = false;  ///< another studio has it
    Contact contact = Contact::kAnswers;

    bool operator==(const FoundDevice&) const = default;
};

}  // namespace noctule
