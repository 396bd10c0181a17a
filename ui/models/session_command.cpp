// SPDX-License-Identifier: Apache-2.0
#include "ui/models/session_command.h"

namespace noctule::ui {
namespace {

constexpr int kMergeable = 1;
constexpr qint64 kQuickSuccession_ms = 5000;

}  // namespace

SessionCommand::SessionCommand(SessionModel& model, const QString& what, SessionModel::Step redo,
                               SessionModel::Step undo, const QString& merge_key)
    : QUndoCommand(what),
      model_(model),
      redo_(std::move(redo)),
      undo_(std::move(undo)),
      merge_key_(merge_key) {
    since_last_.start();
}

void SessionCommand::redo() {
    take(redo_, true);
}

void SessionCommand::undo() {
    take(undo_, false);
}

void SessionCommand::take(const SessionModel::Step& step, bool done) {
    if (is_done_ == done)
        return;
    if (model_.apply(step))
        is_done_ = done;
    else
        model_.undo_.refuse();
}

int SessionCommand::id() const {
    return merge_key_.isEmpty() ? -1 : kMergeable;
}

bool SessionCommand::mergeWith(const QUndoCommand* later) {
    const auto* other = static_cast<const SessionCommand*>(later);
    if (other->merge_key_ != merge_key_ || since_last_.elapsed() > kQuickSuccession_ms)
        return false;
    redo_ = other->redo_;
    setText(other->text());
    since_last_.restart();
    return true;
}

}  // namespace noctule::ui
