// SPDX-License-Identifier: Apache-2.0
// What the marks of the body map stand for; beside each other where there is room, else below each other.
#pragma once

#include <QWidget>
#include <vector>

namespace noctule::ui {

class MapLegend : public QWidget {
    Q_OBJECT
public:
    enum class Shows {
        kPlaces,  ///< where boards and sources sit
        kState,   ///< and what arrives from them
    };
    explicit MapLegend(Shows shows = Shows::kPlaces, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    enum class Mark { kBoard, kWorking, kSilent, kSource };
    struct Entry {
        Mark mark;
        QString words;
    };
    int widthOf(const Entry& entry) const;
    int rowHeight() const;
    static QColor colorOf(Mark mark);

    std::vector<Entry> entries_;
};

}  // namespace noctule::ui
