// SPDX-License-Identifier: Apache-2.0
#include "core/processing/field_take.h"

#include <algorithm>
#include <cmath>

#include "core/inertial/reading.h"
#include "core/math/json.h"
#include "core/recording/take.h"
#include "core/recording/take_writer.h"

namespace noctule {
namespace {

constexpr const char* kSpotKey = "x_field_spot";
constexpr double kFieldsPerSecond = 7;

nlohmann::json spotJson(const SpotField& spot) {
    nlohmann::json json = {{"strength_ut", spot.strength_ut},
                           {"strength_sigma_ut", spot.strength_sigma_ut},
                           {"uneven_percent", spot.uneven_percent},
                           {"moments", spot.moments}};
    if (spot.dip_deg)
        json["dip_deg"] = *spot.dip_deg;
    if (spot.floor_percent)
        json["floor_percent"] = *spot.floor_percent;
    return json;
}

std::optional<SpotField> spotFrom(const nlohmann::json& json) {
    if (!json.is_object())
        return std::nullopt;
    try {
        SpotField spot;
        spot.strength_ut = json.at("strength_ut").get<double>();
        spot.strength_sigma_ut = json.at("strength_sigma_ut").get<double>();
        spot.uneven_percent = json.at("uneven_percent").get<double>();
        spot.moments = json.at("moments").get<int>();
        if (json.contains("dip_deg"))
            spot.dip_deg = json["dip_deg"].get<double>();
        if (json.contains("floor_percent"))
            spot.floor_percent = json["floor_percent"].get<double>();
        return spot;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

/// A box that was switched off meanwhile counts from zero again: what comes later goes behind what was there.
Status addField(TakeWriter& take, int board, const std::vector<FieldReading>& readings, int rate_hz,
                double& end_sample) {
    const double between = rate_hz / kFieldsPerSecond;
    double shift = 0, last = -1;
    int64_t last_frame = -1;
    for (const FieldReading& one : readings) {
        if (one.sample + shift <= last)
            shift = last + between - one.sample;
        last = one.sample + shift;
        InertialReading reading;
        reading.board = board;
        reading.sample = last;
        reading.frame = std::max(
            last_frame + 1, static_cast<int64_t>(std::llround(last * kInertialFramesPerSecond / rate_hz)));
        last_frame = reading.frame;
        for (size_t axis = 0; axis < 3; ++axis)
            reading.magnetometer_counts[axis] = one.counts[static_cast<Eigen::Index>(axis)];
        reading.corrected_bits = 0;
        if (Status added = take.addInertial(kPrimaryRun, reading); !added)
            return added;
    }
    end_sample = std::max(end_sample, last + 1);
    return Done{};
}

Status writeField(TakeWriter& take, const FieldTakePlan& plan, const Suit& suit, const FieldRecord& record) {
    if (auto added = take.addSuit(suit); !added)
        return added.error();
    if (plan.calibration)
        if (auto added = take.addCalibration(*plan.calibration); !added)
            return added.error();
    if (Status set = take.setMeta("level", "readings"); !set)
        return set;
    if (record.spot)
        if (Status set = take.setMeta(kSpotKey, spotJson(*record.spot).dump()); !set)
            return set;
    double end_sample = 1;
    for (size_t board = 0; board < record.readings.size(); ++board)
        if (Status added = addField(take, static_cast<int>(board), record.readings[board],
                                    plan.sample_rate_hz, end_sample);
            !added)
            return added;
    return take.setMeta("sample_count", std::to_string(std::llround(std::ceil(end_sample))));
}

}  // namespace

Status writeFieldTake(const FieldTakePlan& plan, const Suit& suit, const FieldRecord& record) {
    TakeHeader header;
    header.name = plan.name;
    header.created_utc = plan.created_utc;
    header.software = plan.software;
    header.sample_rate_hz = plan.sample_rate_hz;
    header.board_count = static_cast<int>(suit.boards.size());
    header.source_count = static_cast<int>(suit.sources.size());
    TakeWriter::Options options;
    options.overwrite = true;
    auto take = TakeWriter::create(plan.path, header, options);
    if (!take)
        return take.error();
    if (Status written = writeField(*take, plan, suit, record); !written)
        return written;
    return take->finish();
}

Result<FieldRecord> readFieldTake(const std::string& path, const Suit& suit) {
    const auto take = Take::open(path);
    if (!take)
        return take.error();
    const auto recorded = take->suit();
    if (!recorded)
        return recorded.error();
    FieldRecord record;
    record.readings.resize(suit.boards.size());
    if (const auto spot = take->meta().find(kSpotKey); spot != take->meta().end())
        record.spot = spotFrom(json::parse(spot->second));
    auto cursor = take->readings(kPrimaryRun);
    if (!cursor)
        return cursor.error();
    for (;;) {
        const auto next = cursor->next();
        if (!next)
            return next.error();
        if (!*next)
            return record;
        const InertialReading& reading = **next;
        const int board = suit.findBoard(recorded->boards[static_cast<size_t>(reading.board)].id);
        const auto& counts = reading.magnetometer_counts;
        if (board >= 0 && counts[0] && counts[1] && counts[2])
            record.readings[static_cast<size_t>(board)].push_back(
                {reading.sample, Vector3d(*counts[0], *counts[1], *counts[2])});
    }
}

}  // namespace noctule
