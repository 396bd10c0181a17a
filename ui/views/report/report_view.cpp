// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_view.h"

#include <QComboBox>
#include <QFileInfo>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <cmath>

#include "core/job/atomic_file.h"
#include "core/report/joints_csv.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/open_take.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/search_field.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {

namespace {
constexpr int kContents = 176, kRoomForContents = 720;  // pixels at 100 percent
constexpr int kLettersOfPart = 12;
}  // namespace

ReportView::ReportView(ReviewContext& review, FullReport& report, QWidget* parent)
    : QWidget(parent),
      review_(review),
      report_(report),
      title_(new ElidedLabel({}, TextRole::kSection, Ink::kValue, true)),
      zoom_label_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      search_(new SearchField(tr("Find", "in the report"))),
      contents_(new QListWidget),
      page_(new ReportBrowser),
      parts_(new QComboBox),
      save_(makeButton(ButtonKind::kOutlined, tr("Save"), "disk")),
      zoom_(makeZoom()) {
    auto* column = makeColumn(this);
    column->addWidget(makeHead());
    column->addWidget(new Divider);
    auto* body = new QWidget;
    auto* row = makeRow(body);
    keepSize(*contents_, kContents, 0);
    contents_->setFrameShape(QFrame::NoFrame);
    contents_->setAccessibleName(tr("Parts of the report"));
    row->addWidget(contents_);
    row->addWidget(beside_ = new Divider(Qt::Vertical));
    row->addWidget(page_, 1);
    column->addWidget(body, 1);
    connect(contents_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item)
            page_->scrollToAnchor(item->data(Qt::UserRole).toString());
    });
    connect(parts_, qOverload<int>(&QComboBox::activated), this,
            [this](int part) { contents_->setCurrentRow(part); });
    connect(contents_, &QListWidget::currentRowChanged, parts_, &QComboBox::setCurrentIndex);
    connect(&Theme::get(), &Theme::changed, this, &ReportView::fold);
    connect(&report, &FullReport::changed, this, &ReportView::refresh);
    connect(&review.take(), &TakeDocument::opened, this, &ReportView::refresh);
    connect(page_, &ReportBrowser::zoomChanged, this, &ReportView::refresh);
    connect(search_, &SearchField::searched, this, &ReportView::find);
    connect(search_, &QLineEdit::returnPressed, this, [this] { find(search_->text()); });
    refresh();
}

QWidget* ReportView::makeHead() {
    auto* head = new QWidget;
    auto* column = makeColumn(head, {12, 8, 16, 8}, 8);
    first_row_ = addRow(column, 8);
    second_row_ = addRow(column, 8);
    second_ = second_row_->parentWidget();
    auto* back = makeButton(ButtonKind::kText, tr("Back to the take"), "prev", QKeySequence(Qt::Key_Escape));
    search_->setAccessibleName(tr("Find in the report"));
    keepMinimumWidth(*search_, 112);
    keepMaximumWidth(*search_, 200);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* formats = new QMenu(save_);
    formats->addAction(tr("As HTML"), this, &ReportView::saveHtml);
    formats->addAction(tr("As PDF"), this, &ReportView::savePdf);
    formats->addAction(tr("Joints as CSV"), this, [this] {
        saveJoints(
            FileChoice{"reports", tr("Save the report"), tr("Tables (*.csv)"), openTakeName(review_) + ".csv"}
                .toSave(this));
    });
    connect(save_, &QPushButton::clicked, this,
            [this, formats] { formats->exec(save_->mapToGlobal(QPoint(0, save_->height()))); });
    first_row_->addWidget(back);
    first_row_->addWidget(title_, 3);
    first_row_->addWidget(search_, 1);
    first_row_->addWidget(zoom_);
    first_row_->addWidget(save_);
    parts_->setModel(contents_->model());
    parts_->setAccessibleName(tr("Parts of the report"));
    parts_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parts_->setMinimumContentsLength(kLettersOfPart);
    second_row_->addWidget(parts_, 2);
    second_->hide();
    connect(back, &QPushButton::clicked, this, &ReportView::closed);
    return head;
}

QWidget* ReportView::makeZoom() {
    auto* zoom = new QWidget;
    auto* row = makeRow(zoom, {}, 8);
    auto* smaller = new ToolButton("minus", tr("Smaller"), QKeySequence::ZoomOut);
    auto* larger = new ToolButton("new", tr("Larger"), QKeySequence::ZoomIn);
    row->addWidget(smaller);
    row->addWidget(zoom_label_);
    row->addWidget(larger);
    connect(smaller, &QToolButton::clicked, this, [this] { page_->setZoom(page_->zoom() / 1.1); });
    connect(larger, &QToolButton::clicked, this, [this] { page_->setZoom(page_->zoom() * 1.1); });
    return zoom;
}

void ReportView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fold();
}

void ReportView::fold() {
    const bool folded = width() < Theme::get().px(kRoomForContents);
    if (folded == second_->isVisibleTo(this))
        return;
    contents_->setVisible(!folded);
    beside_->setVisible(!folded);
    QBoxLayout* row = folded ? second_row_ : first_row_;
    const int place = folded ? 1 : 2;  // after the parts or the title
    row->insertWidget(place, search_, 1);
    row->insertWidget(place + 1, zoom_);
    second_->setVisible(folded);
}

void ReportView::enter() {
    report_.need();
    refresh();
    page_->setFocus();
}

void ReportView::refresh() {
    zoom_label_->setText(percentText(page_->zoom()));
    title_->setText(tr("Report of %1").arg(openTakeName(review_)));
    const auto made = report_.data();
    const QString waiting = made ? QString() : tr("The report is being made.");
    save_->setDisabledBecause(waiting);
    if (!isVisible() || shown_ == made)
        return;
    shown_ = made;
    const QSignalBlocker quiet(contents_);
    contents_->clear();
    if (!made) {
        page_->setParts({});
        page_->setPlainText(waiting);
        return;
    }
    std::vector<ReportPart> parts = reportParts(*made);
    for (ReportPart& part : parts) {
        part.html = coreMarkup(part.html);
        auto* item = new QListWidgetItem(coreWords(part.title), contents_);
        item->setData(Qt::UserRole, QString::fromStdString(part.id));
    }
    contents_->setCurrentRow(0);
    parts_->setCurrentIndex(0);
    page_->setDocumentTitle(title_->text());
    page_->setParts(std::move(parts));
}

void ReportView::saveHtml() {
    const QString path = FileChoice{"reports", tr("Save the report"), tr("Web pages (*.html)"),
                                    openTakeName(review_) + ".html"}
                             .toSave(this);
    save(path, [](const ReportData& data) { return coreMarkup(htmlReport(data)); });
}

void ReportView::saveJoints(const QString& path) {
    save(path, [](const ReportData& data) { return jointsCsv({{data.take.performer, data}}); });
}

void ReportView::save(const QString& path, std::function<std::string(const ReportData&)> written) {
    if (path.isEmpty() || !report_.data())
        return;
    review_.shared().jobs().start<Done>(
        {tr("Saving %1"), QFileInfo(path).fileName()},
        [data = report_.data(), path, written = std::move(written)](const JobContext&) -> Status {
            return writeFileAtomically(path.toStdString(), written(*data), true);
        },
        [path](Status saved) { return saved ? tr("%1 is written.").arg(path) : QString(); });
}

void ReportView::savePdf() {
    const QString path = FileChoice{"reports", tr("Save the report"), tr("PDF documents (*.pdf)"),
                                    openTakeName(review_) + ".pdf"}
                             .toSave(this);
    if (path.isEmpty())
        return;
    if (page_->savePdf(path))
        review_.shared().sayOfFile(tr("%1 is written.").arg(path));
    else
        emit review_.shared().failed(tr("%1 could not be written.").arg(path),
                                     tr("Choose another folder or free some space."), About::kFile);
}

void ReportView::find(const QString& text) {
    if (text.isEmpty() || page_->find(text))
        return;
    page_->moveCursor(QTextCursor::Start);  // once around
    page_->find(text);
}

void ReportView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        emit closed();
    else if (event->matches(QKeySequence::ZoomIn))
        page_->setZoom(page_->zoom() * 1.1);
    else if (event->matches(QKeySequence::ZoomOut))
        page_->setZoom(page_->zoom() / 1.1);
    else if (event->matches(QKeySequence::Find))
        search_->setFocus();
    else
        QWidget::keyPressEvent(event);
}

}  // namespace noctule::ui
