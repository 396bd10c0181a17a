// SPDX-License-Identifier: Apache-2.0
#include "ui/models/take_changes.h"

#include <QFileInfo>
#include <QUndoCommand>

#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

TakeChange reversed(const TakeChange& change) {
    return std::visit([](const auto& one) { return TakeChange(one.reversed()); }, change);
}

Status write(const std::string& path, const TakeChange& change, const JobContext& job) {
    if (const auto* marker = std::get_if<MarkerChange>(&change))
        return changeMarker(path, *marker, job);
    if (const auto* room = std::get_if<RoomChange>(&change)) {
        std::vector<std::string> lacking;  // anchors that could not be placed, as the survey has said
        return placeAnchors(path, room->after, room->created_utc, lacking);
    }
    if (const auto* attached = std::get_if<AttachedChange>(&change))
        return putBackAttached(path, *attached->after, job);
    return changeContacts(path, std::get<ContactsChange>(change), job);
}

JobTitle titleOf(const TakeChange& change, const QString& take) {
    if (std::holds_alternative<MarkerChange>(change))
        return {TakeChanges::tr("Writing a marker into %1"), take};
    if (std::holds_alternative<RoomChange>(change))
        return {TakeChanges::tr("Writing the places of anchors into %1"), take};
    return {std::holds_alternative<AttachedChange>(change)
                ? TakeChanges::tr("Writing the attached motion into %1")
                : TakeChanges::tr("Writing contacts into %1"),
            take};
}

}  // namespace

/// Remembers the change and the file, also when the file gets another name.
class TakeCommand : public QObject, public QUndoCommand {
public:
    TakeCommand(TakeChanges& changes, const QString& what, const QString& path, const TakeChange& change,
                TakeChanges::Written written)
        : QUndoCommand(what),
          changes_(&changes),
          path_(path),
          change_(change),
          step_(std::make_shared<TakeChanges::Written>(written)) {
        connect(&changes.session_, &SessionModel::takeRenamed, this,
                [this](const QString& before, const QString& now) {
                    if (path_ == before)
                        path_ = now;
                });
    }

    void redo() override { order({path_, change_, true, step_}); }
    /// A step that never came to the take leaves the stack.
    void undo() override {
        setObsolete(*step_ == TakeChanges::Written::kNever);
        if (!isObsolete())
            order({path_, reversed(change_), false, step_});
    }

private:
    void order(const TakeChanges::Order& order) {
        if (changes_)
            changes_->enqueue(order);
    }

    QPointer<TakeChanges> changes_;
    QString path_;
    TakeChange change_;
    std::shared_ptr<TakeChanges::Written> step_;
};

TakeChanges::TakeChanges(Jobs& jobs, SessionModel& session, TakeDocument& take, QObject* parent)
    : QObject(parent), jobs_(jobs), session_(session), take_(take) {}

void TakeChanges::push(const QString& what, const TakeChange& change) {
    if (session_.isReadOnly() && session_.currentTake() >= 0) {
        emit failed(tr("The session can be read but not written"),
                    tr("Copy its folder to where you may write, and open it there."));
        return;
    }
    session_.undoStack().push(new TakeCommand(*this, what, take_.path(), change, Written::kNotYet));
}

void TakeChanges::pushWritten(const QString& what, const QString& take_path, const TakeChange& change) {
    session_.undoStack().push(new TakeCommand(*this, what, take_path, change, Written::kDone));
}

void TakeChanges::enqueue(Order order) {
    order.kept = session_.keepInPlace(order.path);
    orders_.push_back(std::move(order));
    const Order latest = orders_.back();
    if (orders_.size() == 1)
        startNext();
    emit ordered(latest.path, latest.change);
}

void TakeChanges::startNext() {
    while (!orders_.empty() && !orders_.front().isNeeded())
        orders_.pop_front();
    if (orders_.empty())
        return;
    const Order& order = orders_.front();
    jobs_.start<Done>(
        titleOf(order.change, QFileInfo(order.path).completeBaseName()),
        [path = order.path.toStdString(), change = order.change](const JobContext& job) {
            return write(path, change, job);
        },
        [changes = QPointer(this), order](const Status& status) -> QString {
            if (changes)
                changes->finish(order, status);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void TakeChanges::finish(const Order& order, const Status& status) {
    orders_.pop_front();
    if (!status) {
        if (*order.step == Written::kNotYet)
            *order.step = Written::kNever;
        if (status.error().is_damage)
            take_.noteDamage(order.path, status.error());
        else
            emit failed(coreWords(status.error().message), coreWords(status.error().remedy));
    } else {
        *order.step = order.to_do ? Written::kDone : Written::kUndone;
        emit written(order.path, order.change);
        if (take_.path() == order.path)
            take_.reload(false);
    }
    startNext();
}

}  // namespace noctule::ui
