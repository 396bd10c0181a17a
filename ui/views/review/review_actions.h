// SPDX-License-Identifier: Apache-2.0
// The commands of Review for menus. Plain keys and those that mean something else on other pages act in
// ReviewPage::keyPressEvent, after text fields and lists had their turn; here they are told only.
#pragma once

#include <QAction>
#include <QList>
#include <functional>

namespace noctule::ui {

class ReviewPage;
class Studio;

class ReviewActions : public QObject {
    Q_OBJECT
public:
    ReviewActions(Studio& studio, ReviewPage& page);

    const QList<QAction*>& all() const { return all_; }
    void refresh();

private:
    QAction* add(const QString& text, const QKeySequence& keys, std::function<void()> act);
    void addSeparator();
    void addPlayback();
    void addRange();
    void addTake();

    Studio& studio_;
    ReviewPage& page_;
    QList<QAction*> all_;
    QAction *play_ = nullptr, *loop_ = nullptr, *next_performer_ = nullptr, *side_by_side_ = nullptr;
    QAction *name_marker_ = nullptr, *delete_marker_ = nullptr, *found_contacts_ = nullptr;
};

}  // namespace noctule::ui
