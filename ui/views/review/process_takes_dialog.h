// SPDX-License-Identifier: Apache-2.0
// Several takes of the session processed, each with one calibration: all sensors, free root.
// Review has the other choices for a single take. Nothing is replaced, every processing adds a result.
#pragma once

#include <optional>

#include "ui/models/studio.h"
#include "ui/views/dialog_frame.h"

class QListWidget;

namespace noctule::ui {

class ProcessTakesDialog : public DialogFrame {
    Q_OBJECT
public:
    /// kInUse: the calibration in use instead of what the takes hold. kTheirOwn: only for takes that hold
    /// none.
    enum class With { kInUse, kTheirOwn };
    /// All takes of the current performer are ticked. `actor`: the performer as the calibration measured it,
    /// for takes of the same one.
    ProcessTakesDialog(Studio& studio, std::optional<Actor> actor, QWidget* parent = nullptr,
                       With with = With::kInUse);

    /// Names, in the order of the session.
    QStringList ticked() const;
    void tick(const QStringList& names);
    /// A job for each; what it finds is said as for a single take.
    void process();

private:
    void refresh();
    bool isOfPerformer(const SessionTake& take) const;

    Studio& studio_;
    std::optional<Actor> actor_;
    const With with_;
    QListWidget* takes_;
};

}  // namespace noctule::ui
