// SPDX-License-Identifier: Apache-2.0
// Opening a take and what stands in it once: meta, suits, calibrations, actors. Rows are read in
// take_rows.cpp.
#include "core/recording/take.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/job/limits.h"
#include "core/math/json.h"
#include "core/recording/first_page.h"
#include "core/recording/recover_take.h"

namespace noctule {

namespace {

/// The number in a meta value; `fallback` when it is missing, no number or out of range.
double metaNumber(const std::map<std::string, std::string>& meta, const char* key, double fallback,
                  double min, double max) {
    const auto found = meta.find(key);
    if (found == meta.end())
        return fallback;
    const std::string& text = found->second;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) && value >= min && value <= max ? value : fallback;
}

std::string metaText(const std::map<std::string, std::string>& meta, const char* key,
                     const std::string& fallback = "") {
    const auto found = meta.find(key);
    return found == meta.end() ? fallback : found->second;
}

/// A document, which is as long as it must be.
bool isDocument(const std::string& key) {
    return key.starts_with("reference_actor") || key == "reference_joints" || key == "subjects";
}

/// Most values are names. What came with a reference or from another program is kept whole: it is written
/// back, and may be JSON.
size_t longestMeta(const std::string& key) {
    if (isDocument(key))
        return limits::kJsonBytes;
    return key.starts_with("reference_") || key.starts_with("x_") ? limits::kMetaValue : limits::kName;
}

/// Names a value that metaNumber() would not take.
void noteRefused(const std::map<std::string, std::string>& meta, SkipLog& log, const char* key, double min,
                 double max) {
    if (meta.contains(key) && std::isnan(metaNumber(meta, key, NAN, min, max)))
        log.add("meta", key,
                "is not a number from " + std::to_string(std::llround(min)) + " to " +
                    std::to_string(std::llround(max)));
}

void noteRefused(const std::map<std::string, std::string>& meta, SkipLog& log) {
    noteRefused(meta, log, "sample_rate_hz", limits::kLowestRate_hz, limits::kHighestRate_hz);
    noteRefused(meta, log, "board_count", 1, Suit::kMaxPerSuit);
    noteRefused(meta, log, "source_count", 0, Suit::kMaxPerSuit);
    noteRefused(meta, log, "sample_count", 0, static_cast<double>(kLastSample));
    noteRefused(meta, log, "pulse_interval_samples", 1, 1e9);
    noteRefused(meta, log, "pulse_cycles", 0, 1e4);
    noteRefused(meta, log, "drive_hz", 1, 1e9);
    noteRefused(meta, log, "g_m_per_s2", 9, 10);
}

TakeHeader headerFrom(const std::map<std::string, std::string>& meta) {
    TakeHeader header;
    header.uuid = metaText(meta, "uuid");
    header.name = metaText(meta, "name");
    header.created_utc = metaText(meta, "created_utc");
    header.software = metaText(meta, "software");
    header.sample_rate_hz =
        std::llround(metaNumber(meta, "sample_rate_hz", 0, limits::kLowestRate_hz, limits::kHighestRate_hz));
    header.board_count = static_cast<int>(metaNumber(meta, "board_count", 0, 1, Suit::kMaxPerSuit));
    header.source_count = static_cast<int>(metaNumber(meta, "source_count", 0, 1, Suit::kMaxPerSuit));
    header.pulse_interval_samples = std::llround(metaNumber(
        meta, "pulse_interval_samples", static_cast<double>(header.pulse_interval_samples), 1, 1e9));
    header.pulse_cycles = metaNumber(meta, "pulse_cycles", header.pulse_cycles, 0.1, 1e4);
    header.drive_hz = metaNumber(meta, "drive_hz", header.drive_hz, 1, 1e9);
    header.take_kind = metaText(meta, "take_kind", header.take_kind);
    header.g_m_per_s2 = metaNumber(meta, "g_m_per_s2", header.g_m_per_s2, 9, 10);
    header.turntable_rpm = metaNumber(meta, "turntable_rpm", header.turntable_rpm, 1, 1000);
    return header;
}

/// One after the last reading, or of a suit without readings, such as a room's, after its last pulse. Single
/// rows that lie more than `hole` beyond the others are damage.
Result<int64_t> samplesOfReadings(const Database& database, const TakeSchema& schema, int suit,
                                  int64_t last_sample, int64_t hole) {
    for (const std::string table : {"inertial", "pulse"}) {
        if (!schema.has(table))
            continue;
        const std::string primary =
            table == "inertial" ? schema.expression(table, "run") + "=0 AND " : std::string();
        auto rows = database.prepare("SELECT CAST(sample AS INTEGER)+1 FROM " + table + " WHERE " + primary +
                                     schema.expression(table, "suit") + "=" + std::to_string(suit) +
                                     " AND typeof(sample) IN ('integer','real') AND sample BETWEEN 0 AND " +
                                     std::to_string(last_sample) + " ORDER BY sample DESC LIMIT 16");
        if (!rows)
            return rows.error();
        std::vector<int64_t> ends;
        for (auto row = rows->step(); !row || *row; row = rows->step()) {
            if (!row)
                return row.error();
            ends.push_back(rows->integer(0).value_or(0));
        }
        for (size_t i = 0; i < ends.size(); ++i)
            if (i + 1 == ends.size() || ends[i] <= ends[i + 1] + hole)
                return std::min(ends[i], last_sample);
    }
    return int64_t{0};
}

}  // namespace

Error Take::unusable(const std::string& what, const std::string& remedy) const {
    return {ErrorKind::kUnusable, path() + ": " + what, remedy};
}

std::string Take::ofSuit(const std::string& table, int suit) const {
    suit = seen(suit);
    return " WHERE " + schema_->expression(table, "suit") + "=" + std::to_string(suit);
}

void Take::view(int suit) {
    view_ = suit;
    header_ = headerFrom(meta_);
    const auto found = suits_.find(suit);
    if (found == suits_.end() || !found->second.suit)
        return;
    const Suit& viewed = *found->second.suit;
    header_.drive_hz = viewed.carrier_hz.value_or(header_.drive_hz);
    header_.pulse_interval_samples = viewed.pulse_interval_samples.value_or(header_.pulse_interval_samples);
    header_.pulse_cycles = viewed.pulse_cycles.value_or(header_.pulse_cycles);
    header_.sample_rate_hz = viewed.sample_rate_hz.value_or(header_.sample_rate_hz);
    if (suit == 1)
        return;
    header_.board_count = static_cast<int>(viewed.boards.size());
    header_.source_count = static_cast<int>(viewed.sources.size());
}

Result<Take> Take::open(const std::string& path, Access access, const Waiting& waiting) {
    // To be asked before there is a connection of our own.
    const bool in_use = access == Access::kReadWrite && isBeingWritten(path);
    Result<Database> database = Database::open(path, access, waiting);
    if (!database)
        return database.error();
    Take take;
    take.database_ = std::make_unique<Database>(std::move(*database));
    take.log_ = std::make_unique<SkipLog>();
    if (const Status known = take.checkIdentity(); !known)
        return known.error();
    if (const Status loaded = take.load(); !loaded)
        return loaded.error();
    if (in_use && metaText(take.meta_, "state") == "recording")
        return beingRecorded(path);
    return take;
}

Status Take::checkIdentity() const {
    const auto application = database_->queryInteger("PRAGMA application_id");
    if (!application && application.error().kind == ErrorKind::kUnreadable && !database_->isLocked() &&
        hasRemainsOfFirstPage(path()))
        return Error{ErrorKind::kUnreadable, path() + ": the file is damaged at its beginning",
                     "Run `noctule --batch recover` on it, which saves what can be read into a new file",
                     true};
    if (!application)
        return application.error();
    std::error_code unknown;
    const bool is_other = application->value_or(0) != kTakeApplicationId;
    if (is_other && std::filesystem::file_size(path(), unknown) == 0)
        return Error{ErrorKind::kUnreadable, path() + ": is empty: nothing was written into it",
                     "Choose another .noctule file"};
    if (is_other)
        return Error{ErrorKind::kUnreadable, path() + ": is not a take, it is a database of another kind",
                     "Choose a .noctule file"};
    const auto version = database_->queryInteger("PRAGMA user_version");
    if (!version)
        return version.error();
    const int64_t major = version->value_or(0) / 1000;
    if (major != kTakeMajorVersion)
        return Error{ErrorKind::kUnreadable,
                     path() + ": is a take of format version " + std::to_string(major) +
                         ", this program reads version " + std::to_string(kTakeMajorVersion),
                     major > kTakeMajorVersion ? "Install a newer Noctule" : "Write the take again"};
    return Done{};
}

Status Take::load() {
    Result<TakeSchema> schema = TakeSchema::read(*database_);
    if (!schema)
        return schema.error();
    schema_ = std::make_unique<TakeSchema>(std::move(*schema));
    if (const Status read = loadMeta(); !read)
        return read;
    return loadSuits();
}

Status Take::loadMeta() {
    using Entry = std::pair<std::string, std::string>;
    // CAST: other writers may store numbers as numbers.
    const std::string sql = schema_->has("meta")
                                ? "SELECT rowid,CAST(key AS TEXT),CAST(value AS TEXT) FROM meta"
                                : "SELECT 1 WHERE 0";
    const auto entries = collectRows<Entry>(
        *database_, *log_, "meta", sql, [](const Statement& row, Entry& entry) -> RowVerdict {
            entry.first = row.shortened(1, limits::kName);
            entry.second = row.shortened(2, longestMeta(entry.first));
            return entry.first.empty() || row.isNull(2) ? "key or value is missing" : "";
        });
    if (!entries)
        return entries.error();
    meta_ = {entries->begin(), entries->end()};
    const std::string format = metaText(meta_, "format", "noctule-take");
    if (format != "noctule-take")
        return Error{ErrorKind::kUnreadable, path() + ": is not a take, its format is '" + format + "'",
                     "Choose a .noctule file"};
    header_ = headerFrom(meta_);
    noteRefused(meta_, *log_);
    return Done{};
}

Status Take::loadSuits() {
    using Entry = std::pair<int, SuitEntry>;
    size_t read_suits = 0;
    const auto read = [this, &read_suits](const Statement& row, Entry& entry) -> RowVerdict {
        const int64_t id = row.integer(0).value_or(0);
        if (id < 1 || id > 1000)
            return "id is not 1, 2, ...";
        if (++read_suits > limits::kSuitsOfTake)
            return "the take has more than 64 suits";
        entry.first = static_cast<int>(id);
        const std::string where = path() + ": suit " + std::to_string(id);
        entry.second.suit = suitFromJson(json::parse(row.text(1).value_or("")), where);
        entry.second.clock.offset_ns = row.real(2).value_or(0);
        entry.second.clock.rate = row.real(3).value_or(1);
        return "";
    };
    const auto entries =
        collectRows<Entry>(*database_, *log_, "suit",
                           schema_->select("suit", {"id", "json", "clock_offset_ns", "clock_rate"}), read);
    if (!entries)
        return entries.error();
    suits_ = {entries->begin(), entries->end()};
    view(view_);
    return Done{};
}

TakeLevel Take::level() const {
    return metaText(meta_, "level") == "readings" ? TakeLevel::kReadings : TakeLevel::kSignal;
}

std::string Take::boxSerial() const {
    const std::string key = view_ == 1 ? "box_serial" : "x_box_serial_" + std::to_string(view_);
    return metaText(meta_, key.c_str());
}

Result<int64_t> Take::sampleRate_hz() const {
    if (header_.sample_rate_hz == 0)
        return unusable("meta has no valid sample_rate_hz, without it nothing can be processed",
                        "Add the rate with which the take was recorded to its meta table");
    return header_.sample_rate_hz;
}

std::vector<int> Take::suitIds() const {
    std::vector<int> ids;
    for (const auto& entry : suits_)
        ids.push_back(entry.first);
    return ids;
}

Result<Suit> Take::suit(int suit) const {
    suit = seen(suit);
    const auto found = suits_.find(suit);
    if (found == suits_.end())
        return unusable("suit " + std::to_string(suit) + " is not described",
                        "Use a take whose suit table has it");
    return found->second.suit;
}

SuitClock Take::suitClock(int suit) const {
    suit = seen(suit);
    const auto found = suits_.find(suit);
    return found == suits_.end() ? SuitClock{} : found->second.clock;
}

Result<int> Take::boardCount(int suit) const {
    suit = seen(suit);
    const auto described = this->suit(suit);
    if (suits_.size() > 1) {
        if (!described)
            return described.error();
        return static_cast<int>(described->boards.size());
    }
    if (header_.board_count == 0)
        return unusable("meta has no valid board_count, without it nothing can be processed",
                        "Add the number of boards (1 to 32) to its meta table");
    if (described && static_cast<int>(described->boards.size()) != header_.board_count)
        return unusable("meta says " + std::to_string(header_.board_count) + " boards, the suit describes " +
                            std::to_string(described->boards.size()),
                        "Correct board_count in meta or the suit's JSON");
    return header_.board_count;
}

Result<int> Take::sourceCount(int suit) const {
    suit = seen(suit);
    const auto described = this->suit(suit);
    if (described)
        return static_cast<int>(described->sources.size());
    if (suits_.size() <= 1 && header_.source_count > 0)
        return header_.source_count;
    return described.error();
}

int64_t Take::lastSample() const {
    return header_.sample_rate_hz == 0
               ? kLastSample
               : std::min(kLastSample, limits::kLongestTake_s * header_.sample_rate_hz);
}

Result<int64_t> Take::sampleCount(int suit) const {
    suit = seen(suit);
    const double stated = metaNumber(meta_, "sample_count", 0, 1, static_cast<double>(lastSample()));
    if (stated > 0 && suit == 1)  // meta speaks of suit 1
        return std::llround(stated);
    const auto rate_hz = [&](int of) {
        const auto found = suits_.find(of);
        const bool known = found != suits_.end() && found->second.suit && found->second.suit->sample_rate_hz;
        return known ? static_cast<double>(*found->second.suit->sample_rate_hz)
                     : metaNumber(meta_, "sample_rate_hz", 1, 1, limits::kHighestRate_hz);
    };
    if (stated > 0 && level() == TakeLevel::kReadings)
        return std::llround(
            std::max(0.0, suitClock(suit).suitTime_s(suitClock(1).takeTime_s(stated / rate_hz(1)))) *
            rate_hz(suit));
    if (level() == TakeLevel::kReadings)
        return samplesOfReadings(*database_, *schema_, suit, lastSample(),
                                 limits::kLongestHole_s * std::llround(rate_hz(suit)));
    if (!schema_->has("adc_block"))
        return int64_t{0};
    // The last few only: they stand in order, and walking through all sound takes long. A few, for the very
    // last row may be damage.
    const auto end = database_->queryInteger(
        "SELECT max(first_sample+sample_count) FROM (SELECT first_sample,sample_count FROM adc_block" +
        ofSuit("adc_block", suit) + " ORDER BY first_sample DESC LIMIT 16)");
    if (!end)
        return end.error();
    return std::clamp<int64_t>(end->value_or(0), 0, lastSample());
}

Result<double> Take::duration_s(int suit) const {
    suit = seen(suit);
    const auto samples = sampleCount(suit);
    const auto rate_hz = sampleRate_hz();
    if (!samples || !rate_hz)
        return samples ? rate_hz.error() : samples.error();
    return static_cast<double>(*samples) / static_cast<double>(*rate_hz);
}

Result<std::vector<std::string>> Take::missingParts() const {
    std::vector<std::string> missing;
    if (header_.sample_rate_hz == 0)
        missing.push_back("meta: sample_rate_hz (nothing can be processed)");
    if (header_.board_count == 0 && suits_.size() <= 1)
        missing.push_back("meta: board_count (nothing can be processed)");
    const bool sound = level() == TakeLevel::kSignal;
    const std::vector<std::pair<std::string, std::string>> wanted{
        {"suit", "suit: which boards and sources there are"},
        {"calibration", "calibration: how counts become values"},
        {"actor", "actor: the performer's measures"},
        {sound ? "adc_block" : "inertial", sound ? "adc_block: sound" : "inertial: readings"},
        {sound ? "pulse" : "range", sound ? "pulse: what the sources sent" : "range: distances"}};
    for (const auto& [table, words] : wanted) {
        const auto some = schema_->has(table) ? database_->queryInteger("SELECT 1 FROM " + table + " LIMIT 1")
                                              : Result<std::optional<int64_t>>(std::nullopt);
        if (!some)
            return some.error();
        if (!*some)
            missing.push_back(words);
    }
    return missing;
}

}  // namespace noctule
