// SPDX-License-Identifier: Apache-2.0
// The commands of a page, for its menu and for the keyboard. Their keys act where nothing else wants them:
// the page hands them on from its keyPressEvent, after text fields and lists had their turn.
#pragma once

#include <QAction>
#include <QKeyEvent>
#include <QList>
#include <QObject>
#include <functional>

namespace noctule::ui {

class PageActions : public QObject {
    Q_OBJECT
public:
    /// `page` owns them.
    explicit PageActions(QWidget& page);

    const QList<QAction*>& all() const { return all_; }
    /// Whether a key that nothing else wanted was one of these.
    bool handleKey(const QKeyEvent& event);

protected:
    /// `name` as in ui/style/keys.h.
    QAction* add(const char* name, const QString& text, const QKeySequence& keys, std::function<void()> act);
    void addSeparator();

private:
    QWidget& page_;
    QList<QAction*> all_;
};

}  // namespace noctule::ui
