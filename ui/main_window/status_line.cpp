// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/status_line.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QPointer>

#include "ui/main_window/status_button.h"
#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/job_words.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr int kStatusLineHeight = 26, kSaid_ms = 8000;

Job* newestRunning(const Jobs& jobs) {
    Job* newest = nullptr;
    for (Job* job : jobs.all())
        if (job->state() == Job::State::kRunning)
            newest = job;
    return newest;
}

}  // namespace

StatusLine::StatusLine(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    auto* row = makeRow(this, {12, 0, 8, 0}, 12);
    safe_ = new QLabel;
    open_ = new ElidedLabel({}, TextRole::kSecondary, Ink::kLabel);
    storage_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    jobs_ = new StatusButton;
    followKey(*jobs_, "window/jobs", QKeySequence("Ctrl+J"), [this](const QKeySequence& key) {
        jobs_->setToolTip(tr("Jobs (%1)", "a key").arg(keysText(key)));
    });
    cancel_ = new StatusButton(tr("Cancel"));
    shortcuts_ = new StatusButton(tr("Shortcuts"));
    followKey(*shortcuts_, "window/shortcuts", QKeySequence("F1"),
              [this](const QKeySequence& key) { shortcuts_->setKeys(key); });
    row->addWidget(safe_);
    row->addWidget(open_, 1);
    row->addWidget(storage_);
    row->addWidget(jobs_);
    row->addWidget(cancel_);
    row->addWidget(shortcuts_);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

    connect(jobs_, &QAbstractButton::clicked, this, &StatusLine::jobsRequested);
    connect(shortcuts_, &QAbstractButton::clicked, this, &StatusLine::shortcutsRequested);
    connect(cancel_, &QAbstractButton::clicked, this, [this] {
        if (Job* job = newestRunning(studio_.jobs()))
            job->cancel();
    });
    connect(&studio_.jobs(), &Jobs::changed, this, &StatusLine::showJobs);
    connect(&studio_.session(), &SessionModel::opened, this, &StatusLine::showOpen);
    connect(&studio_.suits().storage(), &StorageWatch::changed, this, &StatusLine::showStorage);
    connect(&studio_.suits(), &LiveSuits::changed, this, &StatusLine::showStorage);
    connect(&studio_.session(), &SessionModel::changed, this, &StatusLine::showOpen);
    connect(&studio_.take(), &TakeDocument::opened, this, &StatusLine::showOpen);
    connect(&studio_.take(), &TakeDocument::torn, this, &StatusLine::showOpen);
    connect(&studio_, &Studio::said, this, &StatusLine::say);
    studio_.suits().follow(&LiveSuit::phaseChanged, this, &StatusLine::showOpen);
    studio_.suits().follow(&SuitCheck::changed, this, &StatusLine::showOpen);
    studio_.suits().follow(&SuitCheck::changed, this, &StatusLine::showStorage);
    connect(&Theme::get(), &Theme::changed, this, &StatusLine::showOpen);
    said_timer_.setSingleShot(true);
    connect(&said_timer_, &QTimer::timeout, this, [this] {
        said_.clear();
        showOpen();
    });
    showOpen();
    showJobs();
    showStorage();
}

QSize StatusLine::sizeHint() const {
    return {Theme::get().px(600), Theme::get().px(kStatusLineHeight)};
}

QSize StatusLine::minimumSizeHint() const {
    return {0, Theme::get().px(kStatusLineHeight)};
}

QString StatusLine::openText() const {
    return open_->text();
}

QString StatusLine::jobsText() const {
    return jobs_->text();
}

QString StatusLine::storageText() const {
    return storage_->text();
}

void StatusLine::say(const QString& sentence) {
    said_ = sentence;
    said_timer_.start(kSaid_ms);
    showOpen();
}

QString StatusLine::sessionWords() const {
    const SessionModel& session = studio_.session();
    if (studio_.take().isOpen()) {
        const TakeOverview& take = *studio_.take().overview();
        const QString file = QFileInfo(studio_.take().path()).fileName(), size = bytesText(take.bytes);
        if (studio_.take().isDamaged())
            return tr("%1, %2, damaged", "a take's file and its size").arg(file, size);
        if (isReadOnly())
            return tr("%1, %2, read only", "a take's file and its size").arg(file, size);
        if (take.state == "complete")
            return tr("%1, %2, complete", "a take's file and its size").arg(file, size);
        if (take.state == "recovered")
            return tr("%1, %2, recovered", "a take's file and its size").arg(file, size);
        return tr("%1, %2, not ended", "a take's file and its size").arg(file, size);
    }
    if (session.isOpen())
        return (isReadOnly() ? tr("%1, read only: changes are not kept", "name of the session")
                             : tr("%1, all changes are kept", "name of the session"))
            .arg(QString::fromStdString(session.session().name));
    return tr("Noctule %1. Works offline, no account", "version")
        .arg(QString::fromStdString(studio_.parts().software).section(' ', 1));
}

/// "NB-000123 streaming, 5.4 MB/s, 0 blocks lost"; of several boxes that stream, of all of them.
QString StatusLine::linkWords() const {
    const LiveSuits& suits = studio_.suits();
    const LiveSuit& suit = studio_.suit();
    const auto status = suit.status();
    const QString name = status->hello ? QString::fromStdString(status->hello->serial) : suit.address();
    switch (status->link) {
        case LinkState::kClosed:
            return {};
        case LinkState::kOpening:
            return tr("%1 is being connected").arg(name);
        case LinkState::kLost:
            return tr("%1: the link is broken, the studio tries again").arg(name);
        case LinkState::kRefused:
            return tr("%1 does not answer").arg(name);
        case LinkState::kStalled:
            return tr("%1: no sound arrives").arg(name);
        default:
            break;
    }
    int streaming = 0;
    int64_t lost = 0;
    for (const SuitInUse* worn : suits.connected()) {
        streaming += worn->suit.status()->link == LinkState::kStreaming;
        lost += worn->suit.link().frames.losses();
    }
    QStringList words{streaming > 1 ? tr("%n boxes streaming", nullptr, streaming)
                                    : tr("%1 streaming").arg(name)};
    if (const auto bytes_per_s = suits.measuredBytesPerSecond())
        words << tr("%1 MB/s").arg(numberText(*bytes_per_s * 1e-6, 1));
    words << tr("%n block(s) lost", nullptr, static_cast<int>(lost));
    return words.join(QStringLiteral(", "));
}

/// How the link fares, and the climate that the speed of sound is taken from; empty without a suit.
QString StatusLine::suitWords() const {
    const LiveSuit& suit = studio_.suit();
    if (suit.phase() == LiveSuit::Phase::kNone)
        return {};
    QStringList words{linkWords()};
    if (const auto frame = suit.frame(); frame && frame->health.suit.temperature_c) {
        const SuitStatus& box = frame->health.suit;
        words << tr("%1 °C").arg(numberText(*box.temperature_c, 1));
        if (suit.isSilent())
            words.back().prepend(lastKnownInShort() + ' ');
        if (box.humidity_percent)
            words << tr("humidity %1").arg(percentText(*box.humidity_percent / 100));
    }
    return words.join(QStringLiteral(", "));
}

Tone StatusLine::tone() const {
    const LiveSuit& suit = studio_.suit();
    if (suit.phase() != LiveSuit::Phase::kNone) {
        const bool holds =
            suit.status()->link != LinkState::kLost && suit.phase() != LiveSuit::Phase::kRefused;
        return holds ? Tone::kOk : Tone::kError;
    }
    return studio_.take().isDamaged() ? Tone::kError : isReadOnly() ? Tone::kWarn : Tone::kOk;
}

/// Of the session and its takes; one from outside of it is not concerned.
bool StatusLine::isReadOnly() const {
    const SessionModel& session = studio_.session();
    return session.isReadOnly() && (!studio_.take().isOpen() || session.currentTake() >= 0);
}

void StatusLine::showOpen() {
    const Theme& theme = Theme::get();
    const QString suit = suitWords();
    const bool something_open = studio_.session().isOpen() || studio_.take().isOpen();
    safe_->setVisible((something_open || !suit.isEmpty()) && said_.isEmpty());
    const QColor color = colorOf(tone());
    const QString picture = suit.isEmpty() ? "safe" : "link";
    if (const QString drawn = picture + color.name() + QString::number(theme.px(14)); drawn != drawn_) {
        drawn_ = drawn;
        safe_->setPixmap(theme.pixmap(picture, theme.px(14), color));
    }
    const QString words = !said_.isEmpty() ? said_ : suit.isEmpty() ? sessionWords() : suit;
    if (words != open_->text())
        open_->setText(words);
}

void StatusLine::showJobs() {
    const int running = studio_.jobs().running();
    Job* newest = newestRunning(studio_.jobs());
    int unseen = 0, failed = 0;
    for (const Job* job : studio_.jobs().all()) {
        unseen += job->state() != Job::State::kRunning && !job->seen();
        failed += job->state() == Job::State::kFailed && !job->seen();
    }
    if (running > 1)
        jobs_->setText(tr("%n jobs running", nullptr, running));
    else if (newest)
        jobs_->setText(JobWords::progress(*newest));
    else if (failed > 0)
        jobs_->setText(tr("%n job(s) failed", nullptr, failed));
    else if (unseen > 0)
        jobs_->setText(tr("%n job(s) finished", nullptr, unseen));
    else
        jobs_->setText(tr("No jobs running"));
    jobs_->setTone(failed > 0 && running == 0 ? Tone::kError : Tone::kNeutral);
    cancel_->setVisible(running == 1);
    cancel_->setAccessibleName(newest ? tr("Cancel %1").arg(newest->title()) : tr("Cancel"));
}

void StatusLine::showStorage() {
    LiveSuits& suits = studio_.suits();
    const qint64 free_bytes = suits.storage().freeBytes();
    const auto left_s = suits.storageLeft_s();
    if (free_bytes < 0 || !left_s)
        return storage_->setText({});
    storage_->setText(
        tr("Storage %1 free, %2 of recording").arg(bytesText(free_bytes), durationWords(*left_s)));
    const Tone tone = toneOfStorage(*left_s);
    storage_->setInk(tone == Tone::kOk ? Ink::kLabel : tone == Tone::kWarn ? Ink::kWarn : Ink::kError);
    storage_->setToolTip(suits.connected().empty()
                             ? tr("A suit of 18 boards records 5.4 MB a second.")
                             : tr("What is connected records %1 a second.")
                                   .arg(bytesText(static_cast<qint64>(suits.bytesPerSecond()))));
}

void StatusLine::paintEvent(QPaintEvent*) {
    const Tokens& tokens = Theme::get().tokens();
    QPainter painter(this);
    painter.fillRect(rect(), tokens.panel);
    painter.fillRect(QRect(0, 0, width(), 1), tokens.line);
}

}  // namespace noctule::ui
