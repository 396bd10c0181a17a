// SPDX-License-Identifier: Apache-2.0
// "Worn by" and "Assign boards": whose suit it is, and which board sits where. A board is found by moving the
// limb it sits on; what is assigned is kept in the performer's suit, by serial number, and can be undone.
#pragma once

#include <QComboBox>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/live/moving_board.h"
#include "ui/models/capture_context.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;
class Label;

class AssignPanel : public QWidget {
    Q_OBJECT
public:
    explicit AssignPanel(CaptureContext& capture, QWidget* parent = nullptr);

    QComboBox& performers() { return *performers_; }
    QComboBox& segments() { return *segments_; }
    Button* findButton() { return find_; }
    Button* assignButton() { return assign_; }
    bool isFinding() const { return finder_ != nullptr; }
    QString words() const;
    /// Takes the place of another; that one gets this one's.
    void swap(int board, int with);

signals:
    /// Which one moves, or -1 when looking ended.
    void boardFound(int board);

private:
    void addWornBy(QVBoxLayout& column);
    void addAssign(QVBoxLayout& column);
    void showPerformers();
    std::string wearer() const;
    void showSuit();
    QString listeningWords() const;
    void find(bool on);
    /// Which board was found stays until another one is.
    void listenAnew();
    void listen();
    void assign();

    CaptureContext& capture_;
    QComboBox *performers_, *segments_;
    Label *measures_, *explained_;
    Button *find_, *assign_;
    QWidget* found_row_;
    std::unique_ptr<MovingBoard> finder_;
    int found_ = -1;
    int heard_s_ = 0, sample_rate_hz_ = 1;  ///< while it listens
    std::optional<int64_t> first_sample_;
    int64_t last_sample_ = 0;
};

}  // namespace noctule::ui
