// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/widgets/gallery.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/widgets/widgets.h"

namespace noctule::ui {

namespace {

QVBoxLayout* addColumn(QHBoxLayout* columns, int width) {
    auto* widget = new QWidget;
    widget->setMinimumWidth(Theme::get().px(width));
    auto* column = new QVBoxLayout(widget);
    columns->addWidget(widget);
    return column;
}

template <class... Widgets>
QWidget* rowOf(Widgets*... widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    (layout->addWidget(widgets), ...);
    layout->addStretch(1);
    return row;
}

QWidget* makeTakeRow(Tone tone, const QString& name, const QString& length, int rating) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new StatusDot(tone, "state"));
    layout->addWidget(new ElidedLabel(name, TextRole::kBody, Ink::kValue, true));
    layout->addWidget(new Label(length, TextRole::kBody, Ink::kHint));
    layout->addStretch(1);
    layout->addWidget(new RatingStars(rating));
    return row;
}

QTableWidget* makeTable() {
    auto* table = new QTableWidget(4, 3);
    table->setHorizontalHeaderLabels({"Joint", "Mean", "Worst"});
    table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeaderItem(1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->horizontalHeaderItem(2)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const char* const joints[] = {"Neck", "Left shoulder", "Left elbow", "Left knee"};
    for (int row = 0; row < 4; ++row) {
        table->setItem(row, 0, new QTableWidgetItem(joints[row]));
        for (int column = 1; column < 3; ++column) {
            auto* item = new QTableWidgetItem(QString("%1°").arg(1.4 + row * column));
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    }
    table->verticalHeader()->hide();
    table->setShowGrid(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table->selectRow(3);
    table->setMinimumHeight(Theme::get().px(5 * 28));
    return table;
}

void fillSession(QVBoxLayout* column) {
    auto* title = new DockTitle("Stage tests");
    title->setHint("Performer 1");
    title->addAction(new ToolButton("more", "Session actions"));
    column->addWidget(title);
    column->addWidget(new SectionHeader("Takes", "Rating"));
    column->addWidget(makeTakeRow(Tone::kOk, "walk_001", "0:42", 5));
    column->addWidget(makeTakeRow(Tone::kWarn, "turn_001", "0:33", 2));
    column->addWidget(makeTakeRow(Tone::kError, "turn_002", "0:35", 0));
    column->addWidget(makeTakeRow(Tone::kNeutral, "turn_003", "0:36", 4));
    column->addWidget(new Divider);
    column->addWidget(new SectionHeader("Results of turn_003"));
    auto* shown = new QCheckBox("A All sensors, smoothed");
    shown->setChecked(true);
    column->addWidget(shown);
    column->addWidget(new QCheckBox("B Gyroscopes only"));
    auto* partly = new QCheckBox("Partly");
    partly->setTristate(true);
    partly->setCheckState(Qt::PartiallyChecked);
    column->addWidget(partly);
    auto* off = new QCheckBox("Cannot be chosen");
    off->setEnabled(false);
    column->addWidget(off);
    auto* smooth = new QRadioButton("Smoothed");
    smooth->setChecked(true);
    column->addWidget(smooth);
    column->addWidget(new QRadioButton("Filtered"));
    column->addWidget(rowOf(makeButton(ButtonKind::kOutlined, "Reprocess", "redo")));
    auto* more = new FormRows;
    more->addValue("Source offsets", "18 November");
    more->addValue("Rest pose", "Today, 10:22");
    column->addWidget(new CollapsibleSection("Made with", more));
    column->addWidget(
        new EmptyState("Takes of this session will be listed here.", "Record a take", "record"));
}

void fillControls(QVBoxLayout* column) {
    auto* steps = new StepBar({"Connect", "Calibrate", "Record", "Review", "Export"});
    steps->setState(0, StepBar::State::kDone);
    steps->setState(1, StepBar::State::kAttention);
    steps->setCurrent(3);
    column->addWidget(rowOf(steps));
    column->addWidget(rowOf(new Chip(Tone::kOk, "18/18 boards"), new Chip(Tone::kError, "17/18 boards"),
                            new Chip(Tone::kNeutral, "NB-000123", "usb"),
                            new Chip(Tone::kWarn, "Rest pose due"),
                            makeButton(ButtonKind::kRecord, "Record", "record", QKeySequence("Ctrl+R"))));
    auto* off = makeButton(ButtonKind::kOutlined, "Export again");
    off->setDisabledBecause("Nothing was written yet.");
    column->addWidget(rowOf(makeButton(ButtonKind::kPrimary, "Export", "export", QKeySequence("Ctrl+E")),
                            makeButton(ButtonKind::kOutlined, "Close", {}, QKeySequence("Esc")), off,
                            makeButton(ButtonKind::kText, "Save as own preset")));
    auto* play = new ToolButton("play", "Play", QKeySequence("Space"));
    play->setPrimary(true);
    play->setTargetSize(44, 30);
    auto* loop = new ToolButton("loop", "Loop", QKeySequence("Ctrl+L"));
    loop->setCheckable(true);
    loop->setChecked(true);
    auto* next = new ToolButton("next", "Next frame", QKeySequence("Right"));
    next->setDisabledBecause("This is the last frame.");
    column->addWidget(rowOf(new ToolButton("prev", "Frame before"), play, next, loop,
                            new KeyHint(QKeySequence("F1")), new QPushButton("Plain"),
                            new StatusDot(Tone::kAccent, "chosen")));
    auto* tabs = new QTabBar;
    for (const char* name : {"Confidence", "Ranges", "Raw sound", "Joint angles"})
        tabs->addTab(name);
    column->addWidget(tabs);
    auto* form = new FormRows(100);
    auto* range = new QComboBox;
    range->addItems({"In to out of each take", "All"});
    form->addRow("Range", range);
    auto* frames = new QSpinBox;
    frames->setSuffix(" per second");
    frames->setValue(60);
    form->addRow("Frames", frames);
    form->addRow("File name", new QLineEdit("{take}_{fps}"));
    form->addHint("turn_003_60.fbx, nothing is overwritten: a second export gets _2");
    auto* locked = new QLineEdit("locked");
    locked->setEnabled(false);
    form->addRow("Folder", locked);
    form->addControl(new QCheckBox("Hold feet on their contacts"));
    column->addWidget(form);
    column->addWidget(new SearchField("Find a session or take"));
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setValue(40);
    column->addWidget(slider);
    auto* progress = new ProgressLine;
    progress->setText("turn_003: ranges, 6 s left");
    progress->setFraction(0.6);
    column->addWidget(progress);
    column->addWidget(new QPlainTextEdit(QString("Second turn is the good one.\n").repeated(40)));
}

void fillReport(QVBoxLayout* column) {
    auto* title = new DockTitle("Report");
    title->addAction(makeButton(ButtonKind::kText, "Open full report"));
    column->addWidget(title);
    auto* verdict = new VerdictHeader;
    verdict->setVerdict(
        Tone::kOk, "Good take",
        "Usable from in to out. The left knee is less certain after 0:12, when its strap moved.");
    column->addWidget(verdict);
    auto* cards = new QGridLayout;
    cards->addWidget(new ValueCard("2.1°", "mean joint error\nagainst the reference"), 0, 0);
    cards->addWidget(new ValueCard("91 %", "of frames backed\nby ranges"), 0, 1);
    column->addLayout(cards);
    auto* problem =
        new ProblemCard(Tone::kError, "Left foot sends nothing",
                        "Board 15 fell silent at 10:42:07. Push its plug in until it clicks; if the light "
                        "stays dark, change the cable.");
    problem->addAction("Blink board 15", "blink");
    problem->addAction("Go on without it");
    column->addWidget(problem);
    auto* warning = new ProblemCard(Tone::kWarn, "Source 6 is faint", "Belly, right: 9 dB below the others.");
    warning->setClosable(true);
    column->addWidget(warning);
    column->addWidget(makeTable());
    auto* meter = new BarMeter;
    meter->setValue(0.71, Tone::kWarn, "71 percent of ranges");
    column->addWidget(meter);
    column->addStretch(1);
    auto* export_button = makeButton(ButtonKind::kPrimary, "Export", "export", QKeySequence("Ctrl+E"));
    column->addWidget(export_button);
}

}  // namespace

std::unique_ptr<QWidget> makeGallery() {
    auto gallery = std::make_unique<QWidget>();
    auto* columns = new QHBoxLayout(gallery.get());
    columns->setContentsMargins(0, 0, 0, 0);
    fillSession(addColumn(columns, 248));
    columns->addWidget(new Divider(Qt::Vertical));
    fillControls(addColumn(columns, 560));
    columns->addWidget(new Divider(Qt::Vertical));
    fillReport(addColumn(columns, 295));
    return gallery;
}

}  // namespace noctule::ui
