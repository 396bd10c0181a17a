// SPDX-License-Identifier: Apache-2.0
// Markers of the operator in the open take: set, renamed, deleted.
#pragma once

#include "ui/models/take_changes.h"

namespace noctule::ui {

class MarkerEditor : public QObject {
    Q_OBJECT
public:
    MarkerEditor(TakeChanges& changes, TakeDocument& take, QObject* parent = nullptr);

    /// Sync markers belong to the recording.
    static bool isEditable(const ReviewMarker& marker) { return marker.kind == "user"; }

    /// Named "Marker 3", after the first number that is free.
    void add(double t_s);
    // Index into overview()->markers; nothing happens to those that cannot be edited.
    void rename(int marker, const QString& label);
    void remove(int marker);

private:
    const ReviewMarker* editable(int marker) const;
    QString freeLabel() const;

    TakeChanges& changes_;
    TakeDocument& take_;
};

}  // namespace noctule::ui
