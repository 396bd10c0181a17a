// SPDX-License-Identifier: Apache-2.0
// Markers of the operator in the open take: set, renamed, deleted, each a step on the session's undo stack.
// The take's file is written by jobs, one after the other in the order in which the steps were made.
#pragma once

#include <QObject>
#include <QPointer>
#include <deque>
#include <memory>

#include "core/processing/take_markers.h"
#include "ui/models/session_model.h"
#include "ui/models/take_document.h"

namespace noctule::ui {

class MarkerEditor : public QObject {
    Q_OBJECT
public:
    MarkerEditor(Jobs& jobs, SessionModel& session, TakeDocument& take, QObject* parent = nullptr);

    /// Sync markers belong to the recording.
    static bool isEditable(const ReviewMarker& marker) { return marker.kind == "user"; }

    /// Named "Marker 3", after the first number that is free.
    void add(double t_s);
    // Index into overview()->markers; nothing happens to those that cannot be edited.
    void rename(int marker, const QString& label);
    void remove(int marker);

signals:
    /// It is in the take now; the document reads it again.
    void written(const QString& take_path, const noctule::MarkerChange& change);
    void failed(const QString& what, const QString& remedy);

private:
    friend class MarkerCommand;
    /// Where a step on the undo stack has got to in the take's file.
    enum class Written { kNotYet, kDone, kUndone, kNever };
    /// Passed over when the file is that way already, because what came before failed: a step that could not
    /// be undone is done, and can be undone later.
    struct Order {
        QString path;
        MarkerChange change;
        bool to_do;  ///< else it is undone
        std::shared_ptr<Written> step;
        std::shared_ptr<void> kept{};

        bool isNeeded() const { return to_do != (*step == Written::kDone); }
    };
    void push(const QString& what, const MarkerChange& change);
    void enqueue(Order order);
    void startNext();
    void finish(const Order& order, const Status& status);
    const ReviewMarker* editable(int marker) const;
    QString freeLabel() const;

    Jobs& jobs_;
    SessionModel& session_;
    TakeDocument& take_;
    std::deque<Order> orders_;  ///< the first is being written
};

}  // namespace noctule::ui
