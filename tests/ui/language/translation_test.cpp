// SPDX-License-Identifier: Apache-2.0
// German is complete: every sentence of the sources stands in noctule_de.ts, finished, with the same
// placeholders; English has its plural forms.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <map>
#include <set>

#include "tests/ui/language/translation_file.h"

namespace noctule::ui {
namespace {

const QString kSources = NOCTULE_SOURCE_DIR;

QStringList placeholders(const QString& text) {
    static const QRegularExpression pattern("%(L?\\d+|n)");
    QStringList found;
    for (auto match = pattern.globalMatch(text); match.hasNext();)
        found.append(match.next().captured());
    found.sort();
    found.removeDuplicates();
    return found;
}

/// A form of a plural may spell its number out: "One job".
void expectSamePlaceholders(const Message& message, const QString& form) {
    QStringList wanted = placeholders(message.source), given = placeholders(form);
    if (message.plural) {
        wanted.removeAll("%n");
        given.removeAll("%n");
    }
    EXPECT_EQ(wanted, given) << message.key().toStdString() << " -> " << form.toStdString();
}

TEST(Translation, GermanIsFinishedAndKeepsPlaceholders) {
    for (const char* file : {"noctule_de.ts", "core_de.ts"}) {
        const std::vector<Message> messages = readTs(translationPath(file));
        ASSERT_GT(messages.size(), 500U);
        std::set<QString> keys;
        for (const Message& message : messages) {
            EXPECT_TRUE(keys.insert(message.key()).second) << "twice: " << message.key().toStdString();
            EXPECT_TRUE(message.finished) << message.key().toStdString();
            EXPECT_EQ(message.forms.size(), message.plural ? 2 : 1) << message.key().toStdString();
            for (const QString& form : message.forms) {
                EXPECT_FALSE(form.isEmpty()) << message.key().toStdString();
                expectSamePlaceholders(message, form);
            }
        }
    }
}

TEST(Translation, NoSentenceOfCoreIsMissing) {
    QProcess check;
    check.setWorkingDirectory(kSources);
    check.start("python3", {"-B", "packaging/core_sentences.py", "--check"});
    ASSERT_TRUE(check.waitForFinished(-1));
    EXPECT_EQ(check.exitCode(), 0) << check.readAll().toStdString()
                                   << "Run packaging/translations.sh, then translate.";
}

TEST(Translation, EnglishHasItsPluralForms) {
    for (const Message& message : readTs(translationPath("noctule_en.ts"))) {
        EXPECT_TRUE(message.plural && message.finished) << message.key().toStdString();
        for (const QString& form : message.forms)
            expectSamePlaceholders(message, form);
    }
}

TEST(Translation, CalmWords) {
    for (const Message& message : readTs(translationPath("noctule_de.ts")))
        for (const QString& form : message.forms) {
            EXPECT_FALSE(form.contains('!')) << form.toStdString();
            EXPECT_FALSE(form.contains("erfolgreich", Qt::CaseInsensitive)) << form.toStdString();
            EXPECT_FALSE(form.contains("bitte", Qt::CaseInsensitive)) << form.toStdString();
            EXPECT_FALSE(message.source.contains('!')) << message.source.toStdString();
            EXPECT_FALSE(message.source.contains("successfully", Qt::CaseInsensitive))
                << message.source.toStdString();
        }
}

TEST(Translation, NoSentenceOfTheSourcesIsMissing) {
    const QString program = QLibraryInfo::location(QLibraryInfo::BinariesPath) + "/lupdate";
    if (!QFile::exists(program))
        GTEST_SKIP() << program.toStdString() << " is not there";
    const QTemporaryDir folder;
    for (const char* language : {"de", "en"}) {
        const QString name = QStringLiteral("noctule_%1.ts").arg(language), fresh = folder.filePath(name);
        ASSERT_TRUE(QFile::copy(translationPath(name), fresh));
        QProcess update;
        update.setWorkingDirectory(kSources);
        QStringList arguments{"ui",    "app",        "-I",   ".",           "-extensions",
                              "cpp,h", "-locations", "none", "-no-obsolete"};
        if (QLatin1String(language) == "en")
            arguments.append("-pluralonly");
        update.start(program, arguments + QStringList{"-ts", fresh});
        ASSERT_TRUE(update.waitForFinished(-1));
        std::map<QString, bool> known;
        for (const Message& message : readTs(translationPath(name)))
            known[message.key()] = false;
        for (const Message& message : readTs(fresh)) {
            EXPECT_TRUE(known.count(message.key())) << language << ", new: " << message.key().toStdString();
            known[message.key()] = true;
        }
        for (const auto& [key, still_used] : known)
            EXPECT_TRUE(still_used) << language << ", no longer used: " << key.toStdString();
    }
}

}  // namespace
}  // namespace noctule::ui
