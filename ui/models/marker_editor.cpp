// SPDX-License-Identifier: Apache-2.0
#include "ui/models/marker_editor.h"

#include <QFileInfo>
#include <QUndoCommand>

namespace noctule::ui {

/// Remembers the change and the file, also when the file gets another name.
class MarkerCommand : public QObject, public QUndoCommand {
public:
    MarkerCommand(MarkerEditor& editor, const QString& what, const MarkerChange& change)
        : QUndoCommand(what), editor_(&editor), path_(editor.take_.path()), change_(change) {
        connect(&editor.session_, &SessionModel::takeRenamed, this,
                [this](const QString& before, const QString& now) {
                    if (path_ == before)
                        path_ = now;
                });
    }

    void redo() override { write({path_, change_, true, step_}); }
    /// A step that never came to the take leaves the stack.
    void undo() override {
        setObsolete(*step_ == MarkerEditor::Written::kNever);
        if (!isObsolete())
            write({path_, change_.reversed(), false, step_});
    }

private:
    void write(const MarkerEditor::Order& order) {
        if (editor_)
            editor_->enqueue(order);
    }

    QPointer<MarkerEditor> editor_;
    QString path_;
    MarkerChange change_;
    std::shared_ptr<MarkerEditor::Written> step_ =
        std::make_shared<MarkerEditor::Written>(MarkerEditor::Written::kNotYet);
};

MarkerEditor::MarkerEditor(Jobs& jobs, SessionModel& session, TakeDocument& take, QObject* parent)
    : QObject(parent), jobs_(jobs), session_(session), take_(take) {}

const ReviewMarker* MarkerEditor::editable(int marker) const {
    const auto overview = take_.overview();
    if (!overview || marker < 0 || marker >= static_cast<int>(overview->markers.size()))
        return nullptr;
    const ReviewMarker& found = overview->markers[static_cast<size_t>(marker)];
    return isEditable(found) ? &found : nullptr;
}

QString MarkerEditor::freeLabel() const {
    const auto overview = take_.overview();
    const auto is_taken = [&](const std::string& label) {
        for (const ReviewMarker& marker : overview->markers)
            if (marker.label == label)
                return true;
        for (const Order& order : orders_)
            if (order.path == take_.path() && order.change.after && order.change.after->label == label)
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
    push(tr("Set %1").arg(label), {.after = UserMarker{t_s, label.toStdString()}});
}

void MarkerEditor::rename(int marker, const QString& label) {
    const ReviewMarker* found = editable(marker);
    const std::string wanted = label.trimmed().toStdString();
    if (found && wanted != found->label)
        push(tr("Name the marker %1").arg(label.trimmed()),
             {UserMarker{found->t_s, found->label}, UserMarker{found->t_s, wanted}});
}

void MarkerEditor::remove(int marker) {
    if (const ReviewMarker* found = editable(marker))
        push(tr("Delete the marker %1").arg(QString::fromStdString(found->label)),
             {.before = UserMarker{found->t_s, found->label}});
}

void MarkerEditor::push(const QString& what, const MarkerChange& change) {
    session_.undoStack().push(new MarkerCommand(*this, what, change));
}

void MarkerEditor::enqueue(Order order) {
    order.kept = session_.keepInPlace(order.path);
    orders_.push_back(std::move(order));
    if (orders_.size() == 1)
        startNext();
}

void MarkerEditor::startNext() {
    while (!orders_.empty() && !orders_.front().isNeeded())
        orders_.pop_front();
    if (orders_.empty())
        return;
    const Order& order = orders_.front();
    jobs_.start<Done>(
        tr("Writing a marker into %1").arg(QFileInfo(order.path).completeBaseName()),
        [path = order.path.toStdString(), change = order.change](const JobContext& job) {
            return changeMarker(path, change, job);
        },
        [editor = QPointer(this), order](const Status& written) -> QString {
            if (editor)
                editor->finish(order, written);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void MarkerEditor::finish(const Order& order, const Status& status) {
    orders_.pop_front();
    if (!status) {
        if (*order.step == Written::kNotYet)
            *order.step = Written::kNever;
        emit failed(QString::fromStdString(status.error().message),
                    QString::fromStdString(status.error().remedy));
    } else {
        *order.step = order.to_do ? Written::kDone : Written::kUndone;
        emit written(order.path, order.change);
        if (take_.path() == order.path)
            take_.reload(false);
    }
    startNext();
}

}  // namespace noctule::ui
