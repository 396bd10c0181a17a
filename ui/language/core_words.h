// SPDX-License-Identifier: Apache-2.0
// Core speaks English and knows no screen. Here its sentences are shown in the language of the studio: a
// sentence is matched with the pattern it was made from ("%1: is no take"), whose translation takes the
// values over. What no pattern fits is shown as it is. packaging/core_sentences.py collects the patterns.
// Safe from every thread.
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule::ui {

class SentencePatterns {
public:
    /// Values stand as %1, %2 ... in ascending order in `english`, in any order in `translated`.
    void add(const QString& english, const QString& translated);
    bool isEmpty() const { return whole_.isEmpty() && patterns_.empty(); }

    /// A sentence, several of them, or one within another ("walk.bvh: " + why).
    QString translated(const QString& english) const;

private:
    struct Pattern {
        QStringList literals;  ///< before, between and behind the values
        QString translated;
        int letters = 0;  ///< of the literals
    };
    struct Found {
        QString words;
        int letters = 0;  ///< how many of the English ones were understood
    };
    Found find(const QString& english, int depth) const;
    Found findAsWritten(const QString& english, int depth) const;  ///< upper and lower case count
    Found byPattern(const QString& english, int depth) const;
    Found bySplitting(const QString& english, int depth) const;
    /// "Left hand (83 %), chest and head": names alone, each of them known.
    Found asList(const QString& english, int depth) const;

    QHash<QString, QString> whole_;
    std::vector<Pattern> patterns_;  ///< the most telling ones first
};

/// Without what is meant for the command line alone: "(--rate HZ)", "Run `noctule --batch inspect` on it".
QString coreWords(const std::string& english);
/// What happened and what to do about it.
QString coreWords(const Error& error);
/// The texts between the tags and the accessible names of a document, such as a report of core.
std::string coreMarkup(const std::string& html);

}  // namespace noctule::ui
