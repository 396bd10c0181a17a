// SPDX-License-Identifier: Apache-2.0
#include "ui/models/marker_editor.h"

namespace noctule::ui {

MarkerEditor::MarkerEditor(TakeChanges& changes, TakeDocument& take, QObject* parent)
    : QObject(parent), changes_(changes), take_(take) {}

const ReviewMarker* MarkerEditor::editable(int marker) const {
    const auto overview = take_.overview();
    if (!overview || marker < 0 || marker >= static_cast<int>(overview->markers.size()))
        return nullptr;
    const ReviewMarker& found = overview->markers[static_cast<size_t>(marker)];
    return isEditable(found) ? &found : nullptr;
}

QString MarkerEditor::freeLabel() const {
    const auto overview = take_.overview();
    const auto waiting = changes_.waiting<MarkerChange>(take_.path());
    const auto is_taken = [&](const std::string& label) {
        for (const ReviewMarker& marker : overview->markers)
            if (marker.label == label)
                return true;
        for (const MarkerChange& change : waiting)
            if (change.after && change.after->label == label)
                return true;
        return false;
    };
    for (int number = 1;; ++number) {
        QString label = tr("Marker %1", "name of a marker, a number").arg(number);
        if (!is_taken(label.toStdString()))
            return label;
    }
}

void MarkerEditor::add(double t_s) {
    if (!take_.isOpen())
        return;
    const QString label = freeLabel();
    changes_.push(tr("Set %1").arg(label), MarkerChange{.after = UserMarker{t_s, label.toStdString()}});
}

void MarkerEditor::rename(int marker, const QString& label) {
    const ReviewMarker* found = editable(marker);
    const std::string wanted = label.trimmed().toStdString();
    if (found && wanted != found->label)
        changes_.push(tr("Name the marker %1").arg(label.trimmed()),
                      MarkerChange{UserMarker{found->t_s, found->label}, UserMarker{found->t_s, wanted}});
}

void MarkerEditor::remove(int marker) {
    if (const ReviewMarker* found = editable(marker))
        changes_.push(tr("Delete the marker %1").arg(QString::fromStdString(found->label)),
                      MarkerChange{.before = UserMarker{found->t_s, found->label}});
}

}  // namespace noctule::ui
