// SPDX-License-Identifier: Apache-2.0
#include "ui/language/core_words.h"

#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>
#include <mutex>
#include <optional>

#include "ui/language/language.h"

namespace noctule::ui {
namespace {

constexpr int kDeepest = 4;          ///< sentences within sentences
constexpr int kLongestSplit = 4000;  ///< letters; longer texts are no sentences
constexpr int kRemembered = 2000;    ///< sentences

int lettersOf(const QString& text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](QChar c) { return c.isLetter(); }));
}

/// Where the values stand in `text`, or nothing when the literals do not fit.
std::optional<QStringList> valuesIn(const QString& text, const QStringList& literals) {
    const QString &first = literals.first(), &last = literals.last();
    const int values = literals.size() - 1;
    if (text.size() < first.size() + last.size() + values || !text.startsWith(first) || !text.endsWith(last))
        return std::nullopt;
    const int end = text.size() - last.size();
    QStringList found;
    int at = first.size();
    for (int v = 0; v < values; ++v) {
        const bool is_last = v + 1 == values;
        const int next = is_last ? end : text.indexOf(literals[v + 1], at + 1);
        if (next <= at || next > end)
            return std::nullopt;
        found.append(text.mid(at, next - at));
        at = is_last ? end : next + literals[v + 1].size();
    }
    return found;
}

/// Numbers with the decimal sign of the screen: "3.25", "0.9 mm (4.5 sigma)", "1.5 −0.2 0.0". In names
/// ("walk 1.5") and versions ("1.2.3") the point stays.
QString numbersInWords(const QString& text) {
    static const QRegularExpression number(
        "(?:^|(?<=, |: |; |± |– |\\d |\\())([−+-]?\\d+)\\.(\\d+)"
        "(?=(?: ?[^\\s\\d.,:;()/][^\\s.,:;()]{0,7})?(?:$|[,:;] | [±–(]| [−+-]?\\d|\\)))");
    static const QRegularExpression time("(?<=\\d:\\d\\d)\\.(?=\\d)");  // 1:05.5
    static const QRegularExpression share("^(\\d+) of (\\d+)$");
    const QString point(QLocale().decimalPoint());
    return QString(text)
        .replace(number, "\\1" + point + "\\2")
        .replace(time, point)
        .replace(share, "\\1 von \\2");
}

SentencePatterns readPatterns() {
    SentencePatterns patterns;
    nameTranslations();
    QFile file(":/noctule/translations/core_de.ts");
    require(file.open(QIODevice::ReadOnly), "the program was built without its translations");
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == "source")
            source = xml.readElementText();
        else if (xml.isStartElement() && xml.name() == "translation")
            if (const QString words = xml.readElementText(); !words.isEmpty())
                patterns.add(source, words);
    }
    return patterns;
}

QString inGerman(const QString& english) {
    static const SentencePatterns patterns = readPatterns();
    static std::mutex mutex;
    static QHash<QString, QString> remembered;
    {
        const std::lock_guard lock(mutex);
        if (const auto known = remembered.constFind(english); known != remembered.constEnd())
            return *known;
    }
    const QString words = patterns.translated(english);
    const std::lock_guard lock(mutex);
    if (remembered.size() >= kRemembered)
        remembered.clear();
    remembered.insert(english, words);
    return words;
}

QString onScreen(const QString& english) {
    return QLocale().language() == QLocale::German ? inGerman(english) : english;
}

QString withoutEntities(QString text) {
    return text.replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&#39;", "'")
        .replace("&amp;", "&");
}

}  // namespace

void SentencePatterns::add(const QString& english, const QString& translated) {
    static const QRegularExpression value("%\\d+");
    const QStringList literals = english.split(value);
    if (literals.size() == 1)
        whole_.insert(english, translated);
    else {
        const Pattern pattern{literals, translated, lettersOf(literals.join(QString()))};
        patterns_.insert(
            std::ranges::upper_bound(patterns_, pattern.letters, std::greater(), &Pattern::letters), pattern);
    }
}

QString SentencePatterns::translated(const QString& english) const {
    return find(english, 0).words;
}

SentencePatterns::Found SentencePatterns::find(const QString& english, int depth) const {
    Found found = findAsWritten(english, depth);
    if (found.letters > 0 || english.isEmpty() || !english[0].isLetter())
        return found;
    QString other = english;  // "left hand" is known as "Left hand", "Source 2" as "source 2"
    const bool was_upper = other[0].isUpper();
    other[0] = was_upper ? other[0].toLower() : other[0].toUpper();
    Found turned = findAsWritten(other, depth);
    if (turned.letters == 0)
        return found;
    if (was_upper)
        turned.words[0] = turned.words[0].toUpper();
    else if (turned.words.contains(' '))  // it begins with an adjective; a noun keeps its capital
        turned.words[0] = turned.words[0].toLower();
    return turned;
}

SentencePatterns::Found SentencePatterns::findAsWritten(const QString& english, int depth) const {
    if (const auto whole = whole_.constFind(english); whole != whole_.constEnd())
        return {*whole, lettersOf(english)};
    if (depth >= kDeepest || english.size() > kLongestSplit)
        return {english, 0};
    Found best = byPattern(english, depth);
    if (best.letters > 0 && best.letters == lettersOf(english))
        return best;
    for (Found split : {bySplitting(english, depth), asList(english, depth)})
        if (split.letters > best.letters)
            best = std::move(split);
    if (english.size() > 1 && english.endsWith('.'))
        if (const Found inner = find(english.chopped(1), depth + 1); inner.letters > best.letters)
            best = {inner.words + '.', inner.letters};
    return best.letters > 0 ? best : Found{numbersInWords(english), 0};
}

SentencePatterns::Found SentencePatterns::byPattern(const QString& english, int depth) const {
    QStringList values;
    const auto best = std::ranges::find_if(patterns_, [&](const Pattern& pattern) {
        auto found = valuesIn(english, pattern.literals);
        if (found)
            values = std::move(*found);
        return found.has_value();
    });
    if (best == patterns_.end())
        return {english, 0};
    Found result{best->translated, best->letters};
    for (int v = values.size(); v >= 1; --v) {  // from the last: %1 is the beginning of %10
        const QString as_written = values[v - 1], trimmed = as_written.trimmed();
        Found value = find(trimmed, depth + 1);
        if (!trimmed.isEmpty())
            value.words = QString(as_written).replace(trimmed, value.words);
        result.words.replace("%" + QString::number(v), QChar(0xE000 + v));
        result.letters += value.letters;
        values[v - 1] = value.words;
    }
    for (int v = 1; v <= values.size(); ++v)
        result.words.replace(QChar(0xE000 + v), values[v - 1]);
    return result;
}

SentencePatterns::Found SentencePatterns::bySplitting(const QString& english, int depth) const {
    Found best{english, 0};
    for (const char* between : {". ", "; ", ": ", ", "}) {
        const int at = english.indexOf(QLatin1String(between));
        if (at <= 0)
            continue;
        Found before = find(english.left(at), depth + 1);
        before.words += between[0];
        if (*between == '.')  // the full stop may belong to the sentence
            if (Found whole = find(english.left(at + 1), depth + 1); whole.letters > before.letters)
                before = std::move(whole);
        const Found behind = find(english.mid(at + 2), depth + 1);
        if (before.letters + behind.letters > best.letters)
            best = {before.words + ' ' + behind.words, before.letters + behind.letters};
    }
    return best;
}

SentencePatterns::Found SentencePatterns::asList(const QString& english, int depth) const {
    static const QRegularExpression between(", | and (?=[^,]*$)");
    Found list{QString(), 0};
    int at = 0;
    if (!english.contains(between) && !english.endsWith(')'))
        return {english, 0};
    for (auto match = between.globalMatch(english); at >= 0;) {
        const bool is_last = !match.hasNext();
        const auto next = is_last ? QRegularExpressionMatch() : match.next();
        const QString item = english.mid(at, is_last ? -1 : next.capturedStart() - at);
        const int bracket = item.endsWith(')') ? item.indexOf(" (") : -1;
        const QString name = item.left(bracket);
        const Found known = find(name, depth + 1);
        if (known.letters < lettersOf(name))
            return {english, 0};
        list.words += known.words;
        list.letters += known.letters;
        if (bracket >= 0) {
            const Found inner = find(item.mid(bracket + 2).chopped(1), depth + 1);
            list.words += " (" + inner.words + ')';
            list.letters += inner.letters;
        }
        if (!is_last)
            list.words += next.captured() == ", " ? ", " : " und ";
        at = is_last ? -1 : next.capturedEnd();
    }
    return list;
}

QString coreWords(const std::string& english) {
    // "(--rate HZ)" and "Run `noctule --batch inspect` on it": no screen has a command line.
    static const QRegularExpression option(QStringLiteral(" \\([^()]*--[a-z][^()]*\\)"));
    static const QRegularExpression command(
        QStringLiteral("(?:^|[.;] )[^.;`]*`noctule --batch[^`]*`[^.;]*(?:[.;]$)?"));
    return onScreen(QString::fromStdString(english).remove(command)).remove(option);
}

QString coreWords(const Error& error) {
    return coreWords(error.text());
}

std::string coreMarkup(const std::string& html) {
    if (QLocale().language() != QLocale::German)
        return html;
    const QString english = QString::fromStdString(html);
    static const QRegularExpression text(
        "<(style|script)\\b.*?</\\1>|(?<=>)[^<>]+(?=<)|(?<=aria-label=\")[^\"]+(?=\")|<html lang=\"en\"",
        QRegularExpression::DotMatchesEverythingOption);
    QString german;
    int done = 0;
    for (auto match = text.globalMatch(english); match.hasNext();) {
        const auto one = match.next();
        german += english.midRef(done, one.capturedStart() - done);
        const QString found = one.captured(), words = found.trimmed();
        if (found.startsWith("<html"))
            german += "<html lang=\"de\"";
        else if (found.startsWith('<') || words.isEmpty())
            german += found;
        else
            german += QString(found).replace(words, onScreen(withoutEntities(words)).toHtmlEscaped());
        done = one.capturedEnd();
    }
    return (german + english.midRef(done)).toStdString();
}

}  // namespace noctule::ui
