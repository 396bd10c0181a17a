// SPDX-License-Identifier: Apache-2.0
// The keys of commands: the usual ones, or one that the operator chose, which the settings keep. A command is
// called "window/record": the room where its key acts, and its own name. The room "window" is everywhere.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <QPointer>
#include <functional>
#include <vector>

namespace noctule::ui {

class Keys : public QObject {
    Q_OBJECT
public:
    static Keys& get();

    /// From now on the action has the keys of the command `name`.
    void adopt(QAction& action, const QString& name, const QList<QKeySequence>& usual);
    /// Other usual keys for an action that was adopted.
    void setUsual(QAction& action, const QList<QKeySequence>& usual);
    /// `acts` says of each of the action's keys, also one of the operator's own, whether it acts; asked now
    /// and whenever keys change.
    void restrict(QAction& action, std::function<bool(const QKeySequence&)> acts);
    /// Empty for an action whose keys are fixed.
    QString nameOf(const QAction& action) const;
    /// The first key, for hints: known also before there is an action.
    static QKeySequence keyOf(const QString& name, const QKeySequence& usual);
    static bool actsEverywhere(const QString& name);

    /// One of the command's own, before the operator chose.
    bool isUsual(const QKeySequence& key, const QString& name) const;
    /// Another command that `key` would call where `name` acts, or null.
    QAction* holderOf(const QKeySequence& key, const QString& name) const;
    /// Its usual first key again: no choice is kept.
    void choose(const QString& name, const QKeySequence& key);
    void restoreUsual();

signals:
    void changed();

private:
    struct Adopted {
        QPointer<QAction> action;
        QString name;
        QList<QKeySequence> usual;
        std::function<bool(const QKeySequence&)> acts;  ///< empty: all do
    };

    Keys() = default;
    const Adopted* find(const QAction& action) const;
    static void apply(const Adopted& one);
    void applyAll();

    std::vector<Adopted> adopted_;
};

/// Shows the key of a command now and after each change, as long as `owner` lives.
void followKey(QObject& owner, const QString& name, const QKeySequence& usual,
               const std::function<void(const QKeySequence&)>& show);

}  // namespace noctule::ui
