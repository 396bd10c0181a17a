// SPDX-License-Identifier: Apache-2.0
// The commands of Record, for the menu "Take" and for the keyboard; plain keys act wherever no text field has
// the focus.
#pragma once

#include <QAction>
#include <QKeyEvent>
#include <QObject>
#include <functional>

namespace noctule::ui {

class RecordPage;

class RecordActions : public QObject {
    Q_OBJECT
public:
    explicit RecordActions(RecordPage& page);

    const QList<QAction*>& all() const { return all_; }
    /// Whether a key that nothing else wanted was one of these.
    bool handleKey(const QKeyEvent& event);

private:
    QAction* add(const QString& text, const QKeySequence& keys, std::function<void()> act);
    void refresh();

    RecordPage& page_;
    QList<QAction*> all_;
    QAction *record_ = nullptr, *end_countdown_ = nullptr, *marker_ = nullptr, *note_ = nullptr;
};

}  // namespace noctule::ui
