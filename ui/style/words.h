// SPDX-License-Identifier: Apache-2.0
// Numbers, dates and keys as the studio writes them: a real minus (U+2212), thin spaces between groups of
// three (U+2009), a no-break space before a unit except degrees, the decimal sign of the locale in use. What
// is not finite reads as kNoValue.
#pragma once

#include <QDateTime>
#include <QKeySequence>
#include <QLocale>
#include <QString>

namespace noctule::ui {

/// Stands where there is no value.
inline const QString kNoValue(QChar(0x2013));

/// 17.4 s -> "0:17.4"; 3725 s with 0 decimals -> "1:02:05".
QString timeText(double seconds, int decimals = 1);
/// A time of the day with its seconds: "09:05:01".
QString clockText(const QTime& time);
/// 17.4 -> "17.4 s".
QString secondsText(double seconds, int decimals = 1);
/// Seconds in, "43 ms" out.
QString millisecondsText(double seconds);
/// Radians in, "24.1°" out.
QString degreesText(double radians, int decimals = 1);
/// Metres in, "1.8 mm" out: errors and places of parts. Lengths of people and rooms: lengths.h.
QString millimetresText(double metres, int decimals = 1);
/// 0.91 -> "91 %".
QString percentText(double fraction, int decimals = 0);
/// 3836 -> "3 836".
QString countText(qint64 count);
/// 2900000 -> "2.9 MB" (powers of ten, as file dialogs and disks count).
QString bytesText(qint64 bytes);
QString numberText(double value, int decimals);
/// Of a whole sentence: no line ends between a number and its degrees or percent, nor within "°/s".
QString unbroken(const QString& sentence);
/// Errors end with or without a full stop; followed by another sentence they need one.
QString withFullStop(const QString& sentence);
/// "Ctrl+R", on a German screen "Strg+R" as its keyboard has it. Every key in a text is written by this.
QString keysText(const QKeySequence& keys);
/// "Today, 10:12", "Yesterday", "17 November"; with the year when it is not the present one.
QString dateText(const QDateTime& when, const QDateTime& now = QDateTime::currentDateTime());
/// The same within a sentence: "since today, 10:12".
QString dateInside(const QDateTime& when, const QDateTime& now = QDateTime::currentDateTime());
/// How long ago: "just now", "40 min", "5 hours", "12 days".
QString ageText(const QDateTime& when, const QDateTime& now = QDateTime::currentDateTime());

}  // namespace noctule::ui
