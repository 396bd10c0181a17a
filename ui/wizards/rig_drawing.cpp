// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/rig_drawing.h"

#include <QAccessible>
#include <QPainter>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"
#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {

RigDrawing::RigDrawing(QWidget* parent) : QWidget(parent) {
    describe(*this, {.role = QAccessible::Graphic});
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        figure_image_ = QImage();
        updateGeometry();
        update();
    });
}

void RigDrawing::setPicture(const RigPicture& picture) {
    if (picture == picture_)
        return;
    picture_ = picture;
    update();
}

void RigDrawing::setBody(std::shared_ptr<const BodyFigure> figure, const Suit& suit) {
    figure_ = std::move(figure);
    suit_ = suit;
    figure_image_ = QImage();
    update();
}

void RigDrawing::setDescription(const QString& words) {
    if (words == accessibleName())
        return;
    setAccessibleName(words);
}

/// It fills what its page leaves.
QSize RigDrawing::sizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(320), theme.px(170)};
}

QSize RigDrawing::minimumSizeHint() const {
    return sizeHint();
}

void RigDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    RigCanvas canvas(painter, size());
    switch (picture_.kind) {
        case RigPicture::Kind::kPlate:
            return paintPlate(canvas, picture_);
        case RigPicture::Kind::kTurntable:
            return paintTurntable(canvas, picture_);
        case RigPicture::Kind::kJig:
            return paintJig(canvas, picture_);
        case RigPicture::Kind::kStand:
            if (figure_)
                paintStand(canvas, picture_, *figure_, suit_, figure_image_);
    }
}

}  // namespace noctule::ui
