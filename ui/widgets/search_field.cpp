// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/search_field.h"

#include <QAction>
#include <QKeyEvent>
#include <QToolButton>

#include "ui/style/theme.h"

namespace noctule::ui {

SearchField::SearchField(const QString& placeholder, QWidget* parent) : QLineEdit(parent) {
    setPlaceholderText(placeholder);
    setAccessibleName(placeholder);
    setClearButtonEnabled(true);
    for (auto* clear_button : findChildren<QToolButton*>())
        clear_button->setAccessibleName(tr("Clear"));
    glass_ = addAction(QIcon(), QLineEdit::LeadingPosition);
    glass_->setText(placeholder);
    pause_.setSingleShot(true);
    pause_.setInterval(150);
    connect(this, &QLineEdit::textChanged, &pause_, qOverload<>(&QTimer::start));
    connect(&pause_, &QTimer::timeout, this, [this] { emit searched(text()); });
    connect(&Theme::get(), &Theme::changed, this, &SearchField::restyle);
    restyle();
}

void SearchField::restyle() {
    glass_->setIcon(Theme::get().icon("search", Theme::get().tokens().t3));
}

void SearchField::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || text().isEmpty())
        return QLineEdit::keyPressEvent(event);
    clear();
    pause_.stop();
    emit searched({});
}

}  // namespace noctule::ui
