// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/offset_findings.h"

#include <cmath>

#include "core/body/text.h"
#include "core/calibration/source_offsets/jig_groups.h"
#include "core/math/order_statistics.h"

namespace noctule {
namespace {

// Of the leave-one-out error: the paper's own is the limit of good.
constexpr double kGoodMean_m = 2.35e-3, kUsableMean_m = 5e-3;
constexpr double kGoodSigma_m = 5e-4, kUsableSigma_m = 2e-3;
constexpr double kMostSpread_m = 5e-3;  // beyond it distances and sound have little to do with each other
constexpr double kFewOutliers = 0.05;
constexpr double kSurprisingStretch = 4;  // times the thermometer's tolerance
constexpr double kLikelyStretch = 0.015, kPossibleStretch = 0.04;
constexpr double kVagueStretch = 2e-3;

struct OffsetBounds {
    double least_s, most_s;
};
/// Inflection: 18 to 25 samples at 150 kHz (core/recording/README.md, section 5) and what a source may
/// differ.
constexpr OffsetBounds kLikelyInflection{100e-6, 200e-6}, kPossibleInflection{50e-6, 300e-6};
constexpr OffsetBounds kPossibleOfAny{0, 1e-3};
/// Matched: the start of the sound, some microseconds; as much less as a learnt pulse may err.
constexpr OffsetBounds kPossibleMatched{-2e-5, 2e-4};

std::string inMillimetres(double length_m) {
    return text::number(1e3 * length_m, std::abs(length_m) < 9.95e-3 ? 1 : 0) + " mm";
}

bool isWithin(double value, const OffsetBounds& bounds) {
    return value >= bounds.least_s && value <= bounds.most_s;
}

class OffsetJudge {
public:
    OffsetJudge(const OffsetJudgement& judgement, SourceOffsetReport& report)
        : jig_(judgement.jig), settings_(judgement.settings), fit_(judgement.fit), report_(report) {}

    void judge() {
        judgeSources();
        judgeMoved();
        judgeOutliers();
        judgeSpread();
        judgeStretch();
        judgeLeaveOneOut();
    }

private:
    void find(Grade grade, const std::string& part, const std::string& what, const std::string& remedy) {
        report_.findings.push_back({grade, part, asSentence(what), remedy});
    }

    void judgeSources() {
        bool any = false;
        for (size_t s = 0; s < report_.sources.size(); ++s) {
            const SourceOffset& source = report_.sources[s];
            any |= source.calibrated;
            source.calibrated ? judgeOffset(source, static_cast<int>(s))
                              : reportMissing(source, static_cast<int>(s));
        }
        if (!any)
            find(Grade::kNotUsable, "", "No source could be calibrated",
                 "Mend what the other lines name and calibrate again");
    }

    void judgeOffset(const SourceOffset& source, int index) {
        const bool is_inflection = report_.detector == "inflection";
        const std::string offset = text::number(1e6 * source.offset_s, 0) + " \u00b5s";
        const OffsetBounds& possible = is_inflection                   ? kPossibleInflection
                                       : report_.detector == "matched" ? kPossibleMatched
                                                                       : kPossibleOfAny;
        if (!isWithin(source.offset_s, possible))
            find(Grade::kNotUsable, source.id,
                 jigSource(jig_.suit, index) + " has an offset of " + offset + ", which no source can have",
                 "See that the distances reach from the source's face to the microphone's opening");
        else if (is_inflection && !isWithin(source.offset_s, kLikelyInflection))
            find(Grade::kUsable, source.id,
                 jigSource(jig_.suit, index) + " has an offset of " + offset +
                     "; 100 to 200 \u00b5s are usual",
                 "See that its point was touched where the sound leaves it");
        const double sigma_m = source.sigma_s * 340;
        if (sigma_m > kGoodSigma_m)
            find(sigma_m > kUsableSigma_m ? Grade::kNotUsable : Grade::kUsable, source.id,
                 jigSource(jig_.suit, index) + ": its offset is known to " + inMillimetres(sigma_m) + " only",
                 "Record more placements, 30 to 90 cm apart");
    }

    void reportMissing(const SourceOffset& source, int index) {
        int heard = 0, mislabelled = 0;
        for (const JigMeasurement& m : report_.measurements)
            if (m.source == index) {
                ++heard;
                mislabelled += m.mislabelled ? 1 : 0;
            }
        const std::string why = heard == 0        ? "no board heard it where its distance is known"
                                : mislabelled > 0 ? "its label looks exchanged"
                                                  : "only " + std::to_string(source.measurements) + " of " +
                                                        std::to_string(heard) + " measurements can be used";
        find(Grade::kUsable, source.id,
             jigSource(jig_.suit, index) + " could not be calibrated and keeps what it had: " + why,
             heard == 0
                 ? "See that it sounds and that the file has its point"
                 : "Measure it again, in at least " + std::to_string(settings_.min_measurements) + " pairs");
    }

    void judgeMoved() {
        std::vector<bool> moved;
        for (const JigMeasurement& m : report_.measurements)
            moved.push_back(m.moved && !m.mislabelled);
        for (const JigGroup& group : groupFlagged(jig_, moved))
            if (!group.part.empty() || group.flagged.size() > 1)
                find(weightOf(group.flagged.size()), group.part,
                     group.words + " moved while it was measured; those measurements are left out",
                     "Record it again and leave the jig alone between the markers");
    }

    void judgeOutliers() {
        std::vector<bool> outliers;
        for (const JigMeasurement& m : report_.measurements)
            outliers.push_back(!m.used && !m.moved && !m.mislabelled);
        for (const JigGroup& group : groupFlagged(jig_, outliers)) {
            std::vector<double> off_m;
            for (const size_t i : group.flagged)
                off_m.push_back(fit_.misfit_s[i] * report_.measurements[i].c_m_per_s);
            const double middle_m = medianOf(off_m);
            find(weightOf(group.flagged.size()), group.part,
                 group.words + ": sound says " + inMillimetres(std::abs(middle_m)) +
                     (middle_m > 0 ? " more" : " less") + " than the file, in " +
                     std::to_string(group.flagged.size()) + " of " + std::to_string(group.total) +
                     " measurements; they are left out",
                 middle_m > 0 ? "Look for what stands in the sound's way, then measure the points again"
                              : "Measure the points again");
        }
    }

    Grade weightOf(size_t left_out) const {
        return static_cast<double>(left_out) < kFewOutliers * static_cast<double>(report_.measurements.size())
                   ? Grade::kGood
                   : Grade::kUsable;
    }

    void judgeSpread() {
        const double spread_m = fit_.spread_s * 340;
        if (spread_m > kMostSpread_m)
            find(Grade::kNotUsable, "",
                 "The flight times do not follow the distances: they differ by " + inMillimetres(spread_m) +
                     " on the whole",
                 "See that the file belongs to this take and that its labels are right");
    }

    void judgeStretch() {
        const double stretch = fit_.stretch, size = std::abs(stretch);
        const std::string kelvin = text::number(size / kStretchPerKelvin, 1) + " K";
        const std::string air = std::string(stretch > 0 ? "colder" : "warmer") + " than the thermometer says";
        const std::string excess =
            "The distances fit the flight times as if the air were " + kelvin + " " + air;
        if (size > kPossibleStretch)
            return find(Grade::kNotUsable, "", excess,
                        "Look for a wrong scale in the distances, then for a wrong thermometer");
        if (report_.sound_estimated && size > kLikelyStretch)
            return find(Grade::kUsable, "", excess, "Compare the box's thermometer with another");
        if (report_.sound_estimated && fit_.stretch_sigma > kVagueStretch)
            return find(Grade::kUsable, "",
                        "The distances are too much alike to tell the speed of sound; it is known to " +
                            text::number(100 * fit_.stretch_sigma, 1) + " %",
                        "Add placements from 30 to 90 cm, or take the speed of sound from the thermometer");
        const double tolerance = settings_.thermometer_sigma_k * kStretchPerKelvin;
        if (!report_.sound_estimated && tolerance > 0 && size > kSurprisingStretch * tolerance)
            find(Grade::kUsable, "", excess,
                 "Compare the thermometer with another, or let the distances tell the speed of sound");
    }

    void judgeLeaveOneOut() {
        const DistanceErrors& errors = report_.leave_one_out;
        if (errors.count == 0 || errors.mean_m <= kGoodMean_m)
            return;
        find(errors.mean_m > kUsableMean_m ? Grade::kNotUsable : Grade::kUsable, "",
             "Distances are off by " + inMillimetres(errors.mean_m) + " on average, " +
                 inMillimetres(errors.worst_m) + " at worst; good is under " + inMillimetres(kGoodMean_m),
             "Measure the points again, where the sound leaves the source and enters the microphone");
    }

    const JigData& jig_;
    const SourceOffsetSettings& settings_;
    const OffsetFit& fit_;
    SourceOffsetReport& report_;
};

}  // namespace

Finding findingOf(const UnitMistake& mistake, const std::string& where) {
    const double times = mistake.factor > 1 ? mistake.factor : 1 / mistake.factor;
    return {Grade::kNotUsable, "",
            "The distances of " + where + " are " + text::number(times, times < 50 ? 1 : 0) + " times too " +
                (mistake.factor > 1 ? "large, " : "small, ") + mistake.words,
            "Correct the heading or the values, then calibrate again"};
}

Finding findingOf(const SwappedLabels& swap, const Suit& suit) {
    using Kind = SwappedLabels::Kind;
    const auto words = [&](const std::string& id) {
        return swap.kind == Kind::kBoards    ? jigBoard(suit, suit.findBoard(id))
               : swap.kind == Kind::kSources ? jigSource(suit, suit.findSource(id))
                                             : "placement " + id;
    };
    const bool is_bad = swap.kind == Kind::kSources && swap.placement.empty();
    return {is_bad ? Grade::kNotUsable : Grade::kUsable, swap.kind == Kind::kPlacements ? "" : swap.first,
            asSentence(words(swap.first)) + " and " + words(swap.second) + " look exchanged" +
                (swap.placement.empty() ? "" : " in placement " + swap.placement) + "; both are left out",
            "Exchange the two labels in the file, or the two parts on the suit, and calibrate again"};
}

void judgeOffsets(const OffsetJudgement& judgement, SourceOffsetReport& report) {
    OffsetJudge(judgement, report).judge();
}

}  // namespace noctule
