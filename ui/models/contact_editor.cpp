// SPDX-License-Identifier: Apache-2.0
#include "ui/models/contact_editor.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {

ContactEditor::ContactEditor(TakeChanges& changes, TakeDocument& take, TimeCursor& time, QObject* parent)
    : QObject(parent), changes_(changes), take_(take), time_(time) {
    connect(&changes, &TakeChanges::ordered, this, [this](const QString& path, const TakeChange& ordered) {
        const auto* contacts = std::get_if<ContactsChange>(&ordered);
        if (!contacts || path != take_.path() || contacts->suit != take_.view().suit)
            return;
        intended_ =
            contacts->after ? std::make_shared<const std::vector<FootContacts>>(*contacts->after) : Feet();
        intended_path_ = path;
        is_read_anew_ = false;
        emit changed();
    });
    connect(&changes, &TakeChanges::failed, this, [this] {
        if (intended_ && !anyWaits()) {
            intended_.reset();
            emit changed();
        }
    });
    connect(&take, &TakeDocument::opened, this, [this] { is_read_anew_ = !anyWaits(); });
    for (const auto signal :
         {&TakeDocument::opened, &TakeDocument::runsChanged, &TakeDocument::motionChanged})
        connect(&take, signal, this, &ContactEditor::settle);
}

/// What the document has read holds again.
void ContactEditor::settle() {
    if (intended_ && (intended_path_ != take_.path() || (is_read_anew_ && take_.contacts())))
        intended_.reset();
    emit changed();
}

std::shared_ptr<const std::vector<FootContacts>> ContactEditor::contacts() const {
    return intended_ ? *intended_ : take_.isOpen() ? take_.contacts() : nullptr;
}

bool ContactEditor::areEdited() const {
    return intended_ ? *intended_ != nullptr : take_.isOpen() && take_.overview()->contacts_edited;
}

double ContactEditor::snapped(double t_s) const {
    return time_.frameAt(t_s);
}

FootContact ContactEditor::fitting(FootContact wanted) const {
    const auto [from_s, to_s] = std::minmax(wanted.from_s, wanted.to_s);
    wanted = {snapped(from_s), snapped(to_s), 0, true};
    if (wanted.to_s - wanted.from_s < 0.5 * time_.frameStep()) {
        wanted.to_s = snapped(wanted.from_s + time_.frameStep());
        wanted.from_s = std::min(wanted.from_s, snapped(wanted.to_s - time_.frameStep()));
    }
    return wanted;
}

ContactPlace ContactEditor::put(ContactPlace place, const FootContact& wanted) {
    const auto feet = contacts();
    const FootContact fitted = fitting(wanted);
    if (!feet || fitted.to_s <= fitted.from_s)
        return place;
    const FootContact* before = findContact(*feet, place);
    if (before && before->from_s == fitted.from_s && before->to_s == fitted.to_s)
        return place;
    const QString what = before ? tr("Move a contact") : tr("Set a contact");
    auto after = withContact(*feet, place, fitted);
    push(what, std::move(after));
    return place;
}

void ContactEditor::remove(const ContactPlace& place) {
    if (const auto feet = contacts(); feet && findContact(*feet, place))
        push(tr("Delete a contact"), withoutContact(*feet, place));
}

void ContactEditor::restoreFound() {
    if (areEdited() && contacts())
        push(tr("Back to the contacts that were found"), std::nullopt);
}

void ContactEditor::push(const QString& what, std::optional<std::vector<FootContacts>> after) {
    changes_.push(what, ContactsChange{areEdited() ? std::optional(*contacts()) : std::nullopt,
                                       std::move(after), take_.view().suit});
}

}  // namespace noctule::ui
