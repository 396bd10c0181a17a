// SPDX-License-Identifier: Apache-2.0
// What failed or wants a decision, as cards above the page: newest first, two at a time, each with what is
// safe; a button steps to the others. The same notice is not shown twice.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "ui/style/ink.h"

namespace noctule::ui {

class Button;
class ProblemCard;

struct Notice {
    Tone tone = Tone::kWarn;
    QString title, text;
    QString action;  ///< empty: none
    std::function<void()> act;
    QString topic;                   ///< a later notice of the same topic replaces this one; empty: the title
    std::function<void()> closed{};  ///< the operator closed it without the action
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
    Button* moreButton() const { return more_; }

private:
    void arrange();
    void step();

    struct Shown {
        QString topic;
        ProblemCard* card;
    };
    std::vector<Shown> shown_;  ///< newest first, unless stepped on
    QWidget* cards_;
    Button* more_;
};

}  // namespace noctule::ui
