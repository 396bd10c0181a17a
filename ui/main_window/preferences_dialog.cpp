// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/language/language.h"
#include "ui/main_window/look.h"
#include "ui/models/countdown_setting.h"
#include "ui/models/file_choice.h"
#include "ui/models/tones.h"
#include "ui/models/voice.h"
#include "ui/style/lengths.h"
#include "ui/style/theme.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kLabels = 140, kDeviceName = Qt::UserRole + 1;
constexpr std::array kTextSizes{75, 90, 100, 110, 125, 150};

FormRows* addSection(QVBoxLayout& column, const QString& title) {
    column.addWidget(new SectionHeader(title));
    auto* rows = new FormRows(kLabels);
    column.addWidget(rows);
    return rows;
}

}  // namespace

PreferencesDialog::PreferencesDialog(Studio& studio, QWidget* parent) : QDialog(parent), studio_(studio) {
    setWindowTitle(tr("Preferences"));
    auto* outer = makeColumn(this, {24, 20, 24, 20}, 12);
    outer->addWidget(new Label(tr("Preferences"), TextRole::kPage, Ink::kValue, true));
    auto* content = new QWidget;
    auto* column = makeColumn(content, {0, 0, 8, 0}, 12);
    addLook(*column);
    addLanguage(*column);
    addUnits(*column);
    addView3d(*column);
    addFolders(*column);
    addRecording(*column);
    addSound(*column);
    addSaving(*column);
    column->addStretch();
    outer->addWidget(new ScrollArea(content), 1);
    auto* row = addRow(outer);
    row->addWidget(new Label(tr("Every change acts at once and is kept."), TextRole::kSecondary, Ink::kHint),
                   1);
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(&studio_.suits(), &LiveSuits::changed, this, &PreferencesDialog::showWhyNotAnew);
    showWhyNotAnew();
    fit();
}

void PreferencesDialog::setCalibrating(bool calibrating) {
    calibrating_ = calibrating;
    showWhyNotAnew();
}

/// Language and units make the window anew, without what goes on in it.
void PreferencesDialog::showWhyNotAnew() {
    const QString why = studio_.suits().isTakeOpen()
                            ? tr("A take is being recorded. Change this when it has ended.")
                        : calibrating_ ? tr("A calibration is under way. Finish or leave it first.")
                                       : QString();
    for (QComboBox* box : {language_, units_}) {
        box->setEnabled(why.isEmpty());
        box->setToolTip(why);
    }
}

void PreferencesDialog::fit() {
    placeDialog(*this, {Theme::get().px(560), Theme::get().px(740)});
}

void PreferencesDialog::addLook(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Look"));
    scheme_ = new QComboBox;
    scheme_->addItems(
        {tr("Dark"), tr("Light"), tr("As the desktop"), tr("High contrast")});  // in the order of Scheme
    scheme_->setCurrentIndex(static_cast<int>(Theme::get().scheme()));
    rows->addRow(tr("Colours"), scheme_);

    text_size_ = new QComboBox;
    for (const int percent : kTextSizes)
        text_size_->addItem(tr("%1 %", "size of text in percent").arg(percent), percent);
    text_size_->setCurrentIndex(text_size_->findData(qRound(Theme::get().scale() * 100)));
    rows->addRow(tr("Size of text"), text_size_);

    auto* motion = new QCheckBox(tr("Reduce motion"));
    motion->setChecked(Theme::get().reduceMotion());
    rows->addControl(motion);

    connect(scheme_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        Theme::get().setScheme(static_cast<Scheme>(index));
        keepLook(studio_.settings());
    });
    connect(text_size_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        Theme::get().setScale(text_size_->currentData().toInt() / 100.0);
        keepLook(studio_.settings());
        fit();
    });
    connect(motion, &QCheckBox::toggled, this, [this](bool reduce) {
        Theme::get().setReduceMotion(reduce);
        keepLook(studio_.settings());
    });
}

void PreferencesDialog::addLanguage(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Language"));
    language_ = new QComboBox;
    language_->addItem(tr("As the desktop"), QString());
    language_->addItem(QStringLiteral("English"), "en");
    language_->addItem(QStringLiteral("Deutsch"), "de");
    language_->setCurrentIndex(std::max(0, language_->findData(chosenLanguage(studio_.settings()))));
    rows->addRow(tr("Language"), language_);
    connect(language_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        if (language_->currentData().toString() == chosenLanguage(studio_.settings()))
            return;
        chooseLanguage(studio_.settings(), language_->currentData().toString());
        accept();
        emit wordsChanged();
    });
}

void PreferencesDialog::addUnits(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Units"));
    units_ = new QComboBox;
    units_->addItems({tr("Metric: metres, centimetres"), tr("Imperial: feet, inches")});  // as in Units
    units_->setCurrentIndex(static_cast<int>(chosenUnits()));
    rows->addRow(tr("Lengths"), units_);
    rows->addHint(tr(
        "For people and rooms. Errors of measurement stay in millimetres; plots, places of boards and files "
        "stay metric. Any unit may be typed: 5'11\", 71 in, 180 cm, 1.8 m."));
    connect(units_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        const auto units = static_cast<Units>(index);
        if (units == chosenUnits())
            return;
        chooseUnits(units);
        accept();
        emit wordsChanged();
    });
}

void PreferencesDialog::addView3d(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("3D picture"));
    auto* navigation = new QComboBox;
    navigation->addItem(tr("As in Blender: middle button"), "blender");
    navigation->addItem(tr("As in Maya: Alt and a button"), "maya");
    navigation->setCurrentIndex(
        std::max(0, navigation->findData(studio_.settings().value("scene/navigation"))));
    rows->addRow(tr("Turn and move"), navigation);
    connect(navigation, QOverload<int>::of(&QComboBox::activated), this, [this, navigation] {
        studio_.settings().setValue("scene/navigation", navigation->currentData());
    });
}

void PreferencesDialog::addFolders(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Folders"));
    auto* line = new QWidget;
    auto* row = makeRow(line, {}, 8);
    folder_ = new ElidedLabel(QDir::toNativeSeparators(studio_.sessionsFolder()));
    folder_->setElideMode(Qt::ElideMiddle);
    auto* choose = new ToolButton("folder", tr("Choose the folder for new sessions"));
    row->addWidget(folder_, 1);
    row->addWidget(choose);
    line->setFocusProxy(choose);
    rows->addRow(tr("New sessions go into"), line);
    connect(choose, &QToolButton::clicked, this, &PreferencesDialog::chooseSessionsFolder);
}

void PreferencesDialog::chooseSessionsFolder() {
    const QString folder =
        FileChoice{
            .kind = "sessions_home", .title = tr("Folder for new sessions"), .at = studio_.sessionsFolder()}
            .folder(this);
    if (folder.isEmpty())
        return;
    studio_.settings().setValue("folders/sessions", folder);
    folder_->setText(QDir::toNativeSeparators(folder));
}

void PreferencesDialog::addRecording(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Recording"));
    countdown_ = new QComboBox;
    for (const int seconds : CountdownSetting::kChoices_s)
        countdown_->addItem(RecordBar::secondsChoice(seconds), seconds);
    rows->addRow(tr("Countdown"), countdown_);
    const auto show_countdown = [this] {
        countdown_->setCurrentIndex(countdown_->findData(CountdownSetting::get().seconds()));
    };
    connect(&CountdownSetting::get(), &CountdownSetting::changed, this, show_countdown);
    connect(countdown_, QOverload<int>::of(&QComboBox::activated), this,
            [this] { CountdownSetting::get().setSeconds(countdown_->currentData().toInt()); });
    show_countdown();
    addRemoteStart(*rows);
}

void PreferencesDialog::addRemoteStart(FormRows& rows) {
    RemoteStart& remote = studio_.remoteStart();
    auto* allowed = new QCheckBox(tr("Other programs may start and stop recordings"));
    allowed->setToolTip(tr("They send CaptureStart and CaptureStop over UDP, as motion capture systems do."));
    allowed->setChecked(remote.isAllowed());
    auto* port = new QSpinBox;
    port->setRange(1, 65535);
    port->setKeyboardTracking(false);
    port->setValue(remote.port());
    auto* problem = new Label({}, TextRole::kSecondary, Ink::kHint);
    problem->setWordWrap(true);
    rows.addControl(allowed);
    rows.addRow(tr("UDP port"), port);
    rows.addControl(problem);
    const auto show = [&remote, port, problem] {
        port->setEnabled(remote.isAllowed());
        problem->setText(remote.problem().isEmpty() && remote.isListening()
                             ? tr("Listening for other programs on this port.")
                             : remote.problem());
    };
    connect(allowed, &QCheckBox::toggled, &remote, &RemoteStart::setAllowed);
    connect(port, QOverload<int>::of(&QSpinBox::valueChanged), &remote, &RemoteStart::setPort);
    connect(&remote, &RemoteStart::changed, this, show);
    show();
}

void PreferencesDialog::addSound(QVBoxLayout& column) {
    FormRows* rows = addSection(column, tr("Sound"));
    Voice& voice = Voice::get();
    auto* spoken = new QCheckBox(tr("Spoken cues"));
    spoken->setToolTip(
        tr("Countdown, start and stop of recordings, and the next step of a calibration are spoken."));
    spoken->setChecked(voice.isOn());
    spoken->setEnabled(voice.canSpeak());
    rows->addControl(spoken);
    if (!voice.canSpeak())
        rows->addHint(
            tr("No speech is installed on this computer. On Debian: speech-dispatcher and "
               "qtspeech5-speechd-plugin."));
    connect(spoken, &QCheckBox::toggled, &voice, &Voice::setOn);
    addSoundDevice(*rows);
}

void PreferencesDialog::addSoundDevice(FormRows& rows) {
    Tones& tones = Tones::get();
    device_ = new QComboBox;
    device_->addItem(tr("As the desktop"), QString());
    const auto offer = [this](const SoundDevice& device, const QString& words) {
        device_->addItem(words, device.id);
        device_->setItemData(device_->count() - 1, device.name, kDeviceName);
    };
    for (const SoundDevice& device : tones.devices())
        offer(device, device.name);
    const SoundDevice chosen = tones.device();
    if (device_->findData(chosen.id) < 0)
        offer(chosen, tr("%1, not there", "a sound device").arg(chosen.name));
    device_->setCurrentIndex(device_->findData(chosen.id));
    device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    rows.addRow(tr("Tones on"), device_);
    rows.addHint(tr("Spoken cues are played where the desktop plays its speech."));
    connect(device_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        const QString id = device_->currentData().toString();
        Tones::get().setDevice({id, device_->currentData(kDeviceName).toString()});
        Tones::get().play();
    });
}

void PreferencesDialog::addSaving(QVBoxLayout& column) {
    column.addWidget(new SectionHeader(tr("Saving")));
    column.addWidget(
        (new Label(tr("There is nothing to save by hand: every change of a session is on disk within a "
                      "second, and a take is never changed, results are added to it. After a crash the "
                      "start page says what is safe."),
                   TextRole::kBody, Ink::kLabel))
            ->wrapped());
}

}  // namespace noctule::ui
