// SPDX-License-Identifier: Apache-2.0
// What the operator changes in the file of a take (markers, contacts of the feet, places of anchors, what is
// attached): each a step on the session's undo stack, written by jobs one after the other in the order in
// which the steps were made.
#pragma once

#include <QObject>
#include <QPointer>
#include <deque>
#include <memory>
#include <variant>

#include "core/processing/attached_motion.h"
#include "core/processing/survey_room.h"
#include "core/processing/take_contacts.h"
#include "core/processing/take_markers.h"
#include "ui/models/session_model.h"
#include "ui/models/take_document.h"

namespace noctule::ui {

using TakeChange = std::variant<MarkerChange, ContactsChange, RoomChange, AttachedChange>;

class TakeChanges : public QObject {
    Q_OBJECT
public:
    TakeChanges(Jobs& jobs, SessionModel& session, TakeDocument& take, QObject* parent = nullptr);

    /// A step of the open take; `what` as the undo stack tells it.
    void push(const QString& what, const TakeChange& change);
    /// A step that a job has written into a take already.
    void pushWritten(const QString& what, const QString& take_path, const TakeChange& change);

    /// Of one kind for a take, in the order in which they will be written.
    template <class Change>
    std::vector<Change> waiting(const QString& take_path) const {
        std::vector<Change> changes;
        for (const Order& order : orders_)
            if (const auto* change = std::get_if<Change>(&order.change); change && order.path == take_path)
                changes.push_back(*change);
        return changes;
    }

signals:
    /// It waits to be written.
    void ordered(const QString& take_path, const noctule::ui::TakeChange& change);
    /// It is in the take now; the document reads it again.
    void written(const QString& take_path, const noctule::ui::TakeChange& change);
    void failed(const QString& what, const QString& remedy);

private:
    friend class TakeCommand;
    /// Where a step on the undo stack has got to in the take's file.
    enum class Written { kNotYet, kDone, kUndone, kNever };
    /// Passed over when the file is that way already, because what came before failed: a step that could not
    /// be undone is done, and can be undone later.
    struct Order {
        QString path;
        TakeChange change;
        bool to_do;  ///< else it is undone
        std::shared_ptr<Written> step;
        std::shared_ptr<void> kept{};

        bool isNeeded() const { return to_do != (*step == Written::kDone); }
    };
    void enqueue(Order order);
    void startNext();
    void finish(const Order& order, const Status& status);

    Jobs& jobs_;
    SessionModel& session_;
    TakeDocument& take_;
    std::deque<Order> orders_;  ///< the first is being written
};

}  // namespace noctule::ui
