// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/program.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

#include "app/batch/stage_request.h"
#include "app/virtual_suit/announcer.h"
#include "app/virtual_suit/cast_box.h"
#include "app/virtual_suit/control_port.h"
#include "app/virtual_suit/driver_box.h"
#include "app/virtual_suit/options.h"
#include "app/virtual_suit/pty_port.h"
#include "app/virtual_suit/simulated_source.h"
#include "app/virtual_suit/start_instant.h"
#include "app/virtual_suit/take_source.h"
#include "app/virtual_suit/tcp_port.h"
#include "devices/driver_box/discovery.h"

namespace noctule::virtual_suit {
namespace {

constexpr double kDay_s = 86400;
constexpr int kLookForCancel_ms = 50;
constexpr std::chrono::milliseconds kLookForSound{10};

int failed(const Error& error) {
    batch::Console(false, false, "noctule-virtual-suit").error(error);
    return static_cast<int>(error.kind);
}

/// Addresses, and that the boards sit otherwise, for people and for programs that wait for them.
void printLine(const std::string& text) {
    std::puts(text.c_str());
    std::fflush(stdout);
}

void tellLine(const std::string& text) {
    std::fprintf(stderr, "%s\n", text.c_str());
}

Result<SoundOfSuit> openTake(const Options& options) {
    std::optional<int64_t> start_ns;
    if (options.arguments.given("start-at")) {
        const auto start = startInstant(options.arguments.text("start-at"));
        if (!start)
            return start.error();
        start_ns = *start;
    }
    return openTakeSource(options.take(), options.arguments.text("subject"), options.loop(), start_ns);
}

/// Neither one who stands in the rest pose nor a rig is ever done.
Result<SoundOfSuit> openSound(const Options& options) {
    if (!options.take().empty())
        return openTake(options);
    if (options.arguments.given("cast"))
        return openCastBox(options);
    batch::Console console(false, false);
    auto request = batch::stageRequest(options.arguments, console);
    if (!request)
        return request.error();
    request->rig_is_operated = true;
    if (!request->clip)
        request->duration_s = kDay_s;
    else if (options.loop())
        request->comes_back_s = kDay_s;
    auto stage = simulation::prepareStage(*request);
    if (!stage)
        return stage.error();
    return makeSimulatedSource(std::move(*stage));
}

class Program {
public:
    Program(const Options& options, SoundOfSuit sound)
        : options_(options),
          box_(std::move(sound), {options.speed(), options.seed(), options.tcp.has_value()}) {
        box_.tell = tellLine;
    }

    /// False: cancelled.
    bool waitForSound(const CancelFlag& cancel) {
        while (!box_.isReady() && !cancel.cancelled())
            std::this_thread::sleep_for(kLookForSound);
        return !cancel.cancelled();
    }

    /// Every way to the box.
    Status open() {
        using Step = Status (Program::*)();
        for (const Step step :
             {&Program::openTcp, &Program::openPty, &Program::openAnnouncer, &Program::openControl})
            if (Status done = (this->*step)(); !done)
                return done;
        return Done{};
    }

    int run(const CancelFlag& cancel) {
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            if (cancel.cancelled())
                QCoreApplication::exit(static_cast<int>(ErrorKind::kCancelled));
        });
        timer.start(kLookForCancel_ms);
        const int exit_code = QCoreApplication::exec();
        box_.shutDown();
        return exit_code;
    }

private:
    Status openTcp() {
        if (!options_.tcp)
            return Done{};
        auto port = TcpPort::open(*options_.tcp, box_);
        if (!port)
            return port.error();
        tcp_ = (*port)->where();
        return add(std::move(*port));
    }

    Status openPty() {
        if (!options_.pty())
            return Done{};
        auto port = PtyPort::open(box_);
        return port ? add(std::move(*port)) : port.error();
    }

    Status add(std::unique_ptr<Port> port) {
        printLine("studio: " + port->address());
        box_.addPort(std::move(port));
        return Done{};
    }

    Status openAnnouncer() {
        if (!options_.announce_port)
            return Done{};
        auto announcer = Announcer::open(*options_.announce_port, tcp_.host.isLoopback(), [this] {
            return link::announcementOf(box_.hello(), tcp_.port, box_.isBusy());
        });
        if (!announcer)
            return announcer.error();
        announcer_ = std::move(*announcer);
        printLine("announce: udp " + std::to_string(announcer_->port()));
        return Done{};
    }

    Status openControl() {
        if (!options_.control)
            return Done{};
        auto control = ControlPort::open(*options_.control, [this](const auto& line) { return obey(line); });
        if (!control)
            return control.error();
        control_ = std::move(*control);
        printLine("control: " + toText(control_->where()));
        return Done{};
    }

    Status obey(const std::string& line) {
        const auto command = parseControlCommand(line, box_.hello().suit);
        if (!command)
            return command.error();
        if (command->kind == ControlKind::kQuit)
            QTimer::singleShot(0, QCoreApplication::instance(), [] { QCoreApplication::exit(0); });
        const Status done = box_.execute(*command);
        if (done && (command->kind == ControlKind::kSwap || command->kind == ControlKind::kSlip))
            printLine("worn otherwise: " + line);
        return done;
    }

    const Options& options_;
    DriverBox box_;
    Address tcp_;
    std::unique_ptr<Announcer> announcer_;
    std::unique_ptr<ControlPort> control_;
};

int runChecked(const std::vector<std::string>& words, const CancelFlag& cancel) {
    const auto options = parseOptions(words);
    if (!options)
        return failed(options.error());
    auto sound = openSound(*options);
    if (!sound)
        return failed(sound.error());
    Program program(*options, std::move(*sound));
    if (!program.waitForSound(cancel))
        return static_cast<int>(ErrorKind::kCancelled);
    if (Status open = program.open(); !open)
        return failed(open.error());
    return program.run(cancel);
}

}  // namespace

int runVirtualSuit(const std::vector<std::string>& words, const CancelFlag& cancel) {
    if (std::find(words.begin(), words.end(), "--help") != words.end()) {
        std::fputs(helpText().c_str(), stdout);
        return 0;
    }
    try {
        return runChecked(words, cancel);
    } catch (const std::exception& mistake) {
        return failed({ErrorKind::kInternal, std::string("internal error: ") + mistake.what(),
                       "Report it with the command line and the input"});
    }
}

}  // namespace noctule::virtual_suit
