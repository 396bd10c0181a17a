// SPDX-License-Identifier: Apache-2.0
// Scrolls up and down and never sideways: the content keeps to the width and the area is never narrower than
// the content can be, so that nothing clips at large type. Wrapped texts take the height that they need at
// that width, and no more. The focus that the operator moves scrolls into view.
#pragma once

#include <QScrollArea>

namespace noctule::ui {

class ScrollArea : public QScrollArea {
    Q_OBJECT
public:
    explicit ScrollArea(QWidget* content = nullptr, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// How much of a row of the content stands in view at the lower edge, cut; 0: none is. Scrolled to the
    /// top.
    int cutRow_px() const;
    bool focusNextPrevChild(bool next) override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void follow(QWidget* before, QWidget* now);
    void fitContent();

    void askAllSizes();

    bool is_just_shown_ = false;
    bool is_outdated_ = false;  ///< the theme changed while nobody saw it
    bool is_fitted_ = false;    ///< the content's least height is of fitContent()
};

}  // namespace noctule::ui
