// SPDX-License-Identifier: Apache-2.0
// What several pages and the menus offer: make or open a session, import takes. Each asks the operator with a
// dialog and hands the answer to the session model.
#pragma once

#include <QCoreApplication>
#include <QStringList>

#include "ui/models/session_model.h"

class QWidget;

namespace noctule::ui {

class SharedContext;

class SessionCommands {
    Q_DECLARE_TR_FUNCTIONS(SessionCommands)
public:
    static void askForNew(QWidget* parent, SharedContext& shared);
    static void askToOpen(QWidget* parent, SharedContext& shared);
    /// Empty when the operator thought better of it.
    static QStringList askForTakes(QWidget* parent, SharedContext& shared);
    static QString askForMotion(QWidget* parent);
    /// Files of one recording of other sensors.
    static QStringList askForRecording(QWidget* parent);
    /// Asks which takes, and for a session first when none is open.
    static void askForImport(QWidget* parent, SharedContext& shared);
    /// A new session first when none is open.
    static void import(QWidget* parent, SharedContext& shared, const QStringList& paths);

    /// Asks for the session that a take goes to.
    static void askForTransfer(QWidget* parent, SharedContext& shared, int take, SessionModel::Transfer how);

    /// Whether a session lies in the folder.
    static bool isSession(const QString& folder);
    /// Also where session.json is missing or damaged and can be made again from the takes.
    static bool canBeOpened(const QString& folder);
    /// The session folder that a take lies in (FOLDER/takes/NAME.noctule), or empty.
    static QString sessionOfTake(const QString& take_path);
};

}  // namespace noctule::ui
