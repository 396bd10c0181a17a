// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/help_window.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QTextBlock>
#include <QTextList>
#include <QTextTable>
#include <QVBoxLayout>

#include "ui/style/resources.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

/// Pictures never wider than the page.
class DocumentBrowser : public QTextBrowser {
protected:
    QVariant loadResource(int type, const QUrl& name) override {
        const QVariant resource = QTextBrowser::loadResource(type, name);
        if (type != QTextDocument::ImageResource)
            return resource;
        QImage picture = resource.type() == QVariant::ByteArray ? QImage::fromData(resource.toByteArray())
                                                                : resource.value<QImage>();
        const int room = viewport()->width() - Theme::get().px(24);
        if (picture.width() > room && room > 0)
            picture = picture.scaledToWidth(room, Qt::SmoothTransformation);
        return picture;
    }
};

/// What Markdown leaves open: room between paragraphs, lines around cells.
void layOut(QTextDocument& document) {
    const Theme& theme = Theme::get();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        const QTextBlockFormat is = block.blockFormat();
        if (cursor.currentTable() || block.textList() || is.headingLevel() > 0 ||
            is.hasProperty(QTextFormat::BlockCodeFence) || is.hasProperty(QTextFormat::BlockCodeLanguage))
            continue;
        QTextBlockFormat format;
        format.setTopMargin(theme.px(4));
        format.setBottomMargin(theme.px(8));
        cursor.mergeBlockFormat(format);
    }
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorder(1);
            format.setBorderCollapse(true);
            format.setBorderBrush(theme.tokens().edge);
            format.setCellPadding(theme.px(6));
            format.setCellSpacing(0);
            format.setTopMargin(theme.px(4));
            format.setBottomMargin(theme.px(12));
            table->setFormat(format);
        }
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent), contents_(new QListWidget), page_(new DocumentBrowser) {
    setWindowTitle(tr("Noctule’s documents"));
    auto* outer = makeColumn(this, {16, 16, 16, 16}, 12);
    auto* columns = addRow(outer, 12);
    outer->setStretch(0, 1);
    keepSize(*contents_, 200, 0);
    contents_->setAccessibleName(tr("Documents"));
    columns->addWidget(contents_);
    columns->addWidget(page_, 1);
    page_->setOpenLinks(false);
    page_->setAccessibleName(tr("The document"));
    const std::pair<const char*, QString> documents[] = {{"tutorial", tr("Tutorial")},
                                                         {"guide", tr("Guide")},
                                                         {"how_it_works", tr("How it works")},
                                                         {"orientation", tr("Orientation")},
                                                         {"glossary", tr("Glossary")},
                                                         {"robots", tr("Robots")},
                                                         {"formats", tr("Files")},
                                                         {"architecture", tr("Architecture")},
                                                         {"security", tr("Security")}};
    for (const auto& [name, title] : documents) {
        auto* item = new QListWidgetItem(title, contents_);
        item->setData(Qt::UserRole, QString(name));
    }
    connect(contents_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item)
            follow(QUrl(item->data(Qt::UserRole).toString() + ".md"));
    });
    connect(page_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
    const auto lay_out = [this] { layOut(*page_->document()); };
    connect(page_, &QTextBrowser::sourceChanged, this, lay_out);
    connect(&Theme::get(), &Theme::changed, this, lay_out);
    auto* row = addRow(outer, 8);
    Button* back = makeButton(ButtonKind::kText, tr("Back"), "prev");
    row->addWidget(back);
    if (QLocale().language() != QLocale::English)
        row->addWidget(new Label(tr("The documents are in English."), TextRole::kBody, Ink::kLabel));
    row->addStretch();
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(back, &QPushButton::clicked, page_, &QTextBrowser::backward);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    placeDialog(*this, {Theme::get().px(1000), Theme::get().px(720)});
}

void HelpWindow::showDocument(const QString& name) {
    for (int row = 0; row < contents_->count(); ++row)
        if (contents_->item(row)->data(Qt::UserRole).toString() == name)
            contents_->setCurrentRow(row);
    show();
}

void HelpWindow::follow(const QUrl& link) {
    const QString file = link.path().section('/', -1);
    if (!link.scheme().isEmpty() && link.scheme() != "qrc") {
        QDesktopServices::openUrl(link);
    } else if (file.isEmpty()) {
        page_->scrollToAnchor(link.fragment());
    } else if (file.endsWith(".md") && QFile::exists(resourcePath("docs/" + file))) {
        page_->setSource(QUrl("qrc" + resourcePath("docs/" + file)), QTextDocument::MarkdownResource);
        const QSignalBlocker quiet(contents_);
        for (int row = 0; row < contents_->count(); ++row)
            if (contents_->item(row)->data(Qt::UserRole).toString() + ".md" == file)
                contents_->setCurrentRow(row);
    }
}

}  // namespace noctule::ui
