// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/take_notes.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ui/language/core_words.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

struct NoteText {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::TakeNotes)
};

struct NoteLine {
    double t_s = 0;
    QString text;
};

constexpr double kWithoutTime_s = 1e12;
/// The box tells of a board about once a second.
constexpr double kBoxDelay_s = 1.5;

QString boardAtPlace(const Suit& suit, int board) {
    return NoteText::tr("%1 (board %2)", "body part, number")
        .arg(boardName(suit.boards[static_cast<size_t>(board)], NameCase::kInside))
        .arg(board + 1);
}

NoteLine lineOf(const BoardSilence& silence, const Suit& suit) {
    const QString from = timeText(silence.from_s), board = boardAtPlace(suit, silence.board);
    return {silence.from_s, silence.back_s
                                ? NoteText::tr("%1 %2 fell silent; back at %3", "time, board, time")
                                      .arg(from, board, timeText(*silence.back_s))
                                : NoteText::tr("%1 %2 fell silent", "time, board").arg(from, board)};
}

bool isTold(double t_s, const TakeOverview& take) {
    const auto near = [t_s](double at_s) { return std::abs(t_s - at_s) < kBoxDelay_s; };
    return std::ranges::any_of(take.silences, [&](const BoardSilence& silence) {
        return near(silence.from_s) || (silence.back_s && near(*silence.back_s));
    });
}

/// What the box says of a board is left out where the board's silence is known to the sample.
std::optional<NoteLine> lineOf(const NoteRow& note, const TakeOverview& take) {
    static const QRegularExpression kOfBox("^(\\d+):(\\d\\d[.,]\\d) Driver box: (.*)$");
    static const QRegularExpression kOfBoxBefore("^Driver box, at sample (-?\\d+): (.*)$");
    static const QRegularExpression kTimed("^(\\d+):(\\d\\d[.,]\\d) ");
    const QString text = QString::fromStdString(note.text);
    const auto timeOf = [](const QRegularExpressionMatch& match) {
        return 60 * match.captured(1).toDouble() + match.captured(2).replace(',', '.').toDouble();
    };
    NoteLine line{kWithoutTime_s, text};
    QString said;
    if (const auto box = kOfBox.match(text); box.hasMatch()) {
        line.t_s = timeOf(box);
        said = box.captured(3);
    } else if (const auto before = kOfBoxBefore.match(text); before.hasMatch()) {
        line.t_s = before.captured(1).toDouble() / std::max(1.0, take.sample_rate_hz);
        said = before.captured(2).section(": ", -1);
    } else if (const auto timed = kTimed.match(text); timed.hasMatch()) {
        line.t_s = timeOf(timed);
    }
    if (said.isEmpty())
        return line;
    if (isTold(line.t_s, take))
        return std::nullopt;
    line.text = NoteText::tr("%1 driver box: %2", "time, what it says")
                    .arg(timeText(line.t_s), coreWords(said.toStdString()));
    return line;
}

}  // namespace

QStringList takeNoteLines(const TakeOverview& take) {
    std::vector<NoteLine> lines;
    for (const BoardSilence& silence : take.silences)
        if (static_cast<size_t>(silence.board) < take.suit.boards.size())
            lines.push_back(lineOf(silence, take.suit));
    for (const NoteRow& note : take.notes)
        if (auto line = lineOf(note, take))
            lines.push_back(std::move(*line));
    std::ranges::stable_sort(lines, {}, &NoteLine::t_s);
    QStringList texts;
    for (const NoteLine& line : lines)
        texts << line.text;
    return texts;
}

}  // namespace noctule::ui
