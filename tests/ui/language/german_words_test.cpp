// SPDX-License-Identifier: Apache-2.0
// How German is written: one word for one thing, German signs, no line that ends within a unit, no menu
// with one key for two entries.
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <map>
#include <set>

#include "tests/ui/language/translation_file.h"

namespace noctule::ui {
namespace {

struct Term {
    const char *english, *german;  ///< regular expressions: whole words, parts of words
};

/// What is said of a thing always has its German word, or keeps the English one as the name of a column.
constexpr Term kTerms[] = {
    {"accelerometers?", "Beschleuni"},
    {"anchors?", "Anker"},
    {"batter(y|ies)", "Akku"},
    {"boards?", "[Pp]latine"},
    {"cables?", "[Kk]abel"},
    {"calibrat(e|ed|ing|ions?)(?! and exports)", "alibrier"},
    {"carriers?", "Träger"},
    {"clocks?", "Uhr"},
    {"computers?", "Rechner"},
    {"confidence", "Konfidenz"},
    {"contacts?", "ontakt"},
    {"countdown", "Countdown"},
    {"cursor", "Zeiger"},
    {"disk", "Datenträger|Platz|Gespeichert"},
    {"distances?", "ntfernung|Abst[aä]nd"},
    {"drifts?", "[Dd]rift"},
    {"driver box(es)?", "[Bb]ox"},
    {"estimators?", "Schätzer"},
    {"filters?", "ilter"},
    {"folders?", "rdner"},
    {"gaps?", "Lücke"},
    {"ghost", "Umriss"},
    {"gyroscopes?", "Gyroskop"},
    {"headings?", "[Rr]ichtung|Überschrift"},
    {"jig", "Messgestell"},
    {"joints?", "[Gg]elenk"},
    {"limbs?", "[Gg]lied|Körper"},
    {"magnetometers?", "Magnetometer"},
    {"markers?", "[Mm]ark"},
    {"median", "Median"},
    {"mesh(es)?", "[Nn]etz"},
    {"microphones?", "ikrofon"},
    {"network", "Netzwerk"},
    {"pairs?", "Paar"},
    {"performers?", "[Dd]arsteller"},
    {"placements?", "ufstellung|Sitz"},
    {"plots?", "Diagramm|Kurve"},
    {"poses?", "[Pp]ose|haltung"},
    {"posture", "Haltung"},
    {"pre-roll", "Vorlauf"},
    {"presets?", "Vorgabe"},
    {"pulses?", "Puls"},
    {"ranges?", "ntfernung|ereich|estfehler|behalten"},
    {"rebuil\\w+", "aufbau|aufgebaut"},
    {"references?", "eferenz|Bezug"},
    {"residuals?", "[Rr]est"},
    {"rest poses?", "Ruhe"},
    {"results?", "rgebnis"},
    {"robots?", "Roboter"},
    {"save[sd]?", "speicher|rett"},
    {"segments?", "[Gg]lied"},
    {"sessions?", "Sitzung"},
    {"shot list", "Szenenliste"},
    {"shots?", "Szene"},
    {"sigma", "Sigma"},
    {"skeletons?", "kelett"},
    {"sources?", "[Qq]uelle"},
    {"straps?", "Gurt"},
    {"(?<!not )suits?", "[Aa]nz[uü]g"},
    {"survey(s|ed|ing)?", "[Vv]ermess"},
    {"timeline", "Zeitleiste"},
    {"trash", "Papierkorb"},
    {"turntable", "Drehteller"},
};

/// Second words for the same thing, or words that mislead. Nobody is addressed as "du".
const char* const kAvoided =
    "\\b(Akteur|Batterie|Computer|Festplatte|Impuls|Treiberbox|Aufnahmeliste|[Bb]enutz\\w*|[Uu]nbenutzt|"
    "[Ss]ichern|[Gg]esichert|[Ee]inmess\\w*|[Ee]ingemessen|Residu\\w*|Ruhepose|stillstehen|T-Haltung|"
    "Nullhaltung|[Ww]aagerecht\\w*|Weichteile|[Dd]as (Kalman-)?Filter|du|dich|dir|dein\\w*|euch|euer)\\b";

struct Form {
    QString source, german;
};

/// Sentences that differ from the English ones; names of columns and parts of statements do not.
std::vector<Form> germanForms() {
    std::vector<Form> forms;
    for (const char* file : {"noctule_de.ts", "core_de.ts"})
        for (const Message& message : readTs(translationPath(file)))
            for (const QString& form : message.forms)
                if (form != message.source)
                    forms.push_back({message.source, form});
    return forms;
}

QRegularExpression pattern(const QString& text) {
    return QRegularExpression(text, QRegularExpression::UseUnicodePropertiesOption);
}

QRegularExpression wholeWord(const QString& text) {
    return pattern("\\b(" + text + ")\\b");
}

/// Without commands, their options, names of files and of columns, and {take} of a file's name.
QString withoutNames(QString english) {
    static const QRegularExpression names = pattern(
        "`[^`]*`|--[a-z-]+|\\{\\w+\\}|\\w+\\.(json|cpp|md)\\b|\\w+_\\w+|[A-Z]{3,}|noctule-virtual-suit");
    return english.remove(names);
}

void expectWithout(const Form& form, const QRegularExpression& wrong) {
    const auto match = wrong.match(form.german);
    EXPECT_FALSE(match.hasMatch()) << match.captured().toStdString() << " in: " << form.german.toStdString();
}

TEST(GermanWords, OneThingHasOneWord) {
    const std::vector<Form> forms = germanForms();
    ASSERT_GT(forms.size(), 4000U);
    for (const Term& term : kTerms) {
        const QRegularExpression english = wholeWord(term.english), german = pattern(term.german);
        int said = 0;
        for (const Form& form : forms) {
            if (!withoutNames(form.source).contains(english))
                continue;
            ++said;
            EXPECT_TRUE(form.german.contains(german) || form.german.contains(english))
                << term.german << " is missing: " << form.source.toStdString() << " -> "
                << form.german.toStdString();
        }
        EXPECT_GT(said, 0) << term.english << " is said nowhere: take it off the list";
    }
}

TEST(GermanWords, NoSecondWordForTheSameThing) {
    const QRegularExpression avoided = pattern(kAvoided);
    for (const Form& form : germanForms())
        expectWithout(form, avoided);
}

TEST(GermanWords, QuotesAreGerman) {
    const QRegularExpression wrong =
        pattern(QStringLiteral("['\"]%\\d|%\\d['\"]|[”‘]|„[^“]*„|“[^„]*“|„[^“]*$"));
    for (const Form& form : germanForms())
        expectWithout(form, wrong);
}

TEST(GermanWords, NoLineEndsBetweenANumberAndItsUnit) {
    const QRegularExpression wrong = pattern(
        QStringLiteral("(\\d|%n) (%(?![\\dnL])|°/s|[mck]?m|[mµ]?s|k?Hz|µT|[kMG]i?B(/s)?|°C|min|h|mg|px|"
                       "U/min|(m|rad)/s(²|\\^2)?)(?![\\w/^²])"));
    for (const Form& form : germanForms())
        expectWithout(form, wrong);
}

TEST(GermanWords, NumbersHaveACommaAndWordsTheirDots) {
    const QRegularExpression wrong =
        pattern(QStringLiteral("\\d\\.\\d+[ \u00a0]?(%|°|[mck]?m|[mµ]?s|k?Hz)\\b|[^\\s\u00a0]…| …"));
    for (const Form& form : germanForms())
        expectWithout(form, wrong);
}

TEST(GermanWords, NoKeyOpensTwoMenus) {
    static const QRegularExpression key("&(\\w)");
    for (const bool german : {false, true}) {
        std::map<QString, std::set<QString>> keys_of;
        for (const Message& message : readTs(translationPath("noctule_de.ts"))) {
            const QString text = german ? message.forms.value(0) : message.source;
            const auto match = key.match(text);
            EXPECT_EQ(match.hasMatch(), message.source.contains(key)) << text.toStdString();
            if (match.hasMatch())
                EXPECT_TRUE(keys_of[message.context].insert(match.captured(1).toLower()).second)
                    << text.toStdString();
        }
        EXPECT_FALSE(keys_of.empty());
    }
}

TEST(GermanWords, APairIsNotSaidToBelongToItsBoard) {
    std::map<QString, QString> german;
    for (const Message& message : readTs(translationPath("noctule_de.ts")))
        if (message.context == "PartNames")
            german[message.source + '|' + message.comment] = message.forms.value(0);
    const QString source = german["source %1 (%2)|source 8 (hat)"].arg(QString("8"), german["hat|"]);
    EXPECT_EQ(german["%1 to %2|source 8 (hat) to left shin"].arg(source, german["left shin|"]),
              "Quelle 8 (Hut) – linker Unterschenkel");
}

/// Buttons are infinitives; what the operator is asked to do is said to him.
TEST(GermanWords, HintsOfExportAddressTheOperator) {
    static const QRegularExpression asks("^(Open one|Tick|Choose a|Wait|Export it)");
    int hints = 0;
    for (const Message& message : readTs(translationPath("noctule_de.ts")))
        if (message.context.startsWith("noctule::ui::Export") && message.source.contains(asks)) {
            ++hints;
            EXPECT_TRUE(message.forms.front().contains(" Sie ")) << message.forms.front().toStdString();
        }
    EXPECT_GE(hints, 5);
}

}  // namespace
}  // namespace noctule::ui
