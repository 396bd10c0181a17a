// SPDX-License-Identifier: Apache-2.0
// The full report of the open take inside the window: parts at the left, text, tables and drawings to scroll,
// zoom, search and copy, and saving as HTML or PDF; its table of joints as CSV. Where there is little room
// the parts fold into a list that opens, in a second row of the head, and the text has the whole width.
#pragma once

#include <QTextBrowser>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>

#include "ui/models/review_context.h"
#include "ui/views/report/full_report.h"
#include "ui/views/report/report_html.h"

class QBoxLayout;
class QComboBox;
class QListWidget;

namespace noctule::ui {

class Button;
class ElidedLabel;
class Label;
class SearchField;

/// Draws the figures when the page asks for them.
class ReportBrowser : public QTextBrowser {
    Q_OBJECT
public:
    explicit ReportBrowser(QWidget* parent = nullptr);

    void setParts(std::vector<ReportPart> parts);
    double zoom() const { return zoom_; }
    void setZoom(double zoom);  ///< 0.5 .. 3
    size_t figureCount() const { return report_.figures.size(); }
    /// Lays the report out for paper and writes it; false: the file could not be written.
    bool savePdf(const QString& path);

signals:
    void zoomChanged();

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    int margin() const;
    int pageWidth() const;
    void layOut();

    std::vector<ReportPart> parts_;
    ReportDocument report_;
    double zoom_ = 1;
    int laid_out_width_ = 0;
    QTimer resized_;
};

class ReportView : public QWidget {
    Q_OBJECT
public:
    ReportView(ReviewContext& review, FullReport& report, QWidget* parent = nullptr);

    ReportBrowser& page() { return *page_; }
    void enter();  ///< makes the report when it is not there yet
    /// The table that `evaluate --csv` writes.
    void saveJoints(const QString& path);

signals:
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeHead();
    QWidget* makeZoom();
    void fold();
    void refresh();
    void saveHtml();
    /// A job writes what `written` makes of the report; nothing when `path` is empty.
    void save(const QString& path, std::function<std::string(const ReportData&)> written);
    void savePdf();
    void find(const QString& text);

    ReviewContext& review_;
    FullReport& report_;
    ElidedLabel* title_;
    Label* zoom_label_;
    SearchField* search_;
    QListWidget* contents_;
    ReportBrowser* page_;
    QComboBox* parts_;  ///< the same as contents_
    Button* save_;
    QWidget *zoom_, *beside_ = nullptr, *second_ = nullptr;
    QBoxLayout *first_row_ = nullptr, *second_row_ = nullptr;
    std::shared_ptr<const ReportData> shown_;
};

}  // namespace noctule::ui
