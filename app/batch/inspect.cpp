// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>

#include "app/batch/takes.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/processing/inspect_take.h"

namespace noctule::batch {
namespace {

constexpr size_t kShown = 2000;                  ///< bytes of a line's value
constexpr size_t kRowHead = 24, kIdColumn = 16;  ///< bytes of an id in a table

std::string line(const std::string& what, const std::string& value) {
    char text[32];
    std::snprintf(text, sizeof text, "  %-14s ", what.c_str());
    return value.empty() ? "" : text + visibleText(shortText(value, kShown)) + "\n";
}

std::string headOfRow(const std::string& id) {
    return shortText(visibleText(id), kRowHead);
}

std::string counted(int64_t count, const std::string& what) {
    return std::to_string(count) + " " + what;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
    return text;
}

template <class Rows>
auto firstRows(const Rows& rows) {
    return std::span(rows).first(std::min(rows.size(), limits::kListedRows));
}

std::string ofReference(const SuitInspection& in, const std::string& kind) {
    return line("reference", in.reference_frames == 0 ? ""
                                                      : counted(in.reference_frames, "frames") +
                                                            (kind.empty() ? "" : ", " + kind)) +
           line("external root", in.external_root_rows == 0 ? "" : counted(in.external_root_rows, "rows"));
}

std::string ofSound(const SuitInspection& in, TakeLevel level) {
    return level == TakeLevel::kReadings ? line("readings", counted(in.pulses, "pulses"))
                                         : line("sound", counted(in.blocks, "blocks, ") +
                                                             counted(in.hole_samples, "samples missing, ") +
                                                             counted(in.pulses, "pulses"));
}

std::string countsOf(const SuitInspection& in) {
    return counted(std::ssize(in.boards), "boards, ") + counted(std::ssize(in.sources), "sources");
}

/// Gaps and markers.
std::string timedRowsText(const SuitInspection& in) {
    std::string text;
    for (const GapRow& gap : firstRows(in.gaps))
        text += line("gap", counted(gap.sample_count, "samples from ") + std::to_string(gap.first_sample) +
                                (gap.board ? ", board " + std::to_string(*gap.board + 1) : ", all boards") +
                                (gap.reason.empty() ? "" : ", " + gap.reason));
    for (const MarkerRow& marker : firstRows(in.markers))
        text +=
            line("marker", marker.kind + " " + marker.label + " at sample " + std::to_string(marker.sample));
    return text;
}

/// Of a take with several suits each says the rest itself.
std::string headText(const TakeInspection& in) {
    char duration[64];
    std::snprintf(duration, sizeof duration, "%.2f s at %lld Hz", in.duration_s,
                  static_cast<long long>(in.header.sample_rate_hz));
    const std::string text = in.path + "\n" +
                             line("take", in.header.name + ", " + in.header.take_kind + ", " +
                                              (in.state.empty() ? "state unknown" : in.state) + ", made " +
                                              in.header.created_utc + " by " + in.header.software) +
                             line("performer", in.performer) + line("duration", duration);
    if (!in.suits.empty())
        return text + line("suits", counted(std::ssize(in.suits), "suits"));
    return text + line("suit", in.suit_name + (in.suit_name.empty() ? "" : ": ") + countsOf(in)) +
           line("calibration", in.calibration) + line("actor", in.actor) + ofSound(in, in.level) +
           ofReference(in, in.reference_kind) + timedRowsText(in);
}

std::string rowsText(const TakeInspection& in) {
    std::string text;
    for (const NoteRow& note : firstRows(in.notes))
        text += line("note", note.text);
    for (const DriveSummary& drive : firstRows(in.drives))
        text += line("robot " + std::to_string(drive.about.drive), summaryText(drive));
    for (const DerivedRun& run : firstRows(in.runs))
        text += line("result " + std::to_string(run.run),
                     run.kind + " '" + run.name + "', " + run.created_utc + ", " + run.software);
    return text;
}

std::string boardsText(const SuitInspection& in) {
    std::string text;
    for (const WireQuality& wire : in.wires)
        if (wire.silent || wire.clipped > 0)
            text += line(wire.board, wire.silent ? "silent: not a single sample differs from zero"
                                                 : counted(wire.clipped, "clipped sound samples"));
    if (in.board_quality.empty())
        return text;
    char row[160];
    std::snprintf(row, sizeof row, "\n  %-14s %10s %10s %10s %10s\n", "board", "frames", "lost", "readings",
                  "clipped");
    text += row;
    for (const ReportBoard& board : in.board_quality) {
        const double share = board.readings_expected == 0 ? 0
                                                          : static_cast<double>(board.readings_present) /
                                                                static_cast<double>(board.readings_expected);
        std::snprintf(row, sizeof row, "  %-14s %10lld %10lld %10s %10lld", headOfRow(board.id).c_str(),
                      static_cast<long long>(board.frames_expected),
                      static_cast<long long>(board.frames_lost), percent(share).c_str(),
                      static_cast<long long>(board.clipped_gyro + board.clipped_accel));
        text += row;
        for (const auto& [when_s, what] :
             {std::pair(board.joined_s, "joined"), std::pair(board.left_s, "left")})
            if (when_s) {
                std::snprintf(row, sizeof row, "  %s at %.2f s", what, *when_s);
                text += row;
            }
        text += '\n';
    }
    return text;
}

/// Share of the pulses heard: boards down, sources across.
std::string pairsText(const SuitInspection& in) {
    if (in.pairs.empty())
        return "";
    char cell[64];
    std::snprintf(cell, sizeof cell, "\n  %-14s", "heard %");
    std::string text = cell;
    for (const std::string& source : in.sources) {
        std::snprintf(cell, sizeof cell, " %8s", shortText(visibleText(source), kIdColumn).c_str());
        text += cell;
    }
    for (const std::string& board : in.boards) {
        std::snprintf(cell, sizeof cell, "\n  %-14s", headOfRow(board).c_str());
        text += cell;
        for (const PairSummary& pair : in.pairs)
            if (pair.board == board) {
                std::snprintf(cell, sizeof cell, " %8.0f", 100 * pair.heard_share);
                text += cell;
            }
    }
    return text + "\n";
}

std::string suitText(const SuitSummary& suit, const TakeInspection& in) {
    char carrier[32];
    std::snprintf(carrier, sizeof carrier, " at %.1f kHz", suit.carrier_hz / 1000);
    const std::string who = suit.room              ? "the room"
                            : suit.subject.empty() ? "nobody"
                                                   : "subject " + suit.subject;
    return "\n" +
           line("suit " + std::to_string(suit.suit),
                who + (suit.suit_name.empty() ? "" : ", '" + suit.suit_name + "'") + ": " + countsOf(suit) +
                    carrier) +
           line("calibration", suit.calibration) + line("actor", suit.actor) + ofSound(suit, in.level) +
           line("status", suit.status.empty() ? "" : counted(std::ssize(suit.status), "rows")) +
           ofReference(suit, in.reference_kind) + timedRowsText(suit) + boardsText(suit) + pairsText(suit);
}

std::string inspectionText(const TakeInspection& in) {
    std::string text = headText(in) + rowsText(in);
    for (const std::string& missing : in.missing)
        text += line("missing", missing);
    for (const std::string& problem : in.problems)
        text += line("problem", problem);
    for (const SuitSummary& suit : in.suits)
        text += suitText(suit, in);
    return in.suits.empty() ? text + boardsText(in) + pairsText(in) : text;
}

Result<Outcome> runInspect(const VerbContext& context) {
    return forEachTake(context, 1, [](const std::string& take, const JobContext& job) -> Result<Outcome> {
        const auto inspection = inspectTake(take, job);
        if (!inspection)
            return inspection.error();
        return Outcome{toJson(*inspection), inspectionText(*inspection), std::nullopt};
    });
}

}  // namespace

Verb inspectVerb() {
    Verb verb;
    verb.name = "inspect";
    verb.summary = "show what is in a take, what is missing, and the quality per board and pair";
    verb.operands = "T.noctule...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch inspect hops_001.noctule";
    verb.remarks = {
        "Shares of lost frames and of pulses heard need readings and ranges: process the take "
        "first."};
    verb.run = runInspect;
    return verb;
}

}  // namespace noctule::batch
