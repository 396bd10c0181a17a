// SPDX-License-Identifier: Apache-2.0
// The tables of a take that are read as a whole.
#include <algorithm>
#include <cmath>

#include "core/job/limits.h"
#include "core/math/json.h"
#include "core/recording/pose_blob.h"
#include "core/recording/pulse_rate.h"
#include "core/recording/take.h"

namespace noctule {

namespace {

/// A board or source index, or absent when NULL; -1 when it is anything else.
std::optional<int> readIndex(const Statement& row, int column, int count) {
    if (row.isNull(column))
        return std::nullopt;
    const int64_t index = row.integer(column).value_or(-1);
    return index >= 0 && index < count ? static_cast<int>(index) : -1;
}

std::optional<Vector3d> readPosition(const Statement& row, int column) {
    const auto x = row.real(column), y = row.real(column + 1), z = row.real(column + 2);
    const auto near = [](const std::optional<double>& p) { return p && std::abs(*p) <= limits::kFarthest_m; };
    return near(x) && near(y) && near(z) ? std::optional(Vector3d(*x, *y, *z)) : std::nullopt;
}

bool isNullPosition(const Statement& row, int column) {
    return row.isNull(column) || row.isNull(column + 1) || row.isNull(column + 2);
}

/// On the take's clock; references may begin before the take and end after it.
struct TimeSpan {
    int64_t first_ns = -limits::kLongestTake_s * 1'000'000'000;
    int64_t last_ns = limits::kLongestTake_s * 1'000'000'000;

    bool holds(const std::optional<int64_t>& time_ns) const {
        return time_ns && *time_ns >= first_ns && *time_ns <= last_ns;
    }
};

/// A run of several subjects names the calibration and the actor of each in its settings.
void namePartsOf(int suit, DerivedRun& run) {
    const json::Json settings = json::parse(run.settings_json);
    const auto subjects = settings.is_object() ? settings.find("subjects") : settings.end();
    if (subjects == settings.end() || !subjects->is_array())
        return;
    for (const json::Json& subject : *subjects) {
        if (json::number(subject, "suit") != suit)
            continue;
        const auto id = [&](const char* member) {
            const auto number = json::number(subject, member);
            return number ? std::optional(static_cast<int64_t>(*number)) : std::nullopt;
        };
        run.calibration_id = id("calibration_id");
        run.actor_id = id("actor_id");
    }
}

/// Columns time_ns, px, py, pz, q, sigma.
RowVerdict readTimedPose(const Statement& row, size_t joint_count, const TimeSpan& span, TimedPose& timed) {
    const auto time_ns = row.integer(0);
    if (!span.holds(time_ns))
        return "time_ns is missing or outside the take";
    timed.time_ns = *time_ns;
    if (isNullPosition(row, 1) || row.isNull(4))
        return "";  // not seen
    const auto position = readPosition(row, 1);
    const auto blob = row.blob(4);
    auto rotations = blob ? unpackRotations(*blob, joint_count) : std::nullopt;
    if (!position || !rotations)
        return "position or rotations are not those of " + std::to_string(joint_count) + " joints";
    timed.pose = Pose{*position, std::move(*rotations)};
    if (const auto sigma_blob = row.blob(5)) {
        auto sigma_rad = unpackSigma(*sigma_blob, joint_count);
        if (!sigma_rad)
            return "sigma does not hold three numbers per joint";
        timed.sigma_rad = std::move(*sigma_rad);
    }
    return "";
}

RowVerdict readExternalRoot(const Statement& row, ExternalRootRow& root) {
    const auto time_ns = row.integer(0);
    const auto position = readPosition(row, 1);
    const auto w = row.real(4);
    const auto xyz = readPosition(row, 5);
    const auto sigma_p = row.real(8), sigma_q = row.real(9);
    if (!TimeSpan().holds(time_ns) || !position || !w || !xyz || !sigma_p || !sigma_q || *sigma_p <= 0 ||
        *sigma_q <= 0)
        return "a value is missing or out of range, or a sigma is not greater than zero";
    const Quaterniond q(*w, xyz->x(), xyz->y(), xyz->z());
    const double deviation = std::abs(q.norm() - 1);
    if (!(deviation < 0.01))
        return "the quaternion is not a unit";
    root = {*time_ns, *position, deviation < 1e-12 ? q : q.normalized(), *sigma_p, *sigma_q};
    return "";
}

}  // namespace

Result<std::vector<Pulse>> Take::pulses(int suit) const {
    suit = seen(suit);
    return pulsesWhere("", suit);
}

Result<std::vector<Pulse>> Take::pulses(int suit, const SampleInterval& within) const {
    suit = seen(suit);
    return pulsesWhere(
        " AND sample BETWEEN " + std::to_string(within.first) + " AND " + std::to_string(within.last), suit);
}

Result<std::vector<Pulse>> Take::pulsesWhere(const std::string& filter, int suit) const {
    suit = seen(suit);
    const auto known = sourceCount(suit);
    const int source_count = known ? *known : static_cast<int>(Suit::kMaxPerSuit);
    return collectRows<Pulse>(
        *database_, *log_, rowsOfSuit("pulse", suit),
        schema_->select("pulse", {"id", "sample", "source"}) + ofSuit("pulse", suit) + filter + " ORDER BY 2",
        [source_count, last = lastSample(), rate = PulseRate(header_.sample_rate_hz)](
            const Statement& row, Pulse& pulse) mutable -> RowVerdict {
            const auto sample = row.integer(1);
            if (!isSample(sample) || *sample > last)
                return "sample is missing or out of range";
            const int source = readIndex(row, 2, source_count).value_or(-1);
            if (source < 0)
                return "source is not in the suit";
            if (!rate.allows(*sample))
                return "there are more than four pulses in a millisecond";
            pulse = {row.integer(0).value_or(0), *sample, source};
            return "";
        });
}

Result<std::vector<StatusRow>> Take::statusRows(int suit) const {
    suit = seen(suit);
    return collectRows<StatusRow>(
        *database_, *log_, rowsOfSuit("status", suit),
        schema_->select(
            "status", {"id", "sample", "temperature_c", "humidity_percent", "battery_v", "battery_percent"}) +
            ofSuit("status", suit) + " ORDER BY 2",
        [](const Statement& row, StatusRow& status) -> RowVerdict {
            const auto sample = row.integer(1);
            if (!isSample(sample))
                return "sample is missing or out of range";
            status = {*sample, row.real(2), row.real(3), row.real(4), row.real(5)};
            const auto within = [](const std::optional<double>& value, double lowest, double highest) {
                return !value || (*value >= lowest && *value <= highest);
            };
            if (!within(status.temperature_c, limits::kColdest_c, limits::kHottest_c) ||
                !within(status.humidity_percent, 0, 100))
                return "temperature_c is not -60 to 90 or humidity_percent not 0 to 100";
            return "";
        });
}

Result<std::vector<GapRow>> Take::gaps(int suit) const {
    suit = seen(suit);
    const auto known = boardCount(suit);
    const int board_count = known ? *known : static_cast<int>(Suit::kMaxPerSuit);
    return collectRows<GapRow>(
        *database_, *log_, rowsOfSuit("gap", suit),
        schema_->select("gap", {"id", "first_sample", "sample_count", "board", "reason"}) +
            ofSuit("gap", suit) + " ORDER BY 2",
        [board_count](const Statement& row, GapRow& gap) -> RowVerdict {
            const auto first = row.integer(1), count = row.integer(2);
            if (!isSample(first) || !isSample(count))
                return "first_sample or sample_count is missing or out of range";
            gap = {*first, *count, readIndex(row, 3, board_count), row.shortened(4, limits::kName)};
            return gap.board && *gap.board < 0 ? "board is not in the suit" : "";
        });
}

Result<std::vector<MarkerRow>> Take::markers(int suit) const {
    suit = seen(suit);
    return collectRows<MarkerRow>(
        *database_, *log_, rowsOfSuit("marker", suit),
        schema_->select("marker", {"id", "sample", "kind", "label"}) + ofSuit("marker", suit) +
            " ORDER BY 2,1",
        [](const Statement& row, MarkerRow& marker) -> RowVerdict {
            const auto sample = row.integer(1);
            if (!isSample(sample))
                return "sample is missing or out of range";
            marker = {*sample, row.shortened(2, limits::kName), row.shortened(3, limits::kName)};
            return "";
        });
}

Result<std::vector<NoteRow>> Take::notes() const {
    return collectRows<NoteRow>(*database_, *log_, "note",
                                schema_->select("note", {"id", "created_utc", "text"}) + " ORDER BY 1",
                                [](const Statement& row, NoteRow& note) -> RowVerdict {
                                    note = {row.shortened(1, limits::kName), row.shortened(2, limits::kNote)};
                                    return row.isNull(2) ? "text is missing" : "";
                                });
}

Result<std::optional<SampleInterval>> Take::restInterval(int suit) const {
    suit = seen(suit);
    const auto all = markers(suit);
    if (!all)
        return all.error();
    std::optional<int64_t> begin;
    for (const MarkerRow& marker : *all) {
        if (marker.kind != "rest")
            continue;
        if (!begin && marker.label == "begin")
            begin = marker.sample;
        if (begin && marker.label == "end")
            return std::optional(SampleInterval{*begin, marker.sample});
    }
    return std::optional<SampleInterval>();
}

PoseSource Take::timedPoses(Skeleton skeleton, const std::string& table, const std::string& filter,
                            int suit) const {
    suit = seen(suit);
    const auto joint_count = static_cast<size_t>(skeleton.size());
    TimeSpan span;
    if (const auto end_s = duration_s(suit); table == "pose") {
        const SuitClock clock = suitClock(suit);
        span.first_ns = std::llround(std::clamp(clock.offset_ns, static_cast<double>(span.first_ns), 0.0)) -
                        limits::kBeyondTake_ns;
        const double end_ns = end_s ? clock.takeTime_s(*end_s) * 1e9 : 0;
        if (end_ns > 0 && end_ns < static_cast<double>(span.last_ns))
            span.last_ns = std::llround(end_ns) + limits::kBeyondTake_ns;
    }
    const std::string sql = schema_->select(table, {"time_ns", "px", "py", "pz", "q", "sigma"}) +
                            ofSuit(table, suit) + filter + " ORDER BY 1";
    return {std::move(skeleton),
            [database = database_.get(), log = log_.get(), what = rowsOfSuit(table, suit), sql, span,
             joint_count](const PoseSink& sink) {
                return forEachRow<TimedPose>(
                    *database, *log, what, sql,
                    [joint_count, span](const Statement& row, TimedPose& timed) {
                        return readTimedPose(row, joint_count, span, timed);
                    },
                    sink);
            }};
}

Result<TimedMotion> Take::reference(int suit) const {
    suit = seen(suit);
    if (!schema_->has("reference"))
        return TimedMotion{};
    const auto actor = referenceActor(suit);
    if (!actor)
        return actor.error();
    return timedPoses(actor->skeleton, "reference", "", suit).all();
}

Result<std::vector<ExternalRootRow>> Take::externalRoot(int suit) const {
    suit = seen(suit);
    return collectRows<ExternalRootRow>(
        *database_, *log_, rowsOfSuit("external_root", suit),
        schema_->select("external_root",
                        {"time_ns", "px", "py", "pz", "qw", "qx", "qy", "qz", "sigma_p_m", "sigma_q_rad"}) +
            ofSuit("external_root", suit) + " ORDER BY 1",
        readExternalRoot);
}

Result<bool> Take::hasRows(const std::string& table, int suit) const {
    suit = seen(suit);
    if (!schema_->has(table))
        return false;
    const auto row = database_->queryInteger("SELECT 1 FROM " + table + ofSuit(table, suit) + " LIMIT 1");
    if (!row)
        return row.error();
    return row->has_value();
}

Result<Take::Measured> Take::measured(int suit) const {
    suit = seen(suit);
    const auto holds = [&](const std::string& table, const std::string& column) -> Result<bool> {
        if (!schema_->has(table, column))
            return false;
        const auto row = database_->queryInteger("SELECT 1 FROM " + table + ofSuit(table, suit) +
                                                 " AND run=" + std::to_string(kPrimaryRun) + " AND " +
                                                 column + " IS NOT NULL LIMIT 1");
        if (!row)
            return row.error();
        return row->has_value();
    };
    const auto accelerometers = holds("inertial", "ax"), gyroscopes = holds("inertial", "gx"),
               distances = holds("range", "pulse");
    for (const auto* found : {&accelerometers, &gyroscopes, &distances})
        if (!*found)
            return found->error();
    return Measured{*accelerometers, *gyroscopes, *distances};
}

Result<std::vector<DerivedRun>> Take::derivedRuns() const {
    auto runs = collectRows<DerivedRun>(
        *database_, *log_, "derived",
        schema_->select("derived", {"run", "kind", "name", "created_utc", "software", "settings",
                                    "calibration_id", "actor_id"}) +
            " ORDER BY 1",
        [](const Statement& row, DerivedRun& run) -> RowVerdict {
            const auto text = [&](int column) { return row.shortened(column, limits::kName); };
            run = {row.integer(0).value_or(0),      text(1),        text(2),       text(3), text(4),
                   row.shortened(5, limits::kNote), row.integer(6), row.integer(7)};
            return run.run < 1 || run.run > kHighestRun ? "run is not 1, 2, ..." : "";
        });
    if (runs)
        for (DerivedRun& run : *runs)
            namePartsOf(view_, run);
    return runs;
}

Result<RunOfTake> Take::runOfTake(int64_t run, int suit) const {
    suit = seen(suit);
    const auto board_count = boardCount(suit);
    if (!board_count)
        return board_count.error();
    const auto source_count = sourceCount(suit);
    const auto rate_hz = sampleRate_hz();
    return RunOfTake{database_.get(),
                     schema_.get(),
                     log_.get(),
                     run,
                     suit,
                     *board_count,
                     source_count ? *source_count : 0,
                     rate_hz ? static_cast<double>(*rate_hz) : 0};
}

Result<ReadingCursor> Take::readings(int64_t run, int suit) const {
    suit = seen(suit);
    const auto where = runOfTake(run, suit);
    if (!where)
        return where.error();
    return ReadingCursor::open(*where);
}

Result<RangeCursor> Take::ranges(int64_t run, int suit) const {
    suit = seen(suit);
    const auto where = runOfTake(run, suit);
    if (!where)
        return where.error();
    return RangeCursor::open(*where);
}

Result<RangeCursor> Take::rangesOfPulses(int64_t run, int64_t first, int64_t last, int suit) const {
    suit = seen(suit);
    auto where = runOfTake(run, suit);
    if (!where)
        return where.error();
    where->pulses = std::pair(first, last);
    return RangeCursor::open(*where);
}

Result<std::vector<FootContacts>> Take::contacts(int64_t run, int suit) const {
    suit = seen(suit);
    std::vector<FootContacts> feet;
    const auto rows = collectRows<FootContact>(
        *database_, *log_, rowsOfSuit("contact", suit),
        schema_->select("contact", {"foot", "from_ns", "to_ns", "by_hand"}) + ofSuit("contact", suit) +
            " AND run=" + std::to_string(run) + " ORDER BY 1,2",
        [&feet, run](const Statement& row, FootContact& contact) -> RowVerdict {
            const auto foot = row.text(0);
            const auto from_ns = row.integer(1), to_ns = row.integer(2);
            if (!foot || !TimeSpan().holds(from_ns) || !TimeSpan().holds(to_ns) || *to_ns < *from_ns)
                return "a value is missing, or it ends before it begins";
            if (feet.empty() || feet.back().foot != *foot)
                feet.push_back({*foot, {}});
            contact = {static_cast<double>(*from_ns) * 1e-9, static_cast<double>(*to_ns) * 1e-9, 0,
                       row.integer(3).value_or(run == kPrimaryRun) != 0};
            feet.back().contacts.push_back(contact);
            return "";
        });
    if (!rows)
        return rows.error();
    return feet;
}

Result<std::optional<std::vector<FootContacts>>> Take::editedContacts(int suit) const {
    suit = seen(suit);
    std::optional<std::vector<FootContacts>> edited;
    const auto whose = meta_.find(contactsKey(suit));
    if (whose == meta_.end() || whose->second != kContactsEdited)
        return edited;
    auto stored = contacts(kPrimaryRun, suit);
    if (!stored)
        return stored.error();
    edited = std::move(*stored);
    return edited;
}

Result<TimedMotion> Take::poses(int64_t run, int suit) const {
    suit = seen(suit);
    const auto source = poseSource(run, suit);
    if (!source)
        return source.error();
    return source->all();
}

Result<PoseSource> Take::poseSource(int64_t run, int suit) const {
    suit = seen(suit);
    const auto runs = derivedRuns();
    if (!runs)
        return runs.error();
    const auto found =
        std::find_if(runs->begin(), runs->end(), [&](const DerivedRun& r) { return r.run == run; });
    if (found == runs->end() || found->kind != "pose")
        return unusable("there is no result " + std::to_string(run), "Process the take first");
    DerivedRun of_suit = *found;  // whose parts are those of the suit in view
    namePartsOf(suit, of_suit);
    auto own = of_suit.actor_id ? actor(*of_suit.actor_id) : Result<Actor>(Actor{});
    if (!of_suit.actor_id) {
        auto in_force = actorInForce(suit);
        own = in_force ? Result<Actor>(std::move(in_force->value)) : Result<Actor>(in_force.error());
    }
    if (!own)
        return own.error();
    return timedPoses(own->skeleton, "pose", " AND run=" + std::to_string(run), suit);
}

}  // namespace noctule
