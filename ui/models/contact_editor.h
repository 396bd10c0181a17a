// SPDX-License-Identifier: Apache-2.0
// When the feet stand in the open take, as the operator sees and sets it. The first change begins with the
// contacts that were found; from then on those of the operator hold for every result, and processing uses
// them. Times snap to the frames of the shown result.
#pragma once

#include "core/motion/contact_edit.h"
#include "ui/models/take_changes.h"

namespace noctule::ui {

class ContactEditor : public QObject {
    Q_OBJECT
public:
    ContactEditor(TakeChanges& changes, TakeDocument& take, TimeCursor& time, QObject* parent = nullptr);

    /// As they will be when all that waits has been written; null while they are not known.
    std::shared_ptr<const std::vector<FootContacts>> contacts() const;
    /// Whether those of an operator hold.
    bool areEdited() const;

    /// The nearest frame.
    double snapped(double t_s) const;
    /// `wanted` with both ends on frames of the take, in order and at least a frame apart.
    FootContact fitting(FootContact wanted) const;

    // Each is one step that can be undone; nothing happens when nothing would change. `put` returns where the
    // contact ended up.
    ContactPlace put(ContactPlace place, const FootContact& wanted);
    void remove(const ContactPlace& place);
    void restoreFound();

signals:
    void changed();

private:
    using Feet = std::shared_ptr<const std::vector<FootContacts>>;
    void push(const QString& what, std::optional<std::vector<FootContacts>> after);
    void settle();
    bool anyWaits() const { return !changes_.waiting<ContactsChange>(take_.path()).empty(); }

    TakeChanges& changes_;
    TakeDocument& take_;
    TimeCursor& time_;
    /// Ahead of what the document has read; holds null while it is left to the results again.
    std::optional<Feet> intended_{};
    QString intended_path_;      ///< of the take that it is about
    bool is_read_anew_ = false;  ///< the document has forgotten what it knew of the contacts
};

}  // namespace noctule::ui
