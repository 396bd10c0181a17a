// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/shot_list_dialog.h"

#include <QBoxLayout>
#include <QPlainTextEdit>

#include "core/session/shot_list.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

ShotListDialog::ShotListDialog(const QString& text, bool pasted, QWidget* parent)
    : DialogFrame(pasted ? tr("Paste a shot list") : tr("Edit the shot list"),
                  tr("One shot a line, in the order in which they are recorded. With \"x3\" at its end three "
                     "takes of it are wanted; its first word names them."),
                  tr("Use this list"), parent),
      editor(new QPlainTextEdit),
      counted_(new Label) {
    counted_->setRole(TextRole::kSecondary);
    counted_->setInk(Ink::kHint);
    editor->setPlainText(text);
    editor->setPlaceholderText(tr("Walk, straight line x2\nReach, high and low\nTurn, both ways x3"));
    editor->setAccessibleName(tr("Shot list"));
    editor->setTabChangesFocus(true);
    keepSize(*editor, 420, 200);
    content()->addWidget(editor);
    content()->addWidget(counted_);
    connect(editor, &QPlainTextEdit::textChanged, this, &ShotListDialog::count);
    count();
}

std::vector<Shot> ShotListDialog::shots() const {
    return shotsFromText(editor->toPlainText().toStdString());
}

void ShotListDialog::count() {
    Session list;
    list.shots = shots();
    counted_->setText(tr("%n shot(s)", nullptr, static_cast<int>(list.shots.size())) + QStringLiteral(", ") +
                      tr("%n take(s)", nullptr, progressOf(list).wanted));
}

}  // namespace noctule::ui
