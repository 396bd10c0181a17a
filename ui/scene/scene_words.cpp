// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/style/lengths.h"
#include "ui/style/performer_disc.h"
#include "ui/style/words.h"

namespace noctule::ui {

namespace {

/// The callout stays clear of the handles.
constexpr double kHandles_px = 84;

struct SceneWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::SceneWords)
};

QString boardLine(const Suit& suit, int board) {
    return SceneWords::tr("%1, board %2")
        .arg(boardName(suit.boards[static_cast<size_t>(board)]))
        .arg(board + 1);
}
QString sourceLine(const Suit& suit, int source) {
    return SceneWords::tr("%1, source %2")
        .arg(sourcePlace(suit.sources[static_cast<size_t>(source)]))
        .arg(source + 1);
}

QString pairLine(const ComposedScene& composed, int source, int board) {
    const auto heard = std::find_if(composed.pairs.begin(), composed.pairs.end(), [&](const HeardPair& pair) {
        return pair.source == source && pair.board == board;
    });
    if (std::ranges::count(composed.quiet_sources, source) > 0)
        return SceneWords::tr("No pulse from source %1 at this time").arg(source + 1);
    if (heard == composed.pairs.end())
        return SceneWords::tr("Not heard from source %1").arg(source + 1);
    return SceneWords::tr("Source %1, confidence %2").arg(source + 1).arg(numberText(heard->confidence, 2));
}

QString withChosen(const QString& words, const std::optional<SceneCallout>& callout) {
    return callout ? SceneWords::tr("%1. Chosen: %2").arg(words, callout->title) : words;
}

}  // namespace

std::vector<SceneLegend> takeLegends(TakeDocument& take, const ComposedScene& composed,
                                     const SceneLayers& layers, bool beside_other) {
    const bool is_reference = take.comparedRun() == TakeDocument::kReference;
    const auto result = [&](int run) { return SceneWords::tr("Result %1").arg(take.numberOf(run)); };
    const QString compared = is_reference ? SceneWords::tr("Reference") : result(take.comparedRun());
    if (composed.subject == SceneSubject::kCompared)
        return {{compared, false}};
    if (!composed.has_ghost || !layers.has(SceneLayer::kGhost))
        return beside_other ? std::vector<SceneLegend>{{result(take.shownRun()), false}}
                            : std::vector<SceneLegend>{};
    return {{result(take.shownRun()), false}, {compared, true}};
}

std::optional<SceneCallout> partCallout(const Suit& suit, const Selection& selection,
                                        const ComposedScene& composed, bool has_ranges) {
    const int board = selection.board(), source = selection.source();
    if (!composed.hasBody())
        return std::nullopt;
    const bool has_board = board >= 0 && board < static_cast<int>(composed.places.boards.size());
    const bool has_source = source >= 0 && source < static_cast<int>(composed.places.sources.size());
    if (has_board)
        return SceneCallout{{},
                            boardLine(suit, board),
                            has_source && has_ranges ? pairLine(composed, source, board) : QString()};
    if (has_source)
        return SceneCallout{{}, sourceLine(suit, source), {}};
    return std::nullopt;
}

std::optional<SceneCallout> figureCallout(const FigureScene& figure) {
    const SuitPart part = figure.chosen();
    if (part.kind == SuitPart::Kind::kNone)
        return std::nullopt;
    return SceneCallout{{},
                        part.kind == SuitPart::Kind::kBoard ? boardLine(figure.suit(), part.index)
                                                            : sourceLine(figure.suit(), part.index),
                        {},
                        kHandles_px};
}

QString takeDescription(ReviewContext& review, const ComposedScene& composed,
                        const std::optional<SceneCallout>& callout) {
    if (!composed.hasBody())
        return whyEmpty(review);
    const QString time = timeText(review.time().time());
    const QString words = composed.pair_count == 0 ? SceneWords::tr("Body at %1").arg(time)
                                                   : SceneWords::tr("Body at %1, %2 of %3 pairs good")
                                                         .arg(time)
                                                         .arg(composed.goodPairs())
                                                         .arg(composed.pair_count);
    return withChosen(words, callout);
}

QString liveDescription(const ComposedScene& composed, const std::optional<SceneCallout>& callout) {
    return withChosen(
        SceneWords::tr("Live body, %1 of %2 pairs good").arg(composed.goodPairs()).arg(composed.pair_count),
        callout);
}

QString figureDescription(const FigureScene& figure) {
    const auto callout = figureCallout(figure);
    const int boards = static_cast<int>(figure.suit().boards.size());
    const int sources = static_cast<int>(figure.suit().sources.size());
    const QString words =
        SceneWords::tr("Performer in the rest pose with %1 boards and %2 sources").arg(boards).arg(sources);
    return withChosen(words, callout);
}

QString whyEmpty(const LiveScene& live) {
    if (!live.wearer().suit.boards.empty() && !live.wearer().calibration)
        return SceneWords::tr(
            "The live body needs a calibration. Boards and pairs are watched, and a take can be recorded and "
            "processed later.");
    return SceneWords::tr("The live body appears here with the suit's first pose.");
}

QString whyEmpty(ReviewContext& review) {
    TakeDocument& take = review.take();
    if (!take.isOpen())
        return SceneWords::tr("The body of the take that you open appears here.");
    if (take.shownRun() == -1 && take.processing())
        return SceneWords::tr("This take is being processed. The body appears here when that is done.");
    if (take.shownRun() == -1)
        return SceneWords::tr("This take has no motion yet. Process it, and the body appears here.");
    const TakeParty* party = take.overview()->partyOf(take.overview()->suit_in_view);
    if (party && party->lost_in_rest_s) {
        const LostWords words =
            lostInRest(QString::fromStdString(party->subject.name), *party->lost_in_rest_s);
        return words.what + QStringLiteral(". ") + words.consequence;
    }
    if (!take.shownMotion())
        return take.problem();
    return SceneWords::tr("The motion has no pose at this time.");
}

LostWords lostInRest(const QString& performer, double at_s) {
    return {SceneWords::tr("%1 was lost at %2, before the rest pose ended", "a performer, a time")
                .arg(performer, timeText(at_s, 0)),
            SceneWords::tr("There is no motion of them.", "a performer")};
}

QString distanceInWords(const ComposedScene::Distance& distance) {
    if (chosenUnits() == Units::kImperial) {
        const double sigma_m = distance.sigma_m.value_or(0);
        const QString words = lengthText(distance.distance_m);
        return sigma_m < kMetresPerInch / 20 ? words : words + QStringLiteral(" ±") + lengthText(sigma_m);
    }
    const bool near = distance.distance_m < 1;
    const QString words = near ? millimetresText(distance.distance_m, 0) : lengthText(distance.distance_m);
    const double sigma = distance.sigma_m.value_or(0) * (near ? 1000 : 1), least = near ? 0.5 : 0.005;
    return sigma < least ? words : words + QStringLiteral(" ±") + numberText(sigma, near ? 0 : 2);
}

QString pairOfDistance(const ComposedScene::Distance& distance) {
    return SceneWords::tr("%1 of %2 to %3 of %4", "joints of two performers")
        .arg(jointName(distance.joint, NameCase::kInside), performerLetter(distance.one),
             jointName(distance.other_joint, NameCase::kInside), performerLetter(distance.other));
}

}  // namespace noctule::ui
