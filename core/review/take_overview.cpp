// SPDX-License-Identifier: Apache-2.0
// What is known of a take at once: nothing here reads a table whose length grows with the take, except the
// few rows of markers, gaps and notes.
#include <algorithm>
#include <filesystem>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/job/problems.h"
#include "core/processing/ingredients.h"
#include "core/review/review_file.h"
#include "core/review/take_review.h"

namespace noctule {
namespace {

class Overview {
public:
    explicit Overview(const ViewedTake& viewed) : take_(viewed.take), markers_(viewed.markers) {
        view_.path = take_.path();
        view_.subjects = viewed.subjects;
        view_.suit_in_view = viewed.suit;
    }

    TakeOverview read() {
        readHead();
        readWearing();
        readParties();
        readMarks();
        readRuns();
        readAttachments();
        for (const SkippedRows& skipped : take_.skippedRows())
            problems_.add(std::to_string(skipped.count) + " rows of " + skipped.table +
                          " could not be used, first " + skipped.first + ".");
        view_.damage = problems_.damage();
        view_.problems = std::move(problems_).sentences();
        return std::move(view_);
    }

private:
    std::string meta(const char* key) const {
        const auto found = take_.meta().find(key);
        return found == take_.meta().end() ? "" : found->second;
    }

    double seconds(int64_t sample) const {
        return view_.sample_rate_hz > 0
                   ? take_.suitClock().takeTime_s(static_cast<double>(sample) / view_.sample_rate_hz)
                   : 0;
    }

    void readHead() {
        view_.header = take_.header();
        view_.state = meta("state");
        view_.performer = meta("performer");
        view_.level = take_.level();
        view_.sample_rate_hz = static_cast<double>(view_.header.sample_rate_hz);
        view_.duration_s = seconds(problems_.keep(take_.sampleCount()).value_or(0));
        std::error_code ignored;
        for (const char* part : {"", "-wal"})
            if (const auto size = std::filesystem::file_size(view_.path + part, ignored); !ignored)
                view_.bytes += static_cast<int64_t>(size);
        if (view_.state == "recording")
            problems_.add("The take was never closed: it is being recorded, or the recording was cut short.");
        for (const std::string& part :
             problems_.keep(take_.missingParts()).value_or(std::vector<std::string>{}))
            problems_.add("The take lacks a part: " + part + ".");
    }

    void readWearing() {
        if (!take_.suitIds().empty())
            view_.suit = problems_.keep(take_.suit()).value_or(Suit{});
        view_.calibration = nominalCalibration(view_.suit);
        if (const auto rows = problems_.keep(take_.calibrations()); rows && !rows->empty())
            if (auto stored = problems_.keep(take_.calibrationInForce()))
                view_.calibration = std::move(stored->value);
        view_.lack = lackOfTake(take_, view_.suit, view_.calibration);
        if (const auto rows = problems_.keep(take_.actors()); rows && !rows->empty())
            if (auto stored = problems_.keep(take_.actorInForce()))
                view_.actor = std::move(stored->value);
    }

    void readParties() {
        const auto subjects = problems_.keep(take_.subjects()).value_or(std::vector<TakeSubject>{});
        const auto rows = problems_.keep(take_.calibrations()).value_or(std::vector<DocumentRow>{});
        for (const bool room : {false, true})
            for (const TakeSubject& subject : subjects) {
                if (subject.room != room)
                    continue;
                TakeParty party{subject, problems_.keep(take_.suit(subject.suit())).value_or(Suit{}), {}};
                party.lost_in_rest_s = lostInRest_s(subject.suit());
                party.calibration = nominalCalibration(party.suit);
                if (std::ranges::find(rows, subject.suit(), &DocumentRow::suit) != rows.end())
                    if (auto stored = problems_.keep(take_.calibrationInForce(subject.suit())))
                        party.calibration = std::move(stored->value);
                view_.parties.push_back(std::move(party));
            }
    }

    std::optional<double> lostInRest_s(int suit) {
        const auto rest = problems_.keep(take_.restInterval(suit));
        const auto samples = problems_.keep(take_.sampleCount(suit));
        const auto duration_s = problems_.keep(take_.duration_s(suit));
        if (!rest || !*rest || !samples || !duration_s || !endsInRest(*samples, (*rest)->last))
            return std::nullopt;
        return take_.suitClock(suit).takeTime_s(*duration_s);
    }

    void readMarks() {
        for (MarkerRow& marker :
             problems_.keep(take_.markers(markers_.suit)).value_or(std::vector<MarkerRow>{}))
            if (marker.kind != "rest")
                view_.markers.push_back(
                    {markers_.seconds(marker.sample), std::move(marker.kind), std::move(marker.label)});
        if (const auto rest = problems_.keep(take_.restInterval()); rest && *rest)
            view_.rest_s = std::pair(seconds((*rest)->first), seconds((*rest)->last));
        for (const GapRow& gap : problems_.keep(take_.gaps()).value_or(std::vector<GapRow>{}))
            if (gap.board)
                board_gaps_.push_back(gap);
            else
                view_.gaps_s.emplace_back(seconds(gap.first_sample),
                                          seconds(gap.first_sample + gap.sample_count));
        readSilences();
        view_.notes = problems_.keep(take_.notes()).value_or(std::vector<NoteRow>{});
    }

    /// A silence is written in pieces of about a second; a short pause between two of them is part of it.
    void readSilences() {
        constexpr double kPause_s = 0.25;
        std::ranges::stable_sort(board_gaps_, {}, &GapRow::first_sample);
        for (const GapRow& gap : board_gaps_) {
            const double from_s = seconds(gap.first_sample),
                         to_s = seconds(gap.first_sample + gap.sample_count);
            const auto open = std::ranges::find_if(view_.silences, [&](const BoardSilence& silence) {
                return silence.board == *gap.board && *silence.back_s + kPause_s >= from_s;
            });
            if (open == view_.silences.end())
                view_.silences.push_back({*gap.board, from_s, to_s});
            else
                open->back_s = std::max(*open->back_s, to_s);
        }
        std::erase_if(view_.silences, [](const BoardSilence& silence) {
            return *silence.back_s - silence.from_s < kPause_s;
        });
        for (BoardSilence& silence : view_.silences)
            if (*silence.back_s + kPause_s >= view_.duration_s)
                silence.back_s.reset();
    }

    void readRuns() {
        const auto all = problems_.keep(take_.derivedRuns()).value_or(std::vector<DerivedRun>{});
        for (const DerivedRun& run : poseRuns(all))
            view_.runs.push_back({run, runSettings(run, all, view_.level), resultNumber(take_, all, run)});
    }

    void readAttachments() {
        view_.contacts_edited = problems_.keep(take_.editedContacts()).value_or(std::nullopt).has_value();
        view_.has_reference = problems_.keep(take_.hasRows("reference")).value_or(false);
        view_.has_external_root = problems_.keep(take_.hasRows("external_root")).value_or(false);
        if (view_.has_reference)
            view_.reference_kind = shortText(meta("reference_kind"), limits::kName);
    }

    const Take& take_;
    const MarkerClock& markers_;
    TakeOverview view_;
    std::vector<GapRow> board_gaps_;
    Problems problems_;
};

}  // namespace

const TakeParty* TakeOverview::partyOf(int of_suit) const {
    const auto found = std::ranges::find_if(
        parties, [&](const TakeParty& party) { return party.subject.suit() == of_suit; });
    return found == parties.end() ? nullptr : &*found;
}

Result<TakeOverview> overviewTake(const TakeView& view, const JobContext& job) {
    const auto viewed = ViewedTake::open(view);
    if (!viewed)
        return viewed.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    return Overview(*viewed).read();
}

}  // namespace noctule
