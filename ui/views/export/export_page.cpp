// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_page.h"

#include <QApplication>
#include <QDate>
#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStorageInfo>
#include <QTimer>
#include <iterator>

#include "core/job/atomic_file.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_preset_list.h"
#include "ui/views/export/export_results_panel.h"
#include "ui/views/export/export_take_list.h"
#include "ui/views/job_progress.h"
#include "ui/views/open_take.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/show_folder.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {

namespace {
constexpr int kForm = 372, kBothSides = 780, kWidestPart = 640;
constexpr int kMostNames = 3;
}  // namespace

ExportPage::ExportPage(ReviewContext& review, QWidget* parent)
    : Page(parent),
      review_(review),
      presets_(review.shared().settings()),
      preset_list_(new ExportPresetList(presets_, this)),
      form_(new ExportForm(review)),
      results_panel_(new ExportResultsPanel),
      progress_(new JobProgress),
      state_(new Label({}, TextRole::kBody, Ink::kLabel)),
      again_(makeButton(ButtonKind::kOutlined, tr("Write again"))),
      folder_(makeButton(ButtonKind::kPrimary, tr("Open folder"), "folder")),
      write_(makeButton(ButtonKind::kPrimary, {}, "export", QKeySequence(Qt::Key_Return))) {
    preset_list_->hide();
    setDockTitles(tr("Made for"), {});
    setFocusPolicy(Qt::ClickFocus);
    auto* column = makeColumn(this);
    column->addWidget(makeSides(), 1);
    column->addWidget(new Divider);
    column->addWidget(makeFoot());

    connect(&Theme::get(), &Theme::changed, this, &ExportPage::placeSides);
    connect(preset_list_, &ExportPresetList::chosen, this, [this](const QString& key) {
        presets_.choose(key);
        form_->setSettings(presets_.all()[static_cast<size_t>(presets_.indexOf(key))].settings);
        refresh();
    });
    connect(preset_list_, &ExportPresetList::saveWanted, this, &ExportPage::saveOwnPreset);
    connect(preset_list_, &ExportPresetList::removeWanted, this, &ExportPage::removeOwnPreset);
    connect(form_, &ExportForm::changed, this, [this] {
        presets_.remember(preset_list_->current(), form_->ofPreset());
        presets_.keepName(form_->typedName());
        refresh();
    });
    connect(form_, &ExportForm::tryWanted, this, &ExportPage::tryOneFrame);
    connect(results_panel_, &ExportResultsPanel::saveWanted, this, &ExportPage::saveCheck);
    connect(results_panel_, &ExportResultsPanel::openWanted, this,
            [this](const QString& path) { openFile(review_.shared(), path); });
    connect(&review.take(), &TakeDocument::runsChanged, this, &ExportPage::refresh);
    connect(&review.time(), &TimeCursor::timeChanged, this, &ExportPage::followCursor);
    connect(&review.shared().shownBody(), &ShownBody::changed, this, &ExportPage::refresh);
    connect(&review.shared().session(), &SessionModel::opened, this, [this] {
        results_.reset();
        results_panel_->clear();
        refresh();
    });
    preset_list_->choose(presets_.lastChosen());
    form_->setTypedName(presets_.keptName());
    form_->setSettings(presets_.all()[static_cast<size_t>(presets_.indexOf(presets_.lastChosen()))].settings);
    refresh();
}

QWidget* ExportPage::makeSides() {
    auto* scrolled = new QWidget;
    below_form_ = makeColumn(scrolled);
    auto* form = addRow(below_form_, 0);
    form->addWidget(form_, 1000);
    form->addStretch(1);
    keepMaximumWidth(*form_, kWidestPart);
    takes_side_ = new QWidget;
    auto* column = makeColumn(takes_side_);
    auto* takes = addRow(column, 0);
    takes->addWidget(form_->takesPart(), 1000);
    takes->addStretch(1);
    keepMaximumWidth(*form_->takesPart(), kWidestPart);
    column->addWidget(new Divider);
    column->addWidget(results_panel_, 1);
    auto* sides = new QWidget;
    sides_ = makeRow(sides);
    scroll_ = new ScrollArea(scrolled);
    keepMinimumWidth(*scroll_, kForm);
    sides_->addWidget(scroll_);
    sides_->addWidget(between_ = new Divider(Qt::Vertical));
    sides_->addWidget(takes_side_, 1);
    return sides;
}

QWidget* ExportPage::makeFoot() {
    auto* foot = new QWidget;
    auto* row = makeRow(foot, {20, 10, 16, 10}, 8);
    row->addWidget(state_->wrapped(), 1);
    row->addWidget(progress_, 1);
    again_->setTall(true);
    for (Button* button : {again_, folder_, write_})
        row->addWidget(button);
    connect(again_, &QPushButton::clicked, this, &ExportPage::write);
    connect(write_, &QPushButton::clicked, this, &ExportPage::write);
    connect(folder_, &QPushButton::clicked, this, &ExportPage::openFolder);
    connect(progress_, &JobProgress::ended, this, &ExportPage::refresh);
    return foot;
}

QWidget* ExportPage::leftDock() {
    return preset_list_;
}

void ExportPage::enter() {
    if (form_->takes().isEmpty() && openTakeIndex(review_) >= 0)
        form_->setTakes({openTakeName(review_)});
    refresh();
    write_->setFocus();
}

void ExportPage::choosePreset(const QString& key) {
    preset_list_->choose(key);
}

Result<std::vector<ExportJob>> ExportPage::plan() const {
    if (!review_.shared().session().isOpen())
        return Error{ErrorKind::kUsage, tr("No session is open").toStdString(),
                     tr("Open one first").toStdString()};
    const QStringList chosen = form_->takes();
    if (chosen.isEmpty())
        return Error{ErrorKind::kUsage, tr("No take is chosen").toStdString(),
                     tr("Tick at least one").toStdString()};
    const ExportSettings& settings = form_->settings();
    if (settings.range == ExportRange::kOwn && settings.own_to_s <= settings.own_from_s)
        return Error{ErrorKind::kUsage, tr("The range ends before it begins").toStdString(),
                     tr("Choose a last second after the first").toStdString()};
    std::vector<ExportJob> jobs;
    for (const ExportFormat format : formatsOf(settings)) {
        ExportSettings of_format = settings;
        of_format.format = format;
        if (form_->sendsAllResults() && !settings.name_pattern.contains("{run}"))
            of_format.name_pattern += "_{run}";
        auto more = planOf(of_format, chosen);
        if (!more)
            return more.error();
        std::move(more->begin(), more->end(), std::back_inserter(jobs));
    }
    return jobs;
}

/// In one format. Takes of one file stand together.
Result<std::vector<ExportJob>> ExportPage::planOf(const ExportSettings& settings,
                                                  const QStringList& takes) const {
    const Session& session = review_.shared().session().session();
    const ExportSurroundings surroundings{session, review_.shared().look(),
                                          QDate::currentDate().toString(Qt::ISODate)};
    std::set<std::string> taken;
    std::vector<ExportJob> jobs;
    for (const SessionTake& take : session.takes) {
        const QString name = QString::fromStdString(take.name);
        if (!takes.contains(name))
            continue;
        for (const QString& result : form_->resultsOf(name)) {
            auto job = exportJob(surroundings, take, result, settings, taken);
            if (!job)
                return job.error();
            if (const auto cursor_s = cursorIn(job->request); cursor_s && job->format == ExportFormat::kPng)
                job->request.from_s = job->request.to_s = cursor_s;
            jobs.push_back(std::move(*job));
        }
    }
    return jobs;
}

ExportPage::Asked ExportPage::askedBy(const Plan& plan) const {
    Asked asked{form_->settings(), {}, {}};
    if (asked.settings.range != ExportRange::kOwn)
        asked.settings.own_from_s = asked.settings.own_to_s = 0;  // nobody asks for them
    if (!plan)
        return asked;
    for (const ExportJob& job : *plan) {
        asked.requests.push_back(job.request);
        for (const ExportFormatEntry& entry : exportFormats())
            (asked.requests.back().*entry.path).clear();
        std::error_code failed;
        asked.changed.push_back(std::filesystem::last_write_time(job.request.take_path, failed));
    }
    return asked;
}

bool ExportPage::isWritten(const Asked& asked) const {
    return results_ && results_->written() > 0 && written_ == asked;
}

/// Pictures show the frame at Review's time cursor.
void ExportPage::followCursor() {
    if (isVisible() && formatsOf(form_->settings()).front() == ExportFormat::kPng)
        refresh();
}

void ExportPage::refresh() {
    const auto jobs = plan();
    const Asked asked = askedBy(jobs);
    if (!progress_->isRunning() && started_ != asked)
        progress_->follow(nullptr);  // why other files were not written
    const QString problem = jobs ? QString() : coreWords(jobs.error());
    const bool busy = progress_->isRunning();
    const int files = jobs ? fileCount(*jobs, performers_) : 0;
    write_->setText(tr("Write %n files", nullptr, files));
    const QString why_not = busy ? tr("Files are being written.") : problem;
    for (Button* button : {write_, again_, form_->try_one_frame})
        button->setDisabledBecause(why_not);
    if (jobs) {
        QStringList names = fileNames(*jobs, kMostNames, performers_);
        const int more = files - names.size();
        if (more > 0)
            names += tr("and %n more", nullptr, more);
        form_->setPreview(names.join('\n'), false);
    } else {
        form_->setPreview(problem, true);
    }
    state_->setVisible(!progress_->isVisibleTo(this));
    const QString folder = review_.shared().session().isOpen()
                               ? exportFolder(review_.shared().session().session(), form_->settings())
                               : QString();
    const QStorageInfo disk(QFileInfo::exists(folder) ? folder : QFileInfo(folder).path());
    const QString room = disk.isValid() ? tr("%1 free.").arg(bytesText(disk.bytesAvailable())) : QString();
    const bool is_written = isWritten(asked);
    state_->setText(is_written ? tr("Took %1. %2").arg(secondsText(results_->seconds), room)
                               : tr("Nothing is overwritten: a second export gets _2. %1").arg(room));
    offer(is_written);
}

void ExportPage::offer(bool folder_first) {
    folder_->setVisible(folder_first);
    again_->setVisible(folder_first);
    write_->setVisible(!folder_first);
}

void ExportPage::write() {
    const auto jobs = plan();
    if (!jobs || progress_->isRunning())
        return;
    start(
        tr("Writing %n files", nullptr, fileCount(*jobs, performers_)), askedBy(jobs),
        [jobs = *jobs](const JobContext& job) { return runExport(jobs, job); }, false);
}

void ExportPage::tryOneFrame() {
    const auto jobs = plan();
    if (!jobs || progress_->isRunning())
        return;
    const ExportRequest& first = jobs->front().request;
    const double time_s = cursorIn(first).value_or(first.from_s.value_or(0));
    start(
        {tr("Writing one frame of %1"), jobs->front().take}, askedBy(jobs),
        [job = jobs->front(), time_s](const JobContext& context) {
            return ui::tryOneFrame(job, time_s, context);
        },
        true);
}

/// Where Review stands, if the take is open there.
std::optional<double> ExportPage::cursorIn(const ExportRequest& request) const {
    const bool is_open = review_.take().path().toStdString() == request.take_path;
    return is_open ? std::optional(review_.time().time()) : std::nullopt;
}

void ExportPage::start(const JobTitle& title, const Asked& asked,
                       std::function<Result<ExportResults>(const JobContext&)> work, bool is_trial) {
    Job* job = review_.shared().jobs().start<ExportResults>(
        title, std::move(work), [self = QPointer(this), is_trial](Result<ExportResults> results) -> QString {
            if (self)
                self->present(results, is_trial);
            return results && !is_trial ? tr("%n files written and checked.", nullptr, results->written())
                                        : QString();
        });
    started_ = asked;
    progress_->follow(job);
    if (isAncestorOf(QApplication::focusWidget()))
        setFocus();  // a button that is disabled would give the keyboard to another part of the window
    refresh();
}

void ExportPage::present(const Result<ExportResults>& results, bool is_trial) {
    results_.reset();
    if (results) {
        noteDamage(*results);
        results_panel_->setResults(*results, is_trial);
        QTimer::singleShot(0, this, &ExportPage::scrollToResults);  // laid out by then
        if (!is_trial) {
            results_ = *results;
            written_ = started_;
        }
    }  // else the line beside the buttons says why
    // The job still counts as running here; its end refreshes the buttons.
    emit finished();
}

void ExportPage::noteDamage(const ExportResults& results) {
    std::set<std::string> noted;
    for (const ExportOutcome& outcome : results.outcomes)
        if (!outcome.damaged_take.empty() && noted.insert(outcome.damaged_take).second)
            review_.take().noteDamage(QString::fromStdString(outcome.damaged_take), *outcome.error);
}

void ExportPage::openFolder() {
    if (review_.shared().session().isOpen())
        showFolder(review_.shared(), exportFolder(review_.shared().session().session(), form_->settings()));
}

void ExportPage::saveCheck() {
    if (!results_)
        return;
    const QString folder = exportFolder(review_.shared().session().session(), form_->settings());
    const QString path = FileChoice{.kind = "checks",
                                    .title = tr("Save the check"),
                                    .filter = tr("Text (*.txt)"),
                                    .name = tr("check.txt"),
                                    .at = folder}
                             .toSave(this);
    if (path.isEmpty())
        return;
    const Status saved = writeFileAtomically(path.toStdString(), checkAsText(*results_).toStdString(), true);
    if (saved)
        review_.shared().sayOfFile(tr("%1 is written.").arg(QDir::toNativeSeparators(path)));
    else
        emit review_.shared().failed(coreWords(saved.error().message), coreWords(saved.error().remedy),
                                     About::kFile);
}

void ExportPage::saveOwnPreset() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Save as own preset"), tr("Name"), QLineEdit::Normal,
                                               settingsInWords(form_->settings()), &accepted)
                             .trimmed();
    if (!accepted || name.isEmpty())
        return;
    const QString key = presets_.addOwn(name, form_->settings());
    preset_list_->refresh();
    preset_list_->choose(key);
}

void ExportPage::removeOwnPreset(const QString& key) {
    presets_.removeOwn(key);
    preset_list_->refresh();
    preset_list_->choose(presets_.all().front().key);
}

void ExportPage::resizeEvent(QResizeEvent* event) {
    placeSides();
    Page::resizeEvent(event);
}

/// Without room for both sides the takes and the written files stand below the form and scroll with it.
void ExportPage::placeSides() {
    const bool beside = width() >= Theme::get().px(kBothSides);
    if (beside == areBeside())
        return;
    if (beside)
        sides_->addWidget(takes_side_, 1);
    else
        below_form_->addWidget(takes_side_, 1);
    between_->setVisible(beside);
    results_panel_->setScrolls(beside);
    scroll_->setSizePolicy(beside ? QSizePolicy::Fixed : QSizePolicy::Expanding, QSizePolicy::Expanding);
}

bool ExportPage::areBeside() const {
    return sides_->indexOf(takes_side_) >= 0;
}

/// Below the form they would be out of sight.
void ExportPage::scrollToResults() {
    if (areBeside())
        return;
    QWidget* content = scroll_->widget();
    scroll_->verticalScrollBar()->setValue(results_panel_->mapTo(content, QPoint()).y());
}

void ExportPage::keyPressEvent(QKeyEvent* event) {
    const bool is_enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (is_enter && write_->isVisible() && write_->isEnabled())
        write();
    else if (event->key() == Qt::Key_Escape)
        review_.shared().goTo(Step::kReview);
    else
        Page::keyPressEvent(event);
}

}  // namespace noctule::ui
