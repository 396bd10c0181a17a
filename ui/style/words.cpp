// SPDX-License-Identifier: Apache-2.0
#include "ui/style/words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <cmath>

namespace noctule::ui {

namespace {

const QChar kMinus(0x2212);
const QChar kThinSpace(0x2009);
const QChar kNoBreakSpace(0x00A0);
constexpr double kDegreesPerRadian = 57.29577951308232;

/// Rounds first, so that −0.04 with one decimal is 0.0 and not −0.0.
QString fixed(double value, int decimals) {
    const double step = std::pow(10.0, -decimals);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = locale.toString(std::abs(value), 'f', decimals);
    const QString whole = text.section(locale.decimalPoint(), 0, 0);
    if (whole.size() > 3) {
        for (int i = whole.size() - 3; i > 0; i -= 3)
            text.insert(i, kThinSpace);
    }
    return std::abs(value) >= step / 2 && value < 0 ? kMinus + text : text;
}

QString withUnit(double value, int decimals, const QString& unit) {
    return std::isfinite(value) ? fixed(value, decimals) + kNoBreakSpace + unit : kNoValue;
}

}  // namespace

QString numberText(double value, int decimals) {
    return std::isfinite(value) ? fixed(value, decimals) : kNoValue;
}

QString unbroken(const QString& sentence) {
    static const QRegularExpression kBeforeUnit(QStringLiteral("(\\d) (?=[°%])"));
    return QString(sentence)
        .replace(kBeforeUnit, QStringLiteral("\\1\u00a0"))
        .replace(QStringLiteral("°/s"), QStringLiteral("°/\u2060s"));
}

QString withFullStop(const QString& sentence) {
    return sentence.endsWith('.') ? sentence : sentence + '.';
}

/// Qt calls one of the two keys "Return", which stands on few keyboards.
QString keysText(const QKeySequence& keys) {
    const QString text = keys.toString(QKeySequence::NativeText);
    const int key = keys.isEmpty() ? 0 : keys[0] & ~static_cast<int>(Qt::KeyboardModifierMask);
    if (key != Qt::Key_Return && key != Qt::Key_Enter)
        return text;
    return text.chopped(QKeySequence(key).toString(QKeySequence::NativeText).size()) +
           QCoreApplication::translate("noctule::ui::words", "Enter", "a key");
}

QString timeText(double seconds, int decimals) {
    if (!std::isfinite(seconds))
        return kNoValue;
    const double unit = std::pow(10.0, decimals);
    const auto ticks = static_cast<qint64>(std::llround(std::abs(seconds) * unit));
    const auto per_second = static_cast<qint64>(unit);
    const qint64 whole_s = ticks / per_second;
    const qint64 hours = whole_s / 3600;
    const qint64 minutes = whole_s / 60 % 60;
    QString text =
        hours > 0 ? QString("%1:%2").arg(hours).arg(minutes, 2, 10, QChar('0')) : QString::number(minutes);
    text += QString(":%1").arg(whole_s % 60, 2, 10, QChar('0'));
    if (decimals > 0)
        text += QLocale().decimalPoint() + QString("%1").arg(ticks % per_second, decimals, 10, QChar('0'));
    return seconds < 0 && ticks > 0 ? kMinus + text : text;
}

QString clockText(const QTime& time) {
    return time.toString(QStringLiteral("HH:mm:ss"));
}

QString secondsText(double seconds, int decimals) {
    return withUnit(seconds, decimals, "s");
}

QString millisecondsText(double seconds) {
    return withUnit(seconds * 1e3, 0, "ms");
}

QString degreesText(double radians, int decimals) {
    return std::isfinite(radians) ? fixed(radians * kDegreesPerRadian, decimals) + QChar(0x00B0) : kNoValue;
}

QString millimetresText(double metres, int decimals) {
    return withUnit(metres * 1e3, decimals, "mm");
}

QString percentText(double fraction, int decimals) {
    return withUnit(fraction * 100, decimals, "%");
}

QString countText(qint64 count) {
    QString digits = QString::number(std::abs(count));
    for (int i = digits.size() - 3; i > 0; i -= 3)
        digits.insert(i, kThinSpace);
    return count < 0 ? kMinus + digits : digits;
}

QString bytesText(qint64 bytes) {
    static const char* const units[] = {"B", "kB", "MB", "GB", "TB", "PB"};
    double value = static_cast<double>(bytes);
    int unit = 0;
    while (std::abs(value) >= 999.5 && unit < 5) {
        value /= 1000;
        ++unit;
    }
    return withUnit(value, unit > 0 && std::abs(value) < 9.95 ? 1 : 0, units[unit]);
}

namespace {

struct AgeText {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::words)
};

QString dateWords(const QDateTime& when, const QDateTime& now, const QString& today_words,
                  const QString& yesterday) {
    if (!when.isValid())
        return kNoValue;
    const QDate day = when.toLocalTime().date();
    const QDate today = now.toLocalTime().date();
    const QLocale locale;
    if (day == today)
        return today_words.arg(when.toLocalTime().time().toString("HH:mm"));
    if (day == today.addDays(-1))
        return yesterday;
    const bool this_year = day.year() == today.year();
    return locale.toString(
        day, this_year
                 ? QCoreApplication::translate("noctule::ui::words", "d MMMM", "day and month")
                 : QCoreApplication::translate("noctule::ui::words", "d MMMM yyyy", "day, month and year"));
}

}  // namespace

QString dateText(const QDateTime& when, const QDateTime& now) {
    return dateWords(when, now, QCoreApplication::translate("noctule::ui::words", "Today, %1"),
                     QCoreApplication::translate("noctule::ui::words", "Yesterday"));
}

QString dateInside(const QDateTime& when, const QDateTime& now) {
    return dateWords(when, now,
                     QCoreApplication::translate("noctule::ui::words", "today, %1", "within a sentence"),
                     QCoreApplication::translate("noctule::ui::words", "yesterday", "within a sentence"));
}

QString ageText(const QDateTime& when, const QDateTime& now) {
    if (!when.isValid())
        return kNoValue;
    const qint64 minutes = when.secsTo(now) / 60;
    constexpr qint64 kHour = 60, kDay = 24 * kHour;
    if (minutes < 2)
        return AgeText::tr("just now", "an age");
    if (minutes < 2 * kHour)
        return AgeText::tr("%1 min", "an age").arg(minutes);
    if (minutes < 2 * kDay)
        return AgeText::tr("%n hour(s)", "an age", static_cast<int>(minutes / kHour));
    return AgeText::tr("%n day(s)", "an age", static_cast<int>(minutes / kDay));
}

}  // namespace noctule::ui
