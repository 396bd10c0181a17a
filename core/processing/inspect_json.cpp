// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/job/limits.h"
#include "core/math/json.h"
#include "core/processing/inspect_take.h"

namespace noctule {
namespace {

template <class T, class ToJson>
nlohmann::json list(const std::vector<T>& values, ToJson toJson) {
    nlohmann::json array = nlohmann::json::array();
    for (size_t i = 0; i < std::min(values.size(), limits::kListedRows); ++i)
        array.push_back(toJson(values[i]));
    return array;
}

using json::orNull;
using json::textOrNull;

/// What stands on the time axis of one suit.
nlohmann::json timedRowsJson(const SuitInspection& in) {
    using nlohmann::json;
    return {{"gaps", list(in.gaps,
                          [](const GapRow& gap) {
                              return json{{"first_sample", gap.first_sample},
                                          {"sample_count", gap.sample_count},
                                          {"board", gap.board ? json(*gap.board) : json(nullptr)},
                                          {"reason", gap.reason}};
                          })},
            {"markers", list(in.markers, [](const MarkerRow& marker) {
                 return json{{"sample", marker.sample}, {"kind", marker.kind}, {"label", marker.label}};
             })}};
}

nlohmann::json rowsJson(const TakeInspection& in) {
    using nlohmann::json;
    return {{"notes", list(in.notes,
                           [](const NoteRow& note) {
                               return json{{"created_utc", note.created_utc}, {"text", note.text}};
                           })},
            {"drives", list(in.drives, [](const DriveSummary& drive) { return toJson(drive); })},
            {"runs", list(in.runs, [](const DerivedRun& run) {
                 const json settings = noctule::json::parse(run.settings_json);
                 return json{{"run", run.run},
                             {"kind", run.kind},
                             {"name", run.name},
                             {"created_utc", run.created_utc},
                             {"software", run.software},
                             {"settings", settings.is_discarded() ? json(nullptr) : settings}};
             })}};
}

nlohmann::json qualityJson(const SuitInspection& in) {
    using nlohmann::json;
    return {{"sound", list(in.wires,
                           [](const WireQuality& wire) {
                               return json{{"board", wire.board},
                                           {"samples", wire.samples},
                                           {"clipped", wire.clipped},
                                           {"silent", wire.silent}};
                           })},
            {"inertia", list(in.board_quality,
                             [](const ReportBoard& board) {
                                 return json{{"board", board.id},
                                             {"frames_expected", board.frames_expected},
                                             {"frames_lost", board.frames_lost},
                                             {"joined_s", orNull(board.joined_s)},
                                             {"left_s", orNull(board.left_s)},
                                             {"readings_expected", board.readings_expected},
                                             {"readings_present", board.readings_present},
                                             {"clipped", board.clipped_gyro + board.clipped_accel},
                                             {"corrected_bits", board.corrected_bits}};
                             })},
            {"pairs", list(in.pairs, [](const PairSummary& pair) {
                 return json{{"source", pair.source},
                             {"board", pair.board},
                             {"heard_share", pair.heard_share},
                             {"used_share", pair.used_share},
                             {"confidence", pair.confidence}};
             })}};
}

/// `boards` and `sources` are counts; the ids have members of their own.
nlohmann::json suitJson(const SuitSummary& suit) {
    nlohmann::json json = {{"suit", suit.suit},
                           {"name", suit.suit_name},
                           {"subject", textOrNull(suit.subject)},
                           {"room", suit.room},
                           {"duration_s", suit.duration_s},
                           {"boards", suit.boards.size()},
                           {"sources", suit.sources.size()},
                           {"board_ids", suit.boards},
                           {"source_ids", suit.sources},
                           {"calibration", textOrNull(suit.calibration)},
                           {"actor", textOrNull(suit.actor)},
                           {"not_calibrated", textOrNull(lackInWords(suit.lack))},
                           {"carrier_hz", suit.carrier_hz},
                           {"blocks", suit.blocks},
                           {"block_samples", suit.block_samples},
                           {"hole_samples", suit.hole_samples},
                           {"pulses", suit.pulses},
                           {"status_rows", suit.status.size()},
                           {"reference_frames", suit.reference_frames},
                           {"external_root_rows", suit.external_root_rows},
                           {"quality", qualityJson(suit)}};
    json.update(timedRowsJson(suit));
    return json;
}

}  // namespace

nlohmann::json toJson(const TakeInspection& in) {
    nlohmann::json json = {
        {"take", in.path},
        {"name", in.header.name},
        {"uuid", in.header.uuid},
        {"created_utc", in.header.created_utc},
        {"software", in.header.software},
        {"kind", in.header.take_kind},
        {"state", textOrNull(in.state)},
        {"performer", textOrNull(in.performer)},
        {"level", in.level == TakeLevel::kReadings ? "readings" : "signal"},
        {"duration_s", in.duration_s},
        {"sample_rate_hz", in.header.sample_rate_hz},
        {"suit", textOrNull(in.suit_name)},
        {"boards", in.boards},
        {"sources", in.sources},
        {"calibration", textOrNull(in.calibration)},
        {"actor", textOrNull(in.actor)},
        {"not_calibrated", textOrNull(lackInWords(in.lack))},
        {"blocks", in.blocks},
        {"block_samples", in.block_samples},
        {"hole_samples", in.hole_samples},
        {"pulses", in.pulses},
        {"reference", {{"frames", in.reference_frames}, {"kind", textOrNull(in.reference_kind)}}},
        {"external_root_rows", in.external_root_rows},
        {"quality", qualityJson(in)},
        {"missing", in.missing},
        {"problems", in.problems}};
    if (!in.suits.empty())
        json["suits"] = list(in.suits, suitJson);
    json.update(timedRowsJson(in));
    json.update(rowsJson(in));
    return json;
}

}  // namespace noctule
