// SPDX-License-Identifier: Apache-2.0
// Where the studio begins: make or open a session, try it without a suit, what was interrupted, what was open
// before, and a hand for those who are here for the first time.
#pragma once

#include "ui/models/studio.h"
#include "ui/views/page.h"

class QVBoxLayout;

namespace noctule::ui {

class BigButton;
class Button;
class JobProgress;
class Label;
class ProblemCard;
class RecentSessions;
class SearchField;
class SessionList;
struct RecentSession;

class StartPage : public Page {
    Q_OBJECT
public:
    StartPage(Studio& studio, RecentSessions& recent, QWidget* parent = nullptr);

    QString title() const override { return tr("Start"); }
    void enter() override;

    BigButton* newSessionButton() const { return new_; }
    BigButton* tryButton() const { return try_; }
    /// Of the cards of suits: "Connect", or "Show it" when one is connected.
    const QList<Button*>& suitButtons() const { return suit_buttons_; }
    /// "Connect a suit"; hidden where a card has the button.
    Button* connectButton() const { return connect_other_; }
    SessionList& sessionList() { return *list_; }
    QList<ProblemCard*> problemCards() const;

signals:
    void newSessionRequested();
    void openSessionRequested();
    void importMotionRequested();
    void openRequested(const QString& path);  ///< a session's folder or a take
    void recoverRequested(const QString& take_path);
    void rebuildRequested(const QString& session_folder);
    void tourRequested();
    void putSuitOnRequested();
    void newsRequested();

private:
    QWidget* makeHead();
    QWidget* makeChoices();
    QWidget* makeSuitsFound();
    QWidget* makeFirstTime();
    QWidget* makeRecent();
    QWidget* makeLink(const QString& icon, const QString& text, const QString& hint,
                      void (StartPage::*signal)());
    void tryVirtualSuit();
    void showSuitsFound();
    Button* addSuitCard(const QString& name, const QString& detail, const QString& action);
    void addFoundSuits();
    void showInterrupted();
    void addCard(const RecentSession& session);
    ProblemCard* interruptedCard(const RecentSession& session);
    ProblemCard* leftOpenCard(const RecentSession& session);
    ProblemCard* damagedCard(const RecentSession& session);
    void showRecent();
    void askForPictures();
    void search(const QString& text);

    Studio& studio_;
    RecentSessions& recent_;
    QWidget* sheet_;
    Label* suits_found_ = nullptr;
    QVBoxLayout* suit_cards_ = nullptr;
    Button* connect_other_ = nullptr;
    QList<Button*> suit_buttons_;
    BigButton *new_, *open_, *motion_, *try_;
    JobProgress* progress_;
    Label* nothing_found_;
    QVBoxLayout* cards_;
    SearchField* search_;
    SessionList* list_;
    QWidget* no_sessions_;
    QStringList dismissed_;  ///< paths of interrupted takes and folders whose card was closed
};

}  // namespace noctule::ui
