// SPDX-License-Identifier: Apache-2.0
// Sentences of core on a German screen: patterns take values over, nest and follow each other; errors that
// core really makes are understood whole.
#include "ui/language/core_words.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>

#include "core/recording/losses.h"
#include "core/report/html_report.h"
#include "tests/core/report/made_report.h"

namespace noctule::ui {
namespace {

class CoreWords : public testing::Test {
protected:
    CoreWords() { QLocale::setDefault(QLocale(QLocale::German)); }
    ~CoreWords() override { QLocale::setDefault(QLocale(QLocale::English)); }

    SentencePatterns patterns_;
};

TEST_F(CoreWords, ASentenceTakesItsValuesOver) {
    patterns_.add("%1: row %2 has %3 cells", "%1: Zeile %2 hat %3 Zellen");
    EXPECT_EQ(patterns_.translated("a.csv: row 7 has 3 cells"), "a.csv: Zeile 7 hat 3 Zellen");
}

TEST_F(CoreWords, ValuesMayChangeTheirOrderAndHoldPlaceholders) {
    patterns_.add("%1 lacks %2", "%2 fehlt in %1");
    EXPECT_EQ(patterns_.translated("%2 lacks %1"), "%1 fehlt in %2");
}

TEST_F(CoreWords, TheMostTellingPatternWins) {
    patterns_.add("%1 is bad", "%1 ist schlecht");
    patterns_.add("the clock of %1 is bad", "die Uhr von %1 ist schlecht");
    EXPECT_EQ(patterns_.translated("the clock of box 2 is bad"), "die Uhr von box 2 ist schlecht");
}

TEST_F(CoreWords, SentencesNestAndFollowEachOther) {
    patterns_.add("%1: no run has poses", "%1: kein Lauf hat Posen");
    patterns_.add("cannot be compared (%1)", "ist nicht zu vergleichen (%1)");
    patterns_.add("it is empty", "sie ist leer");
    patterns_.add("Process it first", "Erst verarbeiten");
    EXPECT_EQ(patterns_.translated("walk: no run has poses. Process it first"),
              "walk: kein Lauf hat Posen. Erst verarbeiten");
    EXPECT_EQ(patterns_.translated("a.bvh: cannot be compared (it is empty)."),
              "a.bvh: ist nicht zu vergleichen (sie ist leer).");
}

TEST_F(CoreWords, FullStopsBelongToTheSentenceOrFollowIt) {
    patterns_.add("%1. Mean error %2 against %3.", "%1. Mittlerer Fehler %2 gegen %3.");
    patterns_.add("Good", "Gut");
    patterns_.add("it is empty", "sie ist leer");
    EXPECT_EQ(patterns_.translated("Good. Mean error 3.5 against a reference."),
              "Gut. Mittlerer Fehler 3,5 gegen a reference.");
    EXPECT_EQ(patterns_.translated("it is empty."), "sie ist leer.");
}

TEST_F(CoreWords, AFullStopOfAPatternMayStandInTheMiddle) {
    patterns_.add("Run %1: root %2.", "Lauf %1: Wurzel %2.");
    patterns_.add("Compared over %1.", "Verglichen über %1.");
    patterns_.add("free", "frei");
    EXPECT_EQ(patterns_.translated("Run A: root free. Compared over 20 s."),
              "Lauf A: Wurzel frei. Verglichen über 20 s.");
}

TEST_F(CoreWords, WhatIsNotKnownStaysAsItIs) {
    patterns_.add("%1 is bad", "%1 ist schlecht");
    EXPECT_EQ(patterns_.translated("/tmp/Is this good.bvh"), "/tmp/Is this good.bvh");
    EXPECT_EQ(patterns_.translated(" is bad"), " is bad");
    EXPECT_EQ(patterns_.translated(""), "");
}

TEST_F(CoreWords, ValuesHaveTheDecimalSignOfTheScreen) {
    patterns_.add("lasts %1 s, version %2", "dauert %1 s, Fassung %2");
    EXPECT_EQ(patterns_.translated("lasts 3.25 s, version 1.2.3"), "dauert 3,25 s, Fassung 1.2.3");
}

TEST_F(CoreWords, NumbersInsideOfAValueHaveThatSignToo) {
    const std::pair<const char*, const char*> texts[] = {{"4.5 sigma", "4,5 sigma"},
                                                         {"1.0 2.0 −3.1", "1,0 2,0 −3,1"},
                                                         {"2026-11-18, 0.9 mm", "2026-11-18, 0,9\u00a0mm"},
                                                         {"0.9 mm (4.5 sigma)", "0,9\u00a0mm (4,5 sigma)"},
                                                         {"0.31 ± 0.02", "0,31 ± 0,02"},
                                                         {"9.81 m/s²", "9,81 m/s²"},
                                                         {"12 of 18", "12 von 18"}};
    for (const auto& [english, german] : texts)
        EXPECT_EQ(coreWords(english).toStdString(), german);
}

TEST_F(CoreWords, NamesVersionsAndAddressesKeepTheirPoint) {
    for (const char* name : {"walk 1.5", "walk_1.5.bvh", "/tmp/walk 1.5/a.bvh", "1.5/a.bvh", "noctule 0.1.0",
                             "192.168.1.5", "3 of hearts.bvh"})
        EXPECT_EQ(coreWords(name).toStdString(), name);
}

TEST_F(CoreWords, WhatStandsInBracketsBehindANameIsGerman) {
    EXPECT_EQ(coreWords("Source 2 (Left hand)").toStdString(), "Quelle 2 (Linke Hand)");
}

TEST_F(CoreWords, AFigureIsDescribedInGerman) {
    EXPECT_EQ(coreWords("walk: 123 frames at 60.00 per second; a figure 1.75 m tall (1 unit = 0.01 m), y up; "
                        "19 joints by name; zero pose: T pose")
                  .toStdString(),
              "walk: 123 Bilder mit 60,00 je Sekunde; eine Figur von 1,75\u00a0m Größe (1 Einheit = "
              "0,01\u00a0m), y nach "
              "oben; 19 Gelenke nach ihrem Namen; Nullpose: T-Pose");
}

TEST_F(CoreWords, BoardsOfFindingsAreGerman) {
    EXPECT_EQ(
        coreWords("Board 6, Left forearm, is silent in the rest pose and keeps its old values").toStdString(),
        "Platine 6, Linker Unterarm, schweigt in der Ruhehaltung und behält ihre alten Werte");
}

TEST_F(CoreWords, SavedPartsOfADamagedTakeAreGerman) {
    TakeLosses losses{{{"adc_block", 3, 5}, {"reference", 0, 7}, {"external_root", 54, 46}}, 1, 2};
    EXPECT_EQ(coreWords(savedText(losses)).toStdString(),
              "Davon gespeichert: 1,00\u00a0s von 2,00\u00a0s des Tons, nichts von der Referenzbewegung, "
              "etwa 54 % von der "
              "Wurzel von außen; alles Übrige ist vollständig");
    losses.tables.resize(1);
    losses.may_have_had_more = true;
    EXPECT_EQ(
        coreWords(savedText(losses)).toStdString(),
        "Davon gespeichert: 1,00\u00a0s von 2,00\u00a0s des Tons; alles Übrige ist vollständig. Auch das "
        "Verzeichnis ihres Inhalts "
        "ist beschädigt, es kann also mehr verloren sein");
}

TEST_F(CoreWords, StagesOfAJobAreGerman) {
    EXPECT_EQ(coreWords("Writing").toStdString(), "Schreiben");
    EXPECT_EQ(coreWords("Drawing walk.avi").toStdString(), "walk.avi wird gezeichnet");
    EXPECT_EQ(coreWords("Preparing the motion").toStdString(), "Bewegung wird vorbereitet");
}

TEST_F(CoreWords, NoScreenAsksForACommand) {
    EXPECT_EQ(coreWords(Error{ErrorKind::kUnreadable, "a.b.noctule: xyz",
                              "Run `noctule --batch recover` on it, which saves what can be read"})
                  .toStdString(),
              "a.b.noctule: xyz");
    EXPECT_EQ(coreWords("xyz; `noctule --batch recover` may save the rest").toStdString(), "xyz");
    EXPECT_EQ(coreWords("Run `noctule --batch process /a. b/c.noctule` first").toStdString(), "");
    EXPECT_EQ(coreWords("xyz. Run `noctule --batch recover` on it.").toStdString(), "xyz");
}

TEST_F(CoreWords, ErrorsOfTheStudioAndReasonsOfTheSystemAreGerman) {
    EXPECT_EQ(coreWords(Error{ErrorKind::kDisk, "/mnt/takes: cannot be made: Permission denied",
                              "Choose another folder for sessions in the preferences"})
                  .toStdString(),
              "/mnt/takes: lässt sich nicht anlegen: keine Berechtigung. In den Einstellungen einen anderen "
              "Ordner für Sitzungen wählen");
    EXPECT_EQ(coreWords("The driver box sends no sound").toStdString(), "Die Steuerbox sendet keinen Ton");
}

TEST_F(CoreWords, TagsAndStylesOfADocumentStayTextsDoNot) {
    const std::string page =
        "<html lang=\"en\"><style>p{color:red}</style><p class=\"a\">Joint</p><b aria-label=\"Joint\">&lt;1 "
        "mm</b></html>";
    EXPECT_EQ(coreMarkup(page),
              "<html lang=\"de\"><style>p{color:red}</style><p class=\"a\">Gelenk</p><b "
              "aria-label=\"Gelenk\">&lt;1\u00a0mm</b></html>");
    QLocale::setDefault(QLocale(QLocale::English));
    EXPECT_EQ(coreMarkup(page), page);
}

/// The texts of a page in which English words are left, without what the operator wrote.
QStringList englishIn(const QString& page, const QString& of_the_operator) {
    static const QRegularExpression text("<style.*?</style>|>([^<>]+)<",
                                         QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression english(
        "\\b(the|of|and|with|is|are|to|over|mean|run|none|joint|board|source|left|right|free|given)\\b",
        QRegularExpression::CaseInsensitiveOption);
    QStringList found;
    for (auto match = text.globalMatch(page); match.hasNext();) {
        const QString words = match.next().captured(1).trimmed();
        if (words.contains(english) && !words.contains(of_the_operator) && !found.contains(words))
            found.append(words);
    }
    return found;
}

TEST_F(CoreWords, AReportIsGermanToItsLastSentence) {
    ReportData data = test::madeReport(20);
    data.together = {"Ada", "Bea", "Cleo"};
    data.alone = {"Dan", "Eva"};
    const QString page = QString::fromStdString(coreMarkup(htmlReport(data)));
    ASSERT_GT(page.size(), 10'000);
    EXPECT_TRUE(page.contains(
        "Ada, Bea und Cleo wurden gemeinsam geschätzt. Dan und Eva wurden je allein geschätzt."));
    EXPECT_EQ(englishIn(page, "Second round").join("\n").toStdString(), "");
    QLocale::setDefault(QLocale(QLocale::English));
    EXPECT_GT(englishIn(QString::fromStdString(htmlReport(data)), "Second round").size(), 50);
}

}  // namespace
}  // namespace noctule::ui
