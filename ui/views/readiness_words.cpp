// SPDX-License-Identifier: Apache-2.0
#include "ui/views/readiness_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/inertial/reading.h"
#include "ui/language/core_words.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/fit_words.h"

namespace noctule::ui {
namespace {

struct ReadinessText {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ReadinessWords)
};

HindranceWords aboutLink(const ReadinessProblem& problem, const SuitCheck& check) {
    if (problem.kind == ProblemKind::kNoSound)
        return {ReadinessText::tr("No sound arrives"),
                ReadinessText::tr("The driver box is there and sends nothing. Wait a moment; if it stays so, "
                                  "switch it off and on again.")};
    return {
        ReadinessText::tr("The link is broken"),
        ReadinessText::tr("The driver box has not answered since %1. The studio tries again by itself; check "
                          "the cable or the network.")
            .arg(clockText(check.lostSince()))};
}

QString silentText(const Board& board, int number, const QTime& since) {
    const QString remedy =
        ReadinessText::tr("Push its plug in until it clicks; if the light stays dark, change the cable.");
    const QString what = since.isValid() ? ReadinessText::tr("Board %1, %2, fell silent at %3.")
                                               .arg(number)
                                               .arg(boardName(board, NameCase::kInside), clockText(since))
                                         : ReadinessText::tr("Nothing has come from board %1, %2, so far.")
                                               .arg(number)
                                               .arg(boardName(board, NameCase::kInside));
    return what + ' ' + remedy;
}

HindranceWords aboutBoard(const ReadinessProblem& problem, const SuitCheck& check) {
    const Suit& suit = check.suit().suit();
    const Board& board = suit.boards[static_cast<size_t>(problem.board)];
    const int number = problem.board + 1;
    const QString name = boardName(board);
    HindranceWords words;
    if (check.suit().isPlugged(problem.board)) {
        const bool blinks = check.suit().blinkingBoard() == problem.board;
        words.action = blinks ? ReadinessText::tr("Board %1 blinks").arg(number)
                              : ReadinessText::tr("Blink board %1").arg(number);
        words.action_icon = "blink";
        words.repair = Repair::kBlinkBoard;
    }
    words.accept = ReadinessText::tr("Go on without it");
    switch (problem.kind) {
        case ProblemKind::kBoardSilent:
            words.title = ReadinessText::tr("%1 sends nothing").arg(name);
            words.text = silentText(board, number, check.silentSince(problem.board));
            break;
        case ProblemKind::kBoardUnreadable:
            words.title = ReadinessText::tr("%1 cannot be understood").arg(name);
            words.text = ReadinessText::tr(
                             "Board %1 sends something, but hardly a whole frame. Check its plug and "
                             "its cable; if that does not help, change the board.")
                             .arg(number);
            break;
        case ProblemKind::kBoardLosesFrames:
            words.title = ReadinessText::tr("%1 loses frames").arg(name);
            words.text =
                ReadinessText::tr("Board %1 brings %2 of %3 frames a second. Check its plug and its cable.")
                    .arg(number)
                    .arg(numberText(problem.value, 0))
                    .arg(kInertialFramesPerSecond);
            words.accept = ReadinessText::tr("Ignore");
            break;
        case ProblemKind::kBoardClips:
            words.title = ReadinessText::tr("%1 reaches its limits").arg(name);
            words.text = ReadinessText::tr(
                             "Board %1 was overdriven %2 times in the last second. Fasten it so that "
                             "it cannot knock against anything.")
                             .arg(number)
                             .arg(numberText(problem.value, 0));
            words.accept = ReadinessText::tr("Ignore");
            break;
        default:
            words.title = ReadinessText::tr("%1 hears no source").arg(name);
            words.text = ReadinessText::tr(
                             "Board %1 has heard no pulse for ten seconds. Check whether a strap or a "
                             "fold covers its microphone.")
                             .arg(number);
            words.accept = ReadinessText::tr("Ignore");
    }
    return words;
}

HindranceWords aboutSource(const ReadinessProblem& problem, const SuitCheck& check) {
    const Suit& suit = check.suit().suit();
    const Source& source = suit.sources[static_cast<size_t>(problem.source)];
    const int number = problem.source + 1;
    const bool silent = problem.kind == ProblemKind::kSourceSilent;
    HindranceWords words;
    words.title =
        (silent ? ReadinessText::tr("Source %1 is not heard") : ReadinessText::tr("Source %1 is faint"))
            .arg(number);
    words.text =
        silent ? ReadinessText::tr("%1: no board hears it. Check its plug; a strap or fold may cover it.",
                                   "place of a source")
                     .arg(sourcePlace(source))
               : ReadinessText::tr(
                     "%1: only %2 of its %3 pairs are good. A strap or fold probably covers "
                     "it.",
                     "place of a source")
                     .arg(sourcePlace(source), numberText(problem.value, 0))
                     .arg(suit.boards.size());
    words.action = ReadinessText::tr("Play source %1").arg(number);
    words.action_icon = "sound";
    words.repair = Repair::kPlaySource;
    words.accept = ReadinessText::tr("Ignore");
    return words;
}

HindranceWords aboutSupplies(const ReadinessProblem& problem, const SuitCheck& check) {
    const QString charge = percentText(problem.value / 100);
    switch (problem.kind) {
        case ProblemKind::kBatteryEmpty:
            return {
                ReadinessText::tr("The battery is almost empty"),
                ReadinessText::tr("%1 is left; the driver box switches off within a minute. Charge it now.")
                    .arg(charge)};
        case ProblemKind::kBatteryLow:
            return {ReadinessText::tr("The battery is low"),
                    batteryLeft(problem.value, check.batteryLeft_s())};
        case ProblemKind::kStorageShort:
            return {ReadinessText::tr("The disk is almost full"),
                    ReadinessText::tr(
                        "There is room for %1 of recording. Free some space, or choose another folder "
                        "for the session.")
                        .arg(durationWords(problem.value))};
        default:
            return {
                ReadinessText::tr("It is not known which board sits where"),
                ReadinessText::tr("The driver box does not tell; the boards are shown in the order of their "
                                  "plugs. Find each by moving, or drag it onto its body part.")};
    }
}

/// Of several boards or sources at once: the cause is common to them.
HindranceWords aboutMany(const ReadinessProblem& problem, const SuitCheck& check) {
    const int count = static_cast<int>(problem.alike.size());
    const Suit& suit = check.suit().suit();
    const bool of_sources =
        problem.kind == ProblemKind::kSourceSilent || problem.kind == ProblemKind::kSourceFaint;
    const bool all = problem.alike.size() == (of_sources ? suit.sources.size() : suit.boards.size());
    switch (problem.kind) {
        case ProblemKind::kBoardSilent:
            return {all ? ReadinessText::tr("No board sends anything")
                        : ReadinessText::tr("%n boards send nothing", nullptr, count),
                    ReadinessText::tr("So many at once have one cause: the driver box or the cable that they "
                                      "share. Check its plug, then switch the box off and on again."),
                    {},
                    {},
                    ReadinessText::tr("Go on without them")};
        case ProblemKind::kBoardUnreadable:
            return {
                ReadinessText::tr("%n boards cannot be understood", nullptr, count),
                ReadinessText::tr("They send something, but hardly a whole frame. So many at once have one "
                                  "cause: the link or the driver box. Switch the box off and on again."),
                {},
                {},
                ReadinessText::tr("Go on without them")};
        case ProblemKind::kBoardLosesFrames:
            return {
                ReadinessText::tr("The stream loses frames"),
                ReadinessText::tr("%n boards bring about %1 of %2 frames a second, all alike: the link or "
                                  "this computer is too slow. Use a cable or a nearer access point, and "
                                  "close other programs.",
                                  nullptr, count)
                    .arg(numberText(problem.value, 0))
                    .arg(kInertialFramesPerSecond),
                {},
                {},
                ReadinessText::tr("Ignore")};
        case ProblemKind::kBoardClips:
            return {
                ReadinessText::tr("%n boards reach their limits", nullptr, count),
                ReadinessText::tr("They were overdriven about %1 times each in the last second. Loud noise "
                                  "near the suit or blows do that; look whether the boards are fastened.")
                    .arg(numberText(problem.value, 0)),
                {},
                {},
                ReadinessText::tr("Ignore")};
        case ProblemKind::kBoardDeaf:
            return {all ? ReadinessText::tr("No board hears any source")
                        : ReadinessText::tr("%n boards hear no source", nullptr, count),
                    ReadinessText::tr("So many at once have one cause: the sources. Check whether they are "
                                      "plugged in and switched on."),
                    {},
                    {},
                    ReadinessText::tr("Ignore")};
        default:
            return {
                all ? ReadinessText::tr("No source is heard")
                    : ReadinessText::tr("%n sources are not heard", nullptr, count),
                ReadinessText::tr("So many at once have one cause: the plug or the cable of the sources at "
                                  "the driver box. Push it in until it clicks."),
                {},
                {},
                ReadinessText::tr("Go on without them")};
    }
}

bool isOfFit(ProblemKind kind) {
    return kind == ProblemKind::kNotCalibrated || kind == ProblemKind::kStepNotUsable ||
           kind == ProblemKind::kMoved || kind == ProblemKind::kRestPoseOld ||
           kind == ProblemKind::kNotChecked || kind == ProblemKind::kStepOld;
}

/// What stands beside the verdict; the fit has a sentence of its own.
QString countWords(const Readiness& readiness) {
    int to_fix = 0, to_know = 0;
    for (const ReadinessProblem& problem : readiness.problems)
        if (!problem.accepted && !isOfFit(problem.kind))
            ++(problem.hinders ? to_fix : to_know);
    QStringList words;
    if (to_fix > 0)
        words << (to_fix == 1 ? ReadinessText::tr("One thing to fix.")
                              : ReadinessText::tr("%n things to fix.", nullptr, to_fix));
    if (to_know > 0)
        words << (to_know == 1 ? ReadinessText::tr("One thing to know.")
                               : ReadinessText::tr("%n things to know.", nullptr, to_know));
    return words.join(' ');
}

QString whatIsHere(const Readiness& readiness) {
    const auto boards = readiness.boards.size(), sources = readiness.source_good_pairs.size();
    const bool all = readiness.boards_there == static_cast<int>(boards) &&
                     readiness.sources_heard == static_cast<int>(sources);
    return all ? ReadinessText::tr("All %1 boards and %2 sources are here.").arg(boards).arg(sources)
               : ReadinessText::tr("%1 of %2 boards and %3 of %4 sources are here.")
                     .arg(readiness.boards_there)
                     .arg(boards)
                     .arg(readiness.sources_heard)
                     .arg(sources);
}

}  // namespace

HindranceWords wordsOf(const ReadinessProblem& problem, const SuitCheck& check) {
    if (problem.kind == ProblemKind::kLinkLost || problem.kind == ProblemKind::kNoSound)
        return aboutLink(problem, check);
    if (!problem.alike.empty())
        return aboutMany(problem, check);
    if (isOfFit(problem.kind))
        return fitHindrance(problem, check);
    if (problem.board >= 0)
        return aboutBoard(problem, check);
    return problem.source >= 0 ? aboutSource(problem, check) : aboutSupplies(problem, check);
}

VerdictWords verdictOf(const SuitCheck& check) {
    const LiveSuit& suit = check.suit();
    const Readiness& readiness = check.readiness();
    if (suit.phase() == LiveSuit::Phase::kNone)
        return {Tone::kNeutral, ReadinessText::tr("No suit is connected"),
                ReadinessText::tr("Choose a driver box, or start the virtual suit.")};
    if (suit.phase() == LiveSuit::Phase::kRefused) {
        const auto trouble = suit.status()->trouble;
        return {Tone::kError, ReadinessText::tr("Not connected"),
                trouble ? coreWords(trouble->text() + ".") : QString()};
    }
    if (readiness.verdict == Readiness::Verdict::kWaiting)
        return {Tone::kNeutral, ReadinessText::tr("Looking at the suit"),
                ReadinessText::tr("In a moment it is clear what arrives.")};
    const QString counts = countWords(readiness);
    if (readiness.verdict == Readiness::Verdict::kNotReady)
        return {Tone::kError, ReadinessText::tr("Not ready yet"), counts};
    const QString fit = fitSentence(readiness);
    QStringList sentences{fit, whatIsHere(readiness), counts};
    sentences.removeAll(QString());
    return {fit.isEmpty() && counts.isEmpty() ? Tone::kOk : Tone::kWarn,
            readiness.isFit() ? ReadinessText::tr("Ready") : ReadinessText::tr("Connected"),
            sentences.join(' ')};
}

VerdictWords recordingVerdictOf(const Readiness& readiness) {
    const bool beside_fit = std::ranges::any_of(readiness.problems, [](const ReadinessProblem& problem) {
        return !problem.accepted && !isOfFit(problem.kind);
    });
    const Tone tone = readiness.verdict == Readiness::Verdict::kNotReady ? Tone::kError
                      : beside_fit || !fitSentence(readiness).isEmpty()  ? Tone::kWarn
                                                                         : Tone::kOk;
    return {tone,
            readiness.isFit() && beside_fit ? ReadinessText::tr("Recording, with problems")
                                            : recordingWords(readiness),
            {}};
}

const SuitInUse& worstOf(const LiveSuits& suits) {
    constexpr Tone kByHarm[] = {Tone::kOk, Tone::kAccent, Tone::kNeutral, Tone::kWarn, Tone::kError};
    const auto harm = [&](const SuitInUse* worn) {
        return std::ranges::find(kByHarm, verdictOf(worn->check).tone) - kByHarm;
    };
    const SuitInUse* worst = &suits.current();
    if (suits.areSeveral())
        for (const SuitInUse* worn : suits.connected())
            if (harm(worn) > harm(worst))
                worst = worn;
    return *worst;
}

VerdictWords verdictOf(const LiveSuits& suits) {
    const SuitInUse& worst = worstOf(suits);
    VerdictWords words = verdictOf(worst.check);
    if (&worst != &suits.current()) {
        const QString name = suits.nameOf(worst);
        words.text = words.text.isEmpty()
                         ? name
                         : ReadinessText::tr("%1: %2", "a performer, sentences").arg(name, words.text);
    }
    return words;
}

Tone toneOf(BoardReadiness::State state) {
    switch (state) {
        case BoardReadiness::State::kFine:
            return Tone::kOk;
        case BoardReadiness::State::kPoor:
            return Tone::kWarn;
        case BoardReadiness::State::kSilent:
            return Tone::kError;
        case BoardReadiness::State::kUnknown:
            break;
    }
    return Tone::kNeutral;
}

QString boardDetail(const SuitCheck& check, int board) {
    const auto& boards = check.readiness().boards;
    const auto index = static_cast<size_t>(board);
    if (board < 0 || index >= boards.size() || boards[index].state == BoardReadiness::State::kUnknown)
        return ReadinessText::tr("board %1").arg(board + 1);
    if (check.suit().blinkingBoard() == board)
        return ReadinessText::tr("its light blinks");
    if (boards[index].state == BoardReadiness::State::kSilent) {
        const QTime since = check.silentSince(board);
        return since.isValid() ? ReadinessText::tr("no signal since %1").arg(clockText(since))
                               : ReadinessText::tr("no signal");
    }
    return ReadinessText::tr("%1 of %2 pairs", "that are good")
        .arg(boards[index].good_pairs)
        .arg(check.readiness().source_good_pairs.size());
}

QString linkBrokenInShort() {
    return ReadinessText::tr("Link broken");
}

QString lastKnownInShort() {
    return ReadinessText::tr("last known");
}

Tone toneOfStorage(double left_s) {
    const ReadinessLimits limits;
    return left_s < limits.storage_empty_s   ? Tone::kError
           : left_s < limits.storage_short_s ? Tone::kWarn
                                             : Tone::kOk;
}

QString batteryLeft(double percent, std::optional<double> left_s) {
    const QString charge = percentText(percent / 100);
    return left_s ? ReadinessText::tr("%1 is left, about %2. Charge it before a long take.")
                        .arg(charge, durationWords(*left_s))
                  : ReadinessText::tr("%1 is left. Charge it before a long take.").arg(charge);
}

QString durationWords(double seconds) {
    const auto minutes = static_cast<int>(seconds / 60);
    if (seconds < 100)
        return secondsText(std::floor(seconds), 0);
    if (minutes < 60)
        return ReadinessText::tr("%1 min").arg(minutes);
    if (minutes >= 600)
        return ReadinessText::tr("%1 h").arg(minutes / 60);
    return ReadinessText::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

}  // namespace noctule::ui
