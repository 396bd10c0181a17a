// SPDX-License-Identifier: Apache-2.0
// Is the take good? The take under review seen, judged, processed again and compared; its full report takes
// the centre's place when asked for.
#pragma once

#include <QPointer>
#include <memory>

#include "core/processing/process_take.h"
#include "ui/models/studio.h"
#include "ui/views/page.h"

class QStackedWidget;

namespace noctule::ui {

class EmptyState;
class FullReport;
class ReportPanel;
class ReportView;
class ReprocessDialog;
class ReviewActions;
class ReviewCenter;
class ReviewSidebar;

class ReviewPage : public Page {
    Q_OBJECT
public:
    explicit ReviewPage(Studio& studio, QWidget* parent = nullptr);
    ~ReviewPage() override;

    QString title() const override { return tr("Review"); }
    QWidget* leftDock() override;
    QWidget* rightDock() override;
    QList<QAction*> menuActions() const override;
    void enter() override;

    ReviewSidebar& sidebar();
    ReviewCenter& center() { return *center_; }
    ReportPanel& reportPanel();
    ReportView& reportView() { return *report_view_; }
    bool showsFullReport() const;
    /// Stands in the centre while the chosen take cannot be opened.
    EmptyState& unreadable() { return *unreadable_; }

public slots:
    void openFullReport();
    void closeFullReport();
    /// Asks how, then process().
    void reprocess();
    /// Proposes gyroscopes, also where the last result was made without.
    void reprocessWithGyroscopes();
    /// The new result is shown, the one that was shown before becomes the one it is compared with.
    void process(const ProcessRequest& request);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void askHow(ReprocessDialog& dialog);
    bool handleKey(const QKeyEvent& event);
    void refresh();
    QWidget* emptyContent();
    void tellTitles();
    void compareWithEarlier();

    Studio& studio_;
    FullReport* full_report_;
    QPointer<ReviewSidebar> sidebar_;  // the docks may be owned by the main window
    QPointer<ReportPanel> report_panel_;
    ReviewCenter* center_;
    ReportView* report_view_;
    EmptyState *empty_, *unreadable_;
    QStackedWidget* stack_;
    ReviewActions* actions_;
    /// When a processing began.
    struct Earlier {
        int64_t run = 0;  ///< that was shown
        size_t count = 0;
    };
    std::optional<Earlier> earlier_;
};

}  // namespace noctule::ui
