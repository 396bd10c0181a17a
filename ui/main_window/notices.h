// SPDX-License-Identifier: Apache-2.0
// What failed or wants a decision, as cards above the page: newest first, three at a time, each with what is
// safe. The same notice is not shown twice.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "ui/style/ink.h"

namespace noctule::ui {

class Label;
class ProblemCard;

struct Notice {
    Tone tone = Tone::kWarn;
    QString title, text;
    QString action;  ///< empty: none
    std::function<void()> act;
    QString topic;  ///< a later notice of the same topic replaces this one; empty: the title
};

class Notices : public QWidget {
    Q_OBJECT
public:
    explicit Notices(QWidget* parent = nullptr);

    void add(const Notice& notice);
    /// The cause is gone.
    void remove(const QString& topic);
    int count() const { return static_cast<int>(shown_.size()); }
    QStringList titles() const;

private:
    void arrange();

    struct Shown {
        QString topic;
        ProblemCard* card;
    };
    std::vector<Shown> shown_;  ///< newest first
    QWidget* cards_;
    Label* more_;
};

}  // namespace noctule::ui
