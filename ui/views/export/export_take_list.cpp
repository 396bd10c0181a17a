// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_take_list.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QPointer>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/review_words.h"
#include "ui/views/take_list_model.h"

namespace noctule::ui {
namespace {

constexpr int kTakeName = Qt::UserRole, kRowHeight = 28, kFewestRows = 2, kMostTakeRows = 6, kResults = 280;

}  // namespace

/// Of those whose files were written since they were looked at.
Result<ExportTakeList::ResultsOfTakes> ExportTakeList::newResults(
    const std::vector<std::pair<QString, std::string>>& takes, const ResultsOfTakes& known,
    const JobContext& job) {
    ResultsOfTakes results;
    for (const auto& [name, path] : takes) {
        if (job.cancelled())
            return JobContext::cancelledError();
        std::error_code failed;
        const auto written = std::filesystem::last_write_time(path, failed);
        const auto found = known.find(name);
        if (found != known.end() && found->second.written == written)
            continue;
        if (auto overview = overviewTake(path, {nullptr, job.cancel}))
            results[name] = {std::move(overview->runs), written};
    }
    return results;
}

ExportTakeList::ExportTakeList(ReviewContext& review, QWidget* parent)
    : QTreeWidget(parent), review_(review) {
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setEditTriggers(NoEditTriggers);
    setAccessibleName(tr("Takes to export"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(0);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::Fixed);
    setColumnHidden(1, true);
    connect(this, &QTreeWidget::itemChanged, this, &ExportTakeList::changed);
    connect(&review.shared().session(), &SessionModel::opened, this, [this] {
        results_.clear();
        chosen_.clear();
        readTakes();
        readResults();
    });
    connect(&review.shared().session(), &SessionModel::changed, this, [this] {
        readTakes();
        readResults();
    });
    connect(&review.shared().session(), &SessionModel::takeRenamed, this, &ExportTakeList::followRename);
    connect(&review.take(), &TakeDocument::runsChanged, this, &ExportTakeList::readResults);
    connect(&Theme::get(), &Theme::changed, this, &ExportTakeList::readTakes);
    readTakes();
}

void ExportTakeList::readTakes() {
    const QStringList names = ticked();
    {
        const QSignalBlocker quiet(this);
        clear();
        if (review_.shared().session().isOpen())
            for (const SessionTake& take : review_.shared().session().session().takes)
                addTake(take, names.contains(QString::fromStdString(take.name)));
        setColumnWidth(1, Theme::get().px(kResults));
        fitHeight();
    }
    emit changed();
}

void ExportTakeList::fitHeight() {
    const int rows = std::clamp(topLevelItemCount(), kFewestRows, kMostTakeRows);
    setFixedHeight(rows * Theme::get().px(kRowHeight) + 2 * frameWidth());
}

void ExportTakeList::addTake(const SessionTake& take, bool is_ticked) {
    const QString name = QString::fromStdString(take.name);
    auto* item = new QTreeWidgetItem(this);
    item->setText(0, tr("%1   %2").arg(name, timeText(take.duration_s, 0)));
    item->setData(0, kTakeName, name);
    item->setSizeHint(0, QSize(0, Theme::get().px(kRowHeight)));
    item->setToolTip(0, take.processed ? TakeListModel::stateInWords(take)
                                       : tr("Not processed yet: there is no motion to export."));
    item->setFlags(take.processed ? Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable
                                  : Qt::NoItemFlags);
    item->setCheckState(0, take.processed && is_ticked ? Qt::Checked : Qt::Unchecked);
    if (results_shown_)
        addResults(item);
}

void ExportTakeList::addResults(QTreeWidgetItem* item) {
    const QString take = item->data(0, kTakeName).toString();
    const auto found = results_.find(take);
    if (found == results_.end() || found->second.runs.empty())
        return;
    const std::vector<ReviewRun>& runs = found->second.runs;
    if (runs.size() == 1 || !choosable_) {
        item->setText(1, runs.size() == 1 ? numberedTitle(runs.front())
                                          : tr("%n results", nullptr, static_cast<int>(runs.size())));
        return;
    }
    auto* box = new QComboBox;
    box->setAccessibleName(tr("Result of %1").arg(take));
    for (const ReviewRun& run : runs)
        box->addItem(numberedTitle(run), QString::fromStdString(run.run.name));
    const int chosen = box->findData(chosen_.value(take));
    box->setCurrentIndex(chosen >= 0 ? chosen : box->count() - 1);
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, take, box](int index) {
        chosen_[take] = box->itemData(index).toString();
        emit changed();
    });
    setItemWidget(item, 1, box);
}

QStringList ExportTakeList::resultNames(const QString& take) const {
    QStringList names;
    if (const auto found = results_.find(take); found != results_.end())
        for (const ReviewRun& run : found->second.runs)
            names.append(QString::fromStdString(run.run.name));
    return names.isEmpty() ? QStringList{QString()} : names;
}

void ExportTakeList::setResultsShown(bool shown, bool choosable) {
    if (shown == results_shown_ && choosable == choosable_)
        return;
    results_shown_ = shown;
    choosable_ = choosable;
    setColumnHidden(1, !shown);
    readTakes();
    readResults();
}

void ExportTakeList::readResults() {
    if (!results_shown_ || !review_.shared().session().isOpen())
        return;
    const Session& session = review_.shared().session().session();
    std::vector<std::pair<QString, std::string>> takes;
    for (const SessionTake& take : session.takes)
        if (take.processed)
            takes.emplace_back(QString::fromStdString(take.name), session.pathOf(take).string());
    review_.shared().jobs().start<ResultsOfTakes>(
        tr("Looking at results"),
        [takes = std::move(takes), known = results_](const JobContext& job) {
            return newResults(takes, known, job);
        },
        [self = QPointer(this), ticket = ++ticket_](Result<ResultsOfTakes> results) -> QString {
            if (self && results && self->ticket_ == ticket && !results->empty()) {
                for (auto& [take, fresh] : *results)
                    self->results_[take] = std::move(fresh);
                self->readTakes();
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void ExportTakeList::followRename(const QString& old_path, const QString& new_path) {
    const QString before = QFileInfo(old_path).completeBaseName(),
                  now = QFileInfo(new_path).completeBaseName();
    const QSignalBlocker quiet(this);
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (topLevelItem(row)->data(0, kTakeName) == before)
            topLevelItem(row)->setData(0, kTakeName, now);  // stays ticked
    if (chosen_.contains(before))
        chosen_[now] = chosen_.take(before);
    if (auto moved = results_.extract(before)) {
        moved.key() = now;
        results_.insert(std::move(moved));
    }
}

QStringList ExportTakeList::ticked() const {
    QStringList names;
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (topLevelItem(row)->checkState(0) == Qt::Checked)
            names += topLevelItem(row)->data(0, kTakeName).toString();
    return names;
}

void ExportTakeList::tick(const QStringList& names) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = topLevelItem(row);
        if (item->flags() & Qt::ItemIsEnabled)
            item->setCheckState(
                0, names.contains(item->data(0, kTakeName).toString()) ? Qt::Checked : Qt::Unchecked);
    }
}

QComboBox* ExportTakeList::resultsOf(const QString& take) const {
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (topLevelItem(row)->data(0, kTakeName) == take)
            return qobject_cast<QComboBox*>(itemWidget(topLevelItem(row), 1));
    return nullptr;
}

}  // namespace noctule::ui
