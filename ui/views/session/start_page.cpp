// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/start_page.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QVBoxLayout>

#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/big_button.h"
#include "ui/views/session/recent_sessions.h"
#include "ui/views/session/recovery_words.h"
#include "ui/views/session/session_list.h"
#include "ui/views/session/take_picture.h"
#include "ui/views/show_folder.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/search_field.h"

namespace noctule::ui {
namespace {

constexpr int kSheetWidth = 1200, kLeftWidth = 360;

}  // namespace

StartPage::StartPage(Studio& studio, RecentSessions& recent, QWidget* parent)
    : Page(parent), studio_(studio), recent_(recent) {
    sheet_ = new QWidget;
    auto* content = new QWidget;
    auto* sheet = makeColumn(content, {}, 36);
    sheet->addWidget(makeHead());
    auto* columns = addRow(sheet, 40);
    auto* left = new QWidget;
    auto* left_column = makeColumn(left, {}, 28);
    left_column->addWidget(makeChoices());
    left_column->addWidget(makeSuitsFound());
    left_column->addWidget(makeFirstTime());
    left_column->addStretch();
    keepSize(*left, kLeftWidth, 0);
    columns->addWidget(left);
    columns->addWidget(makeRecent(), 1);
    sheet->addStretch();
    auto* centred = makeRow(sheet_, {32, 24, 32, 24});
    centred->addStretch();
    centred->addWidget(content, 1000);
    centred->addStretch();
    keepMaximumWidth(*content, kSheetWidth);

    auto* outer = makeColumn(this, {}, 0);
    outer->addWidget(new ScrollArea(sheet_));
    connect(&recent_, &RecentSessions::changed, this, &StartPage::showRecent);
    showRecent();
}

void StartPage::enter() {
    recent_.look();
    new_->setFocus();
}

QWidget* StartPage::makeHead() {
    auto* head = new QWidget;
    auto* row = makeRow(head, {0, 20, 0, 0}, 20);
    auto* mark = new QLabel;
    const auto draw_mark = [mark] {
        mark->setPixmap(Theme::get().pixmap("bat", Theme::get().px(48), Theme::get().tokens().acc));
    };
    draw_mark();
    connect(&Theme::get(), &Theme::changed, mark, draw_mark);
    row->addWidget(mark);
    auto* names = new QWidget;
    auto* words = makeColumn(names);
    words->addWidget(new Label(tr("Noctule"), TextRole::kVerdict, Ink::kValue, true));
    words->addWidget(new Label(tr("Motion capture by sound and inertia"), TextRole::kBody, Ink::kLabel));
    row->addWidget(names, 1);
    return head;
}

QWidget* StartPage::makeChoices() {
    auto* choices = new QWidget;
    auto* column = makeColumn(choices, {}, 8);
    new_ = new BigButton("new", tr("New session"), tr("A folder for takes, calibration and exports"), true);
    open_ = new BigButton("open", tr("Open session"), tr("Any folder with a session.json"), false);
    motion_ =
        new BigButton("skeleton", tr("Import motion"), tr("A BVH file, worn by a simulated suit"), false);
    try_ = new BigButton("play", tr("Try it with the virtual suit"),
                         tr("A simulated performer, nothing to plug in"), false);
    const auto follow = [](BigButton* button, const char* command, const char* usual) {
        followKey(*button, command, QKeySequence(usual),
                  [button](const QKeySequence& key) { button->setKeys(key); });
    };
    follow(new_, "window/new_session", "Ctrl+N");
    follow(open_, "window/open_session", "Ctrl+O");
    follow(motion_, "window/import_motion", "Ctrl+Shift+M");
    progress_ = new JobProgress;
    connect(&studio_.session(), &SessionModel::opened, this, [this] {
        if (!progress_->isRunning())
            progress_->follow(nullptr);  // what failed before is over
    });
    for (QWidget* widget : std::initializer_list<QWidget*>{new_, open_, motion_, try_, progress_})
        column->addWidget(widget);
    connect(new_, &QAbstractButton::clicked, this, &StartPage::newSessionRequested);
    connect(open_, &QAbstractButton::clicked, this, &StartPage::openSessionRequested);
    connect(motion_, &QAbstractButton::clicked, this, &StartPage::importMotionRequested);
    connect(try_, &QAbstractButton::clicked, this, &StartPage::tryVirtualSuit);
    connect(progress_, &JobProgress::ended, this, [this] { try_->setEnabled(true); });
    return choices;
}

QWidget* StartPage::makeSuitsFound() {
    auto* suits = new QWidget;
    auto* column = makeColumn(suits, {}, 8);
    column->addWidget(new Label(tr("Suits found"), TextRole::kSecondary, Ink::kHint));
    suits_found_ = (new Label({}, TextRole::kBody, Ink::kLabel))->wrapped();
    column->addWidget(suits_found_);
    auto* cards = new QWidget;
    suit_cards_ = makeColumn(cards, {}, 8);
    column->addWidget(cards);
    auto* row = addRow(column, 0);
    connect_other_ = makeButton(ButtonKind::kText, tr("Connect a suit"));
    connect_other_->setFlush(true);
    row->addWidget(connect_other_);
    row->addStretch();
    connect(&studio_.finder(), &SuitFinder::changed, this, &StartPage::showSuitsFound);
    studio_.suits().follow(&LiveSuit::phaseChanged, this, &StartPage::showSuitsFound);
    showSuitsFound();
    connect(connect_other_, &QPushButton::clicked, this, [this] { studio_.goTo(Step::kConnect); });
    return suits;
}

/// "Blue suit" and what can be done with it.
Button* StartPage::addSuitCard(const QString& name, const QString& detail, const QString& action) {
    auto* card = new Card;
    auto* row = makeRow(card, {12, 8, 12, 8}, 8);
    auto* words = new QWidget;
    auto* column = makeColumn(words, {}, 2);
    column->addWidget(new Label(name, TextRole::kBody, Ink::kValue, true));
    column->addWidget((new Label(detail, TextRole::kSecondary, Ink::kLabel))->wrapped());
    row->addWidget(words, 1);
    Button* button = makeButton(ButtonKind::kOutlined, action);
    button->setAccessibleName(action + ' ' + name);
    row->addWidget(button, 0, Qt::AlignVCenter);
    suit_cards_->addWidget(card);
    suit_buttons_.append(button);
    return button;
}

void StartPage::showSuitsFound() {
    clearWidgetsLater(*suit_cards_);
    suit_buttons_.clear();
    const auto hello = studio_.suit().status()->hello;
    const bool connected = studio_.suit().phase() != LiveSuit::Phase::kNone;
    if (connected) {
        const QString name = hello ? QString::fromStdString(hello->serial) : studio_.suit().address();
        connect(addSuitCard(name, hello ? tr("is connected") : tr("is being connected"), tr("Show it")),
                &QPushButton::clicked, this, [this] { studio_.goTo(Step::kConnect); });
    } else {
        addFoundSuits();
    }
    suits_found_->setVisible(suit_buttons_.isEmpty());
    suits_found_->setText(
        tr("No driver box is found. Switch one on, or connect it by USB; the virtual suit on "
           "Connect stands in for one."));
    connect_other_->setVisible(!connected && suit_buttons_.isEmpty());
}

void StartPage::addFoundSuits() {
    constexpr int kMost = 3;
    for (const KnownSuit& suit : studio_.finder().suits()) {
        if (!suit.present || suit.device.contact != FoundDevice::Contact::kAnswers ||
            suit_buttons_.size() == kMost)
            continue;
        Button* button = addSuitCard(suit.shownName(),
                                     suit.device.busy ? tr("another studio uses it") : tr("ready to connect"),
                                     tr("Connect"));
        button->setDisabledBecause(suit.device.busy ? tr("Another studio uses it.") : QString());
        connect(button, &QPushButton::clicked, this,
                [this, address = QString::fromStdString(suit.device.address)] {
                    studio_.goTo(Step::kConnect);
                    studio_.suit().connectTo(address);
                });
    }
}

QWidget* StartPage::makeLink(const QString& icon, const QString& text, const QString& hint,
                             void (StartPage::*signal)()) {
    auto* line = new QWidget;
    auto* row = makeRow(line, {}, 12);
    Button* link = makeButton(ButtonKind::kText, text, icon);
    link->setFlush(true);  // the words stand below the caption
    link->setAccessibleDescription(hint);
    row->addWidget(link);
    row->addWidget(new Label(hint, TextRole::kSecondary, Ink::kHint));
    row->addStretch();
    connect(link, &QPushButton::clicked, this, signal);
    return line;
}

QWidget* StartPage::makeFirstTime() {
    auto* links = new QWidget;
    auto* column = makeColumn(links, {}, 2);
    column->addWidget(new Label(tr("First time here"), TextRole::kSecondary, Ink::kHint));
    column->addWidget(
        makeLink("info", tr("Tour of the five steps"), tr("2 minutes"), &StartPage::tourRequested));
    column->addWidget(
        makeLink("note", tr("Put the suit on"), tr("drawings, 5 minutes"), &StartPage::putSuitOnRequested));
    column->addWidget(makeLink("history", tr("What is new"), {}, &StartPage::newsRequested));
    return links;
}

QWidget* StartPage::makeRecent() {
    auto* recent = new QWidget;
    auto* column = makeColumn(recent, {}, 12);
    auto* cards = new QWidget;
    cards_ = makeColumn(cards, {}, 12);
    column->addWidget(cards);
    auto* head = addRow(column);
    head->addWidget(new Label(tr("Recent sessions"), TextRole::kSection, Ink::kValue, true), 1);
    search_ = new SearchField(tr("Find a session or take"));
    keepSize(*search_, 220, 0);
    head->addWidget(search_);
    list_ = new SessionList(recent_);
    column->addWidget(list_);
    no_sessions_ = (new Label(tr("Sessions that you make or open are listed here, the newest first."),
                              TextRole::kBody, Ink::kLabel))
                       ->wrapped();
    column->addWidget(no_sessions_);
    nothing_found_ = new Label({}, TextRole::kBody, Ink::kLabel);
    nothing_found_->wrapped()->hide();
    column->addWidget(nothing_found_);
    column->addStretch();
    connect(search_, &SearchField::searched, this, &StartPage::search);
    connect(list_, &SessionList::openRequested, this, &StartPage::openRequested);
    connect(list_, &SessionList::folderWanted, this,
            [this](const QString& folder) { showFolder(studio_, folder); });
    return recent;
}

void StartPage::search(const QString& text) {
    list_->setFilter(text);
    nothing_found_->setText(tr("No session and no take has “%1” in its name.").arg(text.trimmed()));
    nothing_found_->setVisible(!recent_.all().empty() && list_->shownRows() == 0);
}

void StartPage::tryVirtualSuit() {
    progress_->follow(studio_.tryVirtualSuit());
    if (try_->hasFocus())
        setFocus();  // a disabled button would hand the keyboard to the next one
    try_->setEnabled(false);
}

void StartPage::showRecent() {
    const bool any = !recent_.all().empty();
    list_->setVisible(any);
    search_->setVisible(any);
    no_sessions_->setVisible(!any);
    search(search_->text());
    showInterrupted();
    askForPictures();
}

void StartPage::askForPictures() {
    const QSize size(168, 124);  // twice the row's picture, for dense screens
    for (const RecentSession& session : recent_.all())
        if (!session.newest_take.isEmpty() && !list_->sessions().hasPicture(session.folder))
            takePicture(studio_, session.newest_take, size,
                        [list = QPointer(list_), folder = session.folder](const QImage& picture) {
                            if (list)
                                list->sessions().setPicture(folder, picture);
                        });
}

void StartPage::showInterrupted() {
    clearWidgetsLater(*cards_);
    constexpr int kMost = 3;
    for (const RecentSession& session : recent_.all())
        if (cards_->count() < kMost && !dismissed_.contains(session.folder))
            addCard(session);
}

void StartPage::addCard(const RecentSession& session) {
    ProblemCard* card = nullptr;
    if (session.can_rebuild)
        card = damagedCard(session);
    else if (!session.interrupted.empty())
        card = interruptedCard(session);
    else if (session.left_open)
        card = leftOpenCard(session);
    if (!card)
        return;
    card->setClosable(true);
    connect(card, &ProblemCard::closed, this, [this, folder = session.folder] {
        dismissed_.append(folder);
        showInterrupted();
    });
    cards_->addWidget(card);
}

ProblemCard* StartPage::interruptedCard(const RecentSession& session) {
    const InterruptedTake& take = session.interrupted.front();
    const QString path = take.path;
    const QString safe =
        tr("Recording in “%1” stopped unexpectedly. %2 are safe on disk; the other takes were "
           "not touched.")
            .arg(session.name, secondsText(take.duration_s));
    if (take.recovered) {
        auto* card = new ProblemCard(Tone::kOk, tr("Take %1 was recovered").arg(take.name), safe);
        connect(card->addAction(tr("Review %1").arg(take.name)), &QPushButton::clicked, this,
                [this, path] { emit openRequested(path); });
        return card;
    }
    auto* card = new ProblemCard(Tone::kWarn, tr("Take %1 broke off").arg(take.name),
                                 safe + QLatin1Char(' ') + recoverOffer());
    connect(card->addAction(tr("Recover %1").arg(take.name)), &QPushButton::clicked, this,
            [this, path] { emit recoverRequested(path); });
    connect(card->addAction(tr("Open it as it is")), &QPushButton::clicked, this,
            [this, path] { emit openRequested(path); });
    return card;
}

ProblemCard* StartPage::leftOpenCard(const RecentSession& session) {
    auto* card = new ProblemCard(
        Tone::kWarn, tr("“%1” was not closed").arg(session.name),
        tr("The studio ended unexpectedly while this session was open. Its %n take(s) are safe; changes to "
           "notes and ratings were saved up to the last second.",
           nullptr, session.takes));
    connect(card->addAction(tr("Open %1").arg(session.name)), &QPushButton::clicked, this,
            [this, folder = session.folder] { emit openRequested(folder); });
    return card;
}

ProblemCard* StartPage::damagedCard(const RecentSession& session) {
    auto* card = new ProblemCard(Tone::kError, tr("The list of “%1” is damaged").arg(session.name),
                                 rebuildOffer(session.problem));
    connect(card->addAction(tr("Rebuild session")), &QPushButton::clicked, this,
            [this, folder = session.folder] { emit rebuildRequested(folder); });
    return card;
}

QList<ProblemCard*> StartPage::problemCards() const {
    QList<ProblemCard*> cards;
    for (int i = 0; i < cards_->count(); ++i)
        cards.append(qobject_cast<ProblemCard*>(cards_->itemAt(i)->widget()));
    return cards;
}

}  // namespace noctule::ui
