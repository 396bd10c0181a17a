// SPDX-License-Identifier: Apache-2.0
#include "ui/models/personal_data.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <functional>

namespace noctule::ui {
namespace {

constexpr int kNamesOfPattern = 500;  ///< a pattern of some thousands cannot be compiled
constexpr const char* kSuffix =
    R"((noctule|json|bvh|fbx|glb|gltf|c3d|csv|mvnx|mot|sto|trc|obj|urdf|npz|txt|html|pdf|png|jpe?g|mp4|mkv|avi|mov|webm)(?![\p{L}\p{N}]))";
constexpr const char* kWord = R"([^/\s:,;|"'<>()=])";  ///< a character of a path without spaces

QString replaced(const QString& text, const QRegularExpression& pattern,
                 const std::function<QString(const QRegularExpressionMatch&)>& by) {
    QString out;
    int from = 0;
    for (auto all = pattern.globalMatch(text); all.hasNext();) {
        const auto match = all.next();
        out += text.mid(from, match.capturedStart() - from) + by(match);
        from = match.capturedEnd();
    }
    return out + text.mid(from);
}

/// Letters of every language bound a name; `\b` would know ASCII alone.
QRegularExpression anyOf(const QStringList& words) {
    QStringList longest_first;
    for (const QString& word : QSet<QString>(words.begin(), words.end()))
        if (word.size() > 1)
            longest_first += QRegularExpression::escape(word);
    std::sort(longest_first.begin(), longest_first.end(),
              [](const QString& a, const QString& b) { return a.size() > b.size(); });
    const QString nothing = "(?!)";
    return QRegularExpression(QStringLiteral(R"((?<![\p{L}\p{M}\p{N}])(?:%1)(?![\p{L}\p{M}\p{N}]))")
                                  .arg(longest_first.isEmpty() ? nothing : longest_first.join('|')),
                              QRegularExpression::CaseInsensitiveOption);
}

/// Begins at the root, a drive or the home folder; its folders may have spaces. The suffix is captured.
const QRegularExpression& wholePath() {
    static const QRegularExpression pattern = [] {
        const QString inside = R"((?:[^/|:;"<>\n]|[:;](?!\s)))";
        const QString folder = R"([^/\s|"<>](?:)" + inside + R"(*[^/\s|"<>])?/)";
        const QString file = R"([^/\s|"<>])" + inside + R"(*?\.)" + kSuffix;
        const QString last = QString(kWord) + R"(+(?: [\p{Lu}\p{N}])" + kWord + "*)*";
        return QRegularExpression(R"((?<![\p{L}\p{N}/])(?:~/|(?:file://|[A-Za-z]:)?/)" + folder +
                                  ")(?:" + folder + ")*(?:" + file + "|" + last + ")?");
    }();
    return pattern;
}

const QRegularExpression& relativePath() {
    static const QRegularExpression pattern(QString(kWord) + "*(?:/" + kWord + "+){2,}");
    return pattern;
}

const QRegularExpression& fileName() {
    static const QRegularExpression pattern(QString(kWord) + R"(+\.)" + kSuffix);
    return pattern;
}

void addFolder(QStringList& names, const QString& folder) {
    for (const QString& part : folder.split('/'))
        if (part.contains(' '))
            names += part;  // a path may end there, and its pattern stops at a space
    names += QFileInfo(folder).fileName();
}

}  // namespace

QStringList namesOf(const Session& session) {
    QStringList names{QString::fromStdString(session.name)};
    addFolder(names, QString::fromStdString(session.folder.string()));
    for (const Performer& performer : session.performers)
        names += QString::fromStdString(performer.name);
    for (const SessionTake& take : session.takes)
        names += QString::fromStdString(take.name);
    for (const Shot& shot : session.shots)
        names += QString::fromStdString(shot.name);
    return names;
}

QStringList namesInFolder(const QString& folder) {
    QStringList names;
    addFolder(names, folder);
    if (const auto session = readSession(folder.toStdString()); session.ok())
        names += namesOf(*session);
    for (const char* part : {"/takes", "/trash"})
        for (const QFileInfo& file : QDir(folder + part).entryInfoList({"*.noctule"}, QDir::Files))
            names += file.completeBaseName();
    return names;
}

QString withoutPersonalData(const QString& text, const QStringList& names) {
    QStringList composed;  // an accent may be a character of its own, in a file's name above all
    for (const QString& name : names)
        composed += name.trimmed().normalized(QString::NormalizationForm_C);
    const auto number = [&](const QRegularExpressionMatch& match) {
        for (int i = 0; i < composed.size(); ++i)
            if (composed[i].compare(match.captured(), Qt::CaseInsensitive) == 0)
                return QStringLiteral("[name-%1]").arg(i);
        return QStringLiteral("[name]");
    };
    const auto placed = [](const QRegularExpressionMatch& match) {
        return "[path]/*" + (match.captured(1).isEmpty() ? QString() : '.' + match.captured(1));
    };
    QString out = text.normalized(QString::NormalizationForm_C);
    for (int from = 0; from < composed.size(); from += kNamesOfPattern)
        out = replaced(out, anyOf(composed.mid(from, kNamesOfPattern)), number);
    static const QRegularExpression quoted("[“„«][^“”„«»\n]+[“”»]");
    out = replaced(out, quoted, [](const auto&) { return QStringLiteral("“[quoted]”"); });
    out = replaced(out, wholePath(), placed);
    out = replaced(out, relativePath(), placed);
    out = replaced(out, fileName(), [](const auto& match) { return "*." + match.captured(1); });
    return replaced(out, anyOf({qEnvironmentVariable("USER"), QDir::home().dirName()}),
                    [](const auto&) { return QStringLiteral("[user]"); });
}

}  // namespace noctule::ui
