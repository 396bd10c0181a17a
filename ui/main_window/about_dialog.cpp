// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/about_dialog.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/main_window/licences.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

QWidget* licenceList() {
    auto* list = new QWidget;
    auto* column = makeColumn(list, {0, 0, 8, 0}, 8);
    for (const LinkedWork& work : linkedWorks()) {
        auto* words = new QWidget;
        auto* lines = makeColumn(words, {}, 2);
        lines->addWidget(new Label(QStringLiteral("%1 %2").arg(work.name, work.version).trimmed(),
                                   TextRole::kBody, Ink::kValue, true));
        lines->addWidget(
            (new Label(AboutDialog::tr("%1. %2. %3", "what a library is for, its licence, its address")
                           .arg(work.what_for, work.licence, work.address),
                       TextRole::kSecondary, Ink::kLabel))
                ->wrapped()
                ->selectable());
        column->addWidget(words);
    }
    column->addStretch();
    return list;
}

}  // namespace

AboutDialog::AboutDialog(const std::string& software, QWidget* parent) : QDialog(parent) {
    const QString version = QString::fromStdString(software).section(' ', 1);
    setWindowTitle(tr("About Noctule"));
    auto* column = makeColumn(this, {24, 20, 24, 20}, 12);
    column->addWidget(new Label(tr("Noctule %1").arg(version), TextRole::kPage, Ink::kValue, true));
    column->addWidget(
        (new Label(tr("Motion capture by sound and inertia. After Vlasic et al., Practical motion "
                      "capture in everyday surroundings, 2007."),
                   TextRole::kBody, Ink::kLabel))
            ->wrapped());
    column->addWidget(
        (new Label(tr("Noctule itself is free under the Apache License 2.0. It is linked with Qt and Qwt "
                      "under the LGPL; whoever passes the program on passes on their terms too: both "
                      "libraries may be replaced by other versions of them. Noctule links no library under "
                      "the GPL itself; OpenCV writes films with ffmpeg, which Debian builds with parts under "
                      "the GPL: passed on together, the whole is under the terms of the GPL."),
                   TextRole::kBody, Ink::kLabel))
            ->wrapped());
    column->addWidget(new SectionHeader(tr("What it is made of")));
    column->addWidget(new ScrollArea(licenceList()), 1);
    auto* row = addRow(column);
    Button* copy = makeButton(ButtonKind::kText, tr("Copy all"), "copy");
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(copy);
    row->addStretch();
    row->addWidget(close);
    connect(copy, &QPushButton::clicked, this, [software = QString::fromStdString(software)] {
        QGuiApplication::clipboard()->setText(licencesAsText(software));
    });
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    placeDialog(*this, {Theme::get().px(560), Theme::get().px(600)});
}

}  // namespace noctule::ui
