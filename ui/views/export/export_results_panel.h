// SPDX-License-Identifier: Apache-2.0
// What was written and what reading it again said, a card for every file.
#pragma once

#include <QWidget>

#include "ui/views/export/export_run.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class EmptyState;
class Label;
class ScrollArea;
class VerdictHeader;

class ExportResultsPanel : public QWidget {
    Q_OBJECT
public:
    explicit ExportResultsPanel(QWidget* parent = nullptr);

    /// Above what was written before, which stays. `is_trial`: one frame that was not kept; it goes with the
    /// next.
    void setResults(const ExportResults& results, bool is_trial);
    void clear();
    int cardCount() const;
    /// Or all of them stand in what scrolls around the panel.
    void setScrolls(bool scrolls);

signals:
    void saveWanted();
    void openWanted(const QString& path);

private:
    enum class Kept { kYes, kNo };
    QWidget* makeCard(const ExportOutcome& outcome, bool in_full, Kept kept);
    void showCards(const ExportResults& latest);

    EmptyState* empty_;
    QWidget *results_, *content_, *cards_;
    ScrollArea* area_;
    VerdictHeader* verdict_;
    QBoxLayout* cards_column_;
    std::vector<ExportOutcome> earlier_;  ///< of files that were written, newest first
    std::vector<ExportOutcome> latest_;   ///< empty after a trial
    Button* save_;
};

}  // namespace noctule::ui
