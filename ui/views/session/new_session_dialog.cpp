// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/new_session_dialog.h"

#include <QDate>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

#include "core/session/placement.h"
#include "ui/models/file_choice.h"
#include "ui/models/shared_context.h"
#include "ui/views/length_box.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr double kLowest_m = 0.9, kHighest_m = 2.3;

/// A folder's name that every file system takes.
QString folderName(const QString& session_name) {
    QString name = session_name.trimmed();
    for (QChar& letter : name)
        if (QStringLiteral("/\\:*?\"<>|").contains(letter))
            letter = '-';
    return name;
}

/// "2026-11-21", or with " (2)" when there is one already.
QString freeName(const QString& folder) {
    const QString date = QDate::currentDate().toString(Qt::ISODate);
    QString name = date;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(name)); ++number)
        name = QStringLiteral("%1 (%2)").arg(date).arg(number);
    return name;
}

}  // namespace

NewSessionDialog::NewSessionDialog(SharedContext& shared, QWidget* parent)
    : QDialog(parent), shared_(shared) {
    setWindowTitle(tr("New session"));
    auto* column = makeColumn(this, {24, 20, 24, 20}, 16);
    column->addWidget(new Label(tr("New session"), TextRole::kPage, Ink::kValue, true));
    buildFields(*column);

    problem_ = new Label({}, TextRole::kSecondary, Ink::kError);
    problem_->wrapped();
    problem_->hide();
    column->addWidget(problem_);
    column->addStretch();

    auto* row = addRow(column);
    row->addStretch();
    Button* cancel = makeButton(ButtonKind::kOutlined, tr("Cancel"), {}, QKeySequence("Esc"));
    cancel->setTall(true);
    create_ = makeButton(ButtonKind::kPrimary, tr("Create session"));
    create_->setDefault(true);
    row->addWidget(cancel);
    row->addWidget(create_);
    keepMinimumWidth(*this, 520);

    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(create_, &QPushButton::clicked, this, &QDialog::accept);
    name_->selectAll();
    name_->setFocus();
    check();
}

void NewSessionDialog::buildFields(QVBoxLayout& column) {
    const QString home = shared_.sessionsFolder(), name = freeName(home);
    auto* rows = new FormRows(110);
    name_ = new QLineEdit(name);
    rows->addRow(tr("Name"), name_);

    folder_ = new QLineEdit(QDir::toNativeSeparators(QDir(home).filePath(name)));
    auto* browse = new ToolButton("folder", tr("Choose the folder"));
    auto* folder_row = new QWidget;
    auto* folder_layout = makeRow(folder_row, {}, 8);
    folder_layout->addWidget(folder_);
    folder_layout->addWidget(browse);
    folder_row->setFocusProxy(folder_);
    rows->addRow(tr("Folder"), folder_row);
    folder_->setAccessibleName(tr("Folder"));
    rows->addHint(tr("Takes, calibration and exports go in here. The folder can be copied and moved."));

    performer_ = new QLineEdit(SessionModel::firstPerformer());
    rows->addRow(tr("Performer"), performer_);
    height_ = new LengthBox(kLowest_m, kHighest_m, LengthBox::Metric::kMetres);
    height_->setValue(1.75);
    rows->addRow(tr("Height"), height_);
    rows->addHint(
        tr("Other measures follow from the height; they can be set later under Performer and suit."));
    column.addWidget(rows);

    connect(name_, &QLineEdit::textEdited, this, &NewSessionDialog::followName);
    connect(folder_, &QLineEdit::textEdited, this, [this] {
        folder_edited_ = true;
        check();
    });
    connect(performer_, &QLineEdit::textEdited, this, &NewSessionDialog::check);
    connect(browse, &QToolButton::clicked, this, &NewSessionDialog::chooseFolder);
}

QString NewSessionDialog::sessionName() const {
    return name_->text().trimmed();
}

QString NewSessionDialog::folder() const {
    return QDir::cleanPath(QDir::fromNativeSeparators(folder_->text().trimmed()));
}

QString NewSessionDialog::performerName() const {
    return performer_->text().trimmed();
}

double NewSessionDialog::height_m() const {
    return height_->value();
}

void NewSessionDialog::followName() {
    if (!folder_edited_) {
        const QDir home = QFileInfo(folder()).dir();
        folder_->setText(QDir::toNativeSeparators(home.filePath(folderName(sessionName()))));
    }
    check();
}

void NewSessionDialog::chooseFolder() {
    const QString home = QFileInfo(folder()).dir().path();
    const QString chosen =
        FileChoice{.kind = "new_session", .title = tr("Folder for the new session"), .at = home}.folder(this);
    if (chosen.isEmpty())
        return;
    const bool empty = QDir(chosen).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot);
    folder_->setText(
        QDir::toNativeSeparators(empty ? chosen : QDir(chosen).filePath(folderName(sessionName()))));
    check();
}

QString NewSessionDialog::problemOfFolder() const {
    const QFileInfo target(folder());
    if (folder_->text().trimmed().isEmpty())
        return tr("The session needs a folder.");
    if (target.isRelative())
        return tr("The folder needs its whole path, from the root on.");
    if (target.exists() && !target.isDir())
        return tr("%1 is a file. Choose another name for the folder.").arg(target.fileName());
    if (QFileInfo::exists(QDir(target.filePath()).filePath("session.json")))
        return tr("%1 holds a session already. Open it, or choose another name.").arg(target.fileName());
    if (target.exists() && !QDir(target.filePath()).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot))
        return tr("%1 holds files already. Choose a new or an empty folder.").arg(target.fileName());
    QFileInfo existing = target;
    while (!existing.exists() && !existing.dir().isRoot())
        existing = QFileInfo(existing.dir().path());
    if (existing.exists() && !existing.isWritable())
        return tr("%1 cannot be written. Choose another folder.")
            .arg(QDir::toNativeSeparators(existing.filePath()));
    return {};
}

bool NewSessionDialog::showProblem(const QString& problem) {
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
    create_->setDisabledBecause(problem);
    return !problem.isEmpty();
}

void NewSessionDialog::check() {
    if (sessionName().isEmpty())
        showProblem(tr("The session needs a name."));
    else if (performerName().isEmpty())
        showProblem(tr("The performer needs a name."));
    else
        showProblem(problemOfFolder());
}

void NewSessionDialog::accept() {
    height_->interpretText();
    check();
    if (!create_->isEnabled())
        return;
    SessionModel& session = shared_.session();
    QString failure = tr("The session could not be made. Choose another folder.");
    const auto listening =
        connect(&session, &SessionModel::failed, this, [&](const QString& message) { failure = message; });
    QDir().mkpath(QFileInfo(folder()).dir().path());
    const bool made = session.create(folder(), sessionName());
    disconnect(listening);
    if (!made) {
        showProblem(failure);
        create_->setDisabledBecause({});
        return;
    }
    if (!session.session().performers.empty()) {
        Performer performer = session.session().performers.front();
        performer.name = performerName().toStdString();
        BodyMeasures measures = performer.measures;
        measures.height_m = height_m();
        setMeasures(performer, measures);
        session.changePerformer(0, performer, tr("Name the performer"));
        session.undoStack().clear();  // a new session begins with nothing to undo
    }
    QDialog::accept();
}

}  // namespace noctule::ui
