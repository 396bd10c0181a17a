// SPDX-License-Identifier: Apache-2.0
// What a run leaves on disk: its record in the session, its takes.
#include <QFile>
#include <utility>

#include "core/session/take_folder.h"
#include "ui/language/core_words.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

/// Its takes go to the trash of the session: a solver must not see what the operator took back.
void WizardRun::dropEvidence(int step) {
    for (const WizardEvidence& part : unfinished_.evidence)
        if (part.step == step && capture_.shared().session().isOpen()) {
            const std::filesystem::path trash = capture_.shared().session().session().trashFolder();
            std::error_code ignored;
            std::filesystem::create_directories(trash, ignored);
            const std::filesystem::path from = part.path.toStdString();
            if (const Status moved =
                    moveTakeFiles(from, nextTakePath(trash, takeBaseName(from.stem().string())));
                !moved)
                emit capture_.shared().warned(coreWords(moved.error()), About::kSuit);
        }
    std::erase_if(unfinished_.evidence, [step](const WizardEvidence& part) { return part.step == step; });
}

QString WizardRun::statePath() const {
    return capture_.shared().session().isOpen()
               ? unfinishedPath(QString::fromStdString(
                                    capture_.shared().session().session().calibrationFolder().string()),
                                keyOf(task_), of_suit_)
               : QString();
}

void WizardRun::store() const {
    const QString path = statePath();
    // Who stands there today stood otherwise yesterday.
    if (path.isEmpty() || isWorn(task_))
        return;
    if (const Status written = writeUnfinished(path, keyOf(task_), unfinished_); !written)
        emit capture_.shared().warned(coreWords(written.error()), About::kSuit);
}

void WizardRun::restore() {
    const QString chosen = std::exchange(unfinished_, {}).distances_path;
    if (const QString path = statePath(); QFile::exists(path))
        unfinished_ = readUnfinished(
            path, QString::fromStdString(capture_.shared().session().session().evidenceFolder().string()));
    const QString before = std::exchange(unfinished_.distances_path, chosen);
    if (!before.isEmpty() && before != chosen)
        setDistances(before);
}

void WizardRun::forget() {
    unfinished_.evidence.clear();
    unfinished_.share = 0;
    field_path_.clear();
    unfinished_.started_utc.clear();
    if (const QString path = statePath(); !path.isEmpty())
        QFile::remove(path);
}

}  // namespace noctule::ui
