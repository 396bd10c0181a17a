// SPDX-License-Identifier: Apache-2.0
// The documents of resources/docs inside the studio: contents at the left, one document at a time, links and
// a way back. Links that leave the documents open in the desktop's browser.
#pragma once

#include <QDialog>
#include <QListWidget>
#include <QTextBrowser>

namespace noctule::ui {

class HelpWindow : public QDialog {
    Q_OBJECT
public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// "guide": the document of that name.
    void showDocument(const QString& name);
    QTextBrowser& page() { return *page_; }
    QListWidget& contents() { return *contents_; }

private:
    void follow(const QUrl& link);

    QListWidget* contents_;
    QTextBrowser* page_;
};

}  // namespace noctule::ui
