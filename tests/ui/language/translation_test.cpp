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
#include <QXmlStreamReader>
#include <map>

namespace noctule::ui {
namespace {

const QString kSources = NOCTULE_SOURCE_DIR;
const QString kTranslations = kSources + "/resources/translations/";

struct Message {
    QString context, source, comment;
    QStringList forms;  ///< one, or two of a plural
    bool plural = false, finished = true;

    QString key() const { return context + '|' + source + '|' + comment; }
};

Message readMessage(QXmlStreamReader& xml, const QString& context) {
    Message message;
    message.context = context;
    message.plural = xml.attributes().value("numerus") == "yes";
    while (xml.readNextStartElement()) {
        if (xml.name() == "source") {
            message.source = xml.readElementText();
        } else if (xml.name() == "comment") {
            message.comment = xml.readElementText();
        } else if (xml.name() == "translation") {
            message.finished = !xml.attributes().hasAttribute("type");
            if (!message.plural)
                message.forms.append(xml.readElementText());
            else
                while (xml.readNextStartElement())
                    message.forms.append(xml.readElementText());
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

std::vector<Message> readTs(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == "name")
            context = xml.readElementText();
        else if (xml.name() == "message")
            messages.push_back(readMessage(xml, context));
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return messages;
}

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
        const std::vector<Message> messages = readTs(kTranslations + file);
        ASSERT_GT(messages.size(), 500U);
        for (const Message& message : messages) {
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
    ASSERT_TRUE(check.waitForFinished());
    EXPECT_EQ(check.exitCode(), 0) << check.readAll().toStdString()
                                   << "Run packaging/translations.sh, then translate.";
}

TEST(Translation, EnglishHasItsPluralForms) {
    for (const Message& message : readTs(kTranslations + "noctule_en.ts")) {
        EXPECT_TRUE(message.plural && message.finished) << message.key().toStdString();
        for (const QString& form : message.forms)
            expectSamePlaceholders(message, form);
    }
}

TEST(Translation, CalmWords) {
    for (const Message& message : readTs(kTranslations + "noctule_de.ts"))
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
        ASSERT_TRUE(QFile::copy(kTranslations + name, fresh));
        QProcess update;
        update.setWorkingDirectory(kSources);
        QStringList arguments{"ui",    "app",        "-I",   ".",           "-extensions",
                              "cpp,h", "-locations", "none", "-no-obsolete"};
        if (QLatin1String(language) == "en")
            arguments.append("-pluralonly");
        update.start(program, arguments + QStringList{"-ts", fresh});
        ASSERT_TRUE(update.waitForFinished());
        std::map<QString, bool> known;
        for (const Message& message : readTs(kTranslations + name))
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
