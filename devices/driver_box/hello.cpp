// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/hello.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "devices/driver_box/json_members.h"

namespace noctule::link {

namespace {

using Json = nlohmann::json;

constexpr size_t kMostFeatures = 64;

struct Placement {
    const char* list;
    const char* position;
    const char* direction;
    Json no_direction;
};

const std::vector<Placement>& placements() {
    static const std::vector<Placement> kPlacements = {
        {"boards", "p_segment_board_m", "q_segment_board", Json::array({1, 0, 0, 0})},
        {"sources", "p_segment_source_m", "normal_segment", Json::array({0, 0, 1})}};
    return kPlacements;
}

/// A box that knows serial numbers only leaves positions out or null: they become zeros. True when all were
/// there.
bool fillPlaces(Json& suit) {
    bool placed = true;
    for (const Placement& placement : placements()) {
        const auto list = suit.is_object() ? suit.find(placement.list) : suit.end();
        if (!suit.is_object() || list == suit.end() || !list->is_array())
            continue;
        for (Json& part : *list) {
            if (!part.is_object())
                continue;
            const bool has_position =
                part.contains(placement.position) && !part[placement.position].is_null();
            const bool has_direction =
                part.contains(placement.direction) && !part[placement.direction].is_null();
            if (has_position && has_direction)
                continue;
            placed = false;
            part["segment"] = nullptr;
            part[placement.position] = Json::array({0, 0, 0});
            part[placement.direction] = placement.no_direction;
        }
    }
    return placed;
}

void dropPlaces(Json& suit) {
    for (const Placement& placement : placements())
        for (Json& part : suit[placement.list])
            part["segment"] = part[placement.position] = part[placement.direction] = nullptr;
}

template <class Part>
bool placePart(Part& part, const std::vector<Part>& own) {
    const auto found = std::find_if(own.begin(), own.end(), [&](const Part& candidate) {
        return candidate.serial == part.serial && (!part.serial.empty() || candidate.id == part.id);
    });
    if (found == own.end())
        return false;
    part = *found;
    return true;
}

}  // namespace

bool Hello::hasFeature(const std::string& feature) const {
    return std::find(features.begin(), features.end(), feature) != features.end();
}

Bytes toPayload(const Hello& hello) {
    Json suit = toJson(hello.suit);
    if (!hello.suit_is_placed)
        dropPlaces(suit);
    return toBytes({{"protocol", kProtocol},
                    {"minor", hello.minor},
                    {"model", hello.model},
                    {"serial", hello.serial},
                    {"firmware", hello.firmware},
                    {"name", hello.name},
                    {"sample_rate_hz", hello.sample_rate_hz},
                    {"adc_bits", hello.adc_bits},
                    {"pulse_interval_samples", hello.pulse_interval_samples},
                    {"pulse_cycles", hello.pulse_cycles},
                    {"drive_hz", hello.drive_hz},
                    {"streaming", hello.streaming},
                    {"features", hello.features},
                    {"suit", suit}});
}

Result<Hello> readHello(ByteView payload, const std::string& where) {
    Json json = parseObject(payload);
    if (json.is_discarded())
        return damagedMessage(where, "HELLO is no JSON object");
    if (const auto refused = refusedProtocol(json, where, "HELLO"))
        return *refused;
    JsonMembers members(json);
    Hello hello;
    hello.minor = members.integer("minor", 0, 0, 1'000'000);
    hello.model = members.text("model");
    hello.serial = members.requiredText("serial");
    hello.firmware = members.text("firmware");
    hello.name = members.text("name");
    hello.sample_rate_hz = members.integer("sample_rate_hz", 0, 1, kHighestSampleRate_hz);
    hello.adc_bits = members.integer("adc_bits", hello.adc_bits, 1, 16);
    hello.pulse_interval_samples =
        members.integer("pulse_interval_samples", hello.pulse_interval_samples, 1, kHighestSampleRate_hz);
    hello.pulse_cycles = members.integer("pulse_cycles", hello.pulse_cycles, 1, 10'000);
    hello.drive_hz = members.real("drive_hz", hello.drive_hz, 1, kHighestSampleRate_hz);
    hello.streaming = members.flag("streaming");
    hello.features = members.texts("features", kMostFeatures);
    if (!members.firstBad().empty())
        return damagedMessage(where,
                              "HELLO: '" + members.firstBad() + "' is missing or not what it should be");
    Json& suit_json = json["suit"];
    hello.suit_is_placed = fillPlaces(suit_json);
    Result<Suit> suit = suitFromJson(suit_json, where + ": suit of HELLO");
    if (!suit)
        return suit.error();
    hello.suit = std::move(*suit);
    if (hello.suit.boards.empty())
        return damagedMessage(where, "HELLO describes no board");
    return hello;
}

Result<Suit> placedBySerial(const Suit& box, const Suit& own) {
    const auto unknown = [&](const char* kind, const std::string& id, const std::string& serial) {
        return Error{ErrorKind::kUnusable,
                     std::string("The suit '") + own.name + "' has no " + kind +
                         " with the serial number of '" + id + "' (" + (serial.empty() ? "none" : serial) +
                         ")",
                     "Choose the suit that is plugged in, or add this serial number to its file"};
    };
    Suit placed = box;
    placed.name = own.name;
    for (Board& board : placed.boards) {
        // What it sends the box alone knows; with another layout its frames would be misread.
        const bool sends_field = board.has_magnetometer;
        if (!placePart(board, own.boards))
            return unknown("board", board.id, board.serial);
        board.has_magnetometer = sends_field;
    }
    for (Source& source : placed.sources)
        if (!placePart(source, own.sources))
            return unknown("source", source.id, source.serial);
    return placed;
}

}  // namespace noctule::link
