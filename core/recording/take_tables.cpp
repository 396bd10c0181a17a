// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_tables.h"

#include <algorithm>
#include <cmath>

#include "core/recording/pose_blob.h"

namespace noctule {

namespace {

/// Ids and names come from outside; text that is not UTF-8 must not throw.
std::string dump(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Uses what format 1.1 has added.
bool needsMinorVersion(const Suit& suit) {
    const auto adds = [](const Board& board) {
        return board.rate_hz != kUsualBoardRate_hz || board.gyro_noise_rad_per_s ||
               board.accel_noise_m_per_s2;
    };
    return suit.carrier_hz || suit.pulse_interval_samples || suit.pulse_cycles || suit.sample_rate_hz ||
           std::ranges::any_of(suit.boards, adds) ||
           std::ranges::any_of(suit.sources, [](const Source& source) { return !source.board.empty(); });
}

bool isFinite(const TimedPose& timed) {
    if (!timed.pose->p_world_root.allFinite())
        return false;
    for (const Quaterniond& q : timed.pose->q_parent_joint)
        if (!q.coeffs().allFinite())
            return false;
    for (const double sigma : timed.sigma_rad)
        if (!std::isfinite(sigma))
            return false;
    return true;
}

Error notFinite(const std::string& name, int64_t time_ns) {
    return {ErrorKind::kInternal, name + ": the pose at " + std::to_string(time_ns) + " ns is not finite",
            "Please report this with the take"};
}

void bindPosition(Statement& insert, int parameter, const Vector3d& p) {
    insert.bind(parameter, p.x()).bind(parameter + 1, p.y()).bind(parameter + 2, p.z());
}

}  // namespace

Result<Statement*> TakeTables::insertInto(const std::string& table) {
    auto found = inserts_.find(table);
    if (found == inserts_.end()) {
        if (const Status complete = schema_.complete(*database_, table); !complete)
            return complete.error();
        std::string names, marks;
        for (const ColumnDefinition& column : takeTable(table).columns) {
            names += (names.empty() ? "" : ",") + column.name;
            marks += marks.empty() ? "?" : ",?";
        }
        Result<Statement> insert =
            database_->prepare("INSERT INTO " + table + "(" + names + ") VALUES(" + marks + ")");
        if (!insert)
            return insert.error();
        found = inserts_.emplace(table, std::move(*insert)).first;
    }
    return &found->second;
}

Status TakeTables::setMeta(const std::string& key, const std::string& value) {
    if (const Status complete = schema_.complete(*database_, "meta"); !complete)
        return complete;
    auto replace = database_->prepare("INSERT OR REPLACE INTO meta(key,value) VALUES(?,?)");
    if (!replace)
        return replace.error();
    return replace->bind(0, std::string_view(key)).bind(1, std::string_view(value)).run();
}

Result<int64_t> TakeTables::addSuit(const Suit& suit, const SuitClock& clock) {
    auto insert = insertInto("suit");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, std::string_view(dump(toJson(suit))));
    if (const Status done = (*insert)->bind(2, clock.offset_ns).bind(3, clock.rate).run(); !done)
        return done.error();
    const int64_t id = database_->lastInsertId();
    if (id > 1 || needsMinorVersion(suit))
        if (const Status noted =
                database_->execute("PRAGMA user_version=" + std::to_string(kTakeNewestVersion));
            !noted)
            return noted.error();
    return id;
}

Result<int64_t> TakeTables::addDocument(const std::string& table, const std::string& json,
                                        const std::string& created_utc, int suit) {
    suit = seen(suit);
    auto insert = insertInto(table);
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit});
    (*insert)->bind(2, std::string_view(created_utc)).bind(3, std::string_view(json));
    if (const Status done = (*insert)->run(); !done)
        return done.error();
    return database_->lastInsertId();
}

Result<int64_t> TakeTables::addCalibration(const Calibration& calibration, int suit) {
    suit = seen(suit);
    return addDocument("calibration", dump(toJson(calibration)), calibration.created_utc, suit);
}

Result<int64_t> TakeTables::addActor(const Actor& actor, const std::string& created_utc, int suit) {
    suit = seen(suit);
    return addDocument("actor", dump(toJson(actor)), created_utc, suit);
}

Result<int64_t> TakeTables::addPulse(int64_t sample, int source, int suit) {
    suit = seen(suit);
    auto insert = insertInto("pulse");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit}).bind(2, sample).bind(3, int64_t{source});
    if (const Status done = (*insert)->run(); !done)
        return done.error();
    return database_->lastInsertId();
}

Status TakeTables::addPulse(const Pulse& pulse, int suit) {
    auto insert = insertInto("pulse");
    if (!insert)
        return insert.error();
    (*insert)->bind(0, pulse.id).bind(1, int64_t{suit}).bind(2, pulse.sample).bind(3, int64_t{pulse.source});
    return (*insert)->run();
}

Status TakeTables::addStatus(const StatusRow& row, int suit) {
    suit = seen(suit);
    auto insert = insertInto("status");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit}).bind(2, row.sample);
    (*insert)->bind(3, row.temperature_c).bind(4, row.humidity_percent);
    return (*insert)->bind(5, row.battery_v).bind(6, row.battery_percent).run();
}

Status TakeTables::addGap(const GapRow& row, int suit) {
    suit = seen(suit);
    auto insert = insertInto("gap");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit}).bind(2, row.first_sample).bind(3, row.sample_count);
    (*insert)->bind(4, row.board ? std::optional<int64_t>(*row.board) : std::nullopt);
    return (*insert)->bind(5, std::string_view(row.reason)).run();
}

Status TakeTables::addMarker(const MarkerRow& row, int suit) {
    suit = seen(suit);
    auto insert = insertInto("marker");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit}).bind(2, row.sample);
    return (*insert)->bind(3, std::string_view(row.kind)).bind(4, std::string_view(row.label)).run();
}

Status TakeTables::addNote(const NoteRow& row) {
    auto insert = insertInto("note");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, std::string_view(row.created_utc));
    return (*insert)->bind(2, std::string_view(row.text)).run();
}

Status TakeTables::addReference(const TimedPose& timed, int suit) {
    suit = seen(suit);
    auto insert = insertInto("reference");
    if (!insert)
        return insert.error();
    (*insert)->bind(0, int64_t{suit}).bind(1, timed.time_ns);
    if (!timed.pose)
        return (*insert)->bindNull(2).bindNull(3).bindNull(4).bindNull(5).run();
    if (!isFinite(timed))
        return notFinite(database_->name(), timed.time_ns);
    const auto q = packRotations(timed.pose->q_parent_joint);
    bindPosition(**insert, 2, timed.pose->p_world_root);
    return (*insert)->bindBlob(5, q).run();
}

Status TakeTables::addExternalRoot(const ExternalRootRow& row, int suit) {
    suit = seen(suit);
    auto insert = insertInto("external_root");
    if (!insert)
        return insert.error();
    const Quaterniond& q = row.q_world_root;
    (*insert)->bind(0, int64_t{suit}).bind(1, row.time_ns);
    bindPosition(**insert, 2, row.p_world_root);
    (*insert)->bind(5, q.w()).bind(6, q.x()).bind(7, q.y()).bind(8, q.z());
    return (*insert)->bind(9, row.sigma_p_m).bind(10, row.sigma_q_rad).run();
}

Status TakeTables::addInertial(int64_t run, const InertialReading& reading, int suit) {
    suit = seen(suit);
    auto insert = insertInto("inertial");
    if (!insert)
        return insert.error();
    (*insert)->bind(0, run).bind(1, int64_t{suit}).bind(2, int64_t{reading.board});
    (*insert)->bind(3, reading.frame).bind(4, reading.sample);
    for (int axis = 0; axis < 6; ++axis)
        (*insert)->bind(5 + axis, reading.counts[static_cast<size_t>(axis)]);
    for (int axis = 0; axis < 3; ++axis)
        (*insert)->bind(11 + axis, reading.magnetometer_counts[static_cast<size_t>(axis)]);
    const auto corrected =
        reading.corrected_bits ? std::optional<int64_t>(*reading.corrected_bits) : std::nullopt;
    return (*insert)->bind(14, corrected).run();
}

Status TakeTables::addRange(int64_t run, const RangeMeasurement& range, const std::string& detector,
                            int suit) {
    suit = seen(suit);
    auto insert = insertInto("range");
    if (!insert)
        return insert.error();
    (*insert)->bind(0, run).bind(1, range.pulse).bind(2, int64_t{suit}).bind(3, int64_t{range.board});
    (*insert)->bind(4, std::string_view(detector)).bind(5, range.arrival_sample).bind(6, range.distance_m);
    (*insert)->bind(7, range.w_s).bind(8, range.w_t).bind(9, range.w_a).bind(10, range.sigma_m);
    if (range.fate == RangeFate::kNotTried)
        return (*insert)->bindNull(11).bindNull(12).run();
    return (*insert)
        ->bind(11, std::string_view(rangeFateName(range.fate)))
        .bind(12, range.innovation_m)
        .run();
}

Status TakeTables::addContacts(int64_t run, const std::vector<FootContacts>& feet, int suit) {
    suit = seen(suit);
    auto insert = insertInto("contact");
    if (!insert)
        return insert.error();
    for (const FootContacts& foot : feet)
        for (const FootContact& contact : foot.contacts) {
            (*insert)->bind(0, run).bind(1, int64_t{suit}).bind(2, std::string_view(foot.foot));
            (*insert)->bind(3, int64_t{std::llround(contact.from_s * 1e9)});
            (*insert)->bind(4, int64_t{std::llround(contact.to_s * 1e9)});
            if (Status done = (*insert)->bind(5, int64_t{contact.by_hand}).run(); !done)
                return done;
        }
    return Done{};
}

Status TakeTables::addPose(int64_t run, const TimedPose& timed, int suit) {
    suit = seen(suit);
    require(timed.pose.has_value(), "a derived pose must be there");
    require(timed.sigma_rad.empty() || timed.sigma_rad.size() == 3 * timed.pose->q_parent_joint.size(),
            "sigma must hold three numbers per joint");
    auto insert = insertInto("pose");
    if (!insert)
        return insert.error();
    if (!isFinite(timed))
        return notFinite(database_->name(), timed.time_ns);
    const auto sigma = packSigma(timed.sigma_rad);
    const auto q = packRotations(timed.pose->q_parent_joint);
    (*insert)->bind(0, run).bind(1, int64_t{suit}).bind(2, timed.time_ns);
    if (sigma.empty())
        (*insert)->bindNull(3);
    else
        (*insert)->bindBlob(3, sigma);
    bindPosition(**insert, 4, timed.pose->p_world_root);
    return (*insert)->bindBlob(7, q).run();
}

}  // namespace noctule
