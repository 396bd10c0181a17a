// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/program.h"

#include <QCoreApplication>
#include <QTimer>
#include <algorithm>
#include <cstdio>

#include "app/batch/robot_profiles.h"
#include "app/virtual_robot/control_line.h"
#include "app/virtual_robot/options.h"
#include "app/virtual_robot/robot_ports.h"
#include "app/virtual_suit/control_port.h"
#include "core/robot/live_drive.h"
#include "core/robot/urdf_reader.h"
#include "devices/machine/clock.h"

namespace noctule::virtual_robot {
namespace {

constexpr int kCancelEvery_ms = 50;
constexpr int kBodyEvery_ms = 1;

int endWithError(const Error& error) {
    batch::Console(false, false, "noctule-virtual-robot").error(error);
    return static_cast<int>(error.kind);
}

void sayLine(const std::string& text) {
    std::puts(text.c_str());
    std::fflush(stdout);
}

class RobotProgram {
public:
    RobotProgram(const Options& options, const robot::DrivenParts& parts)
        : options_(options), body_(parts, options.body) {
        for (const robot::RobotArm& arm : parts.arms)
            arm_names_.push_back(arm.profile.name);
    }

    Status open() {
        if (options_.udp) {
            auto port = UdpPort::open(*options_.udp, body_);
            if (!port)
                return port.error();
            add(std::move(*port));
        }
        if (options_.rosbridge) {
            auto port = RosbridgePort::open(*options_.rosbridge, body_, arm_names_);
            if (!port)
                return port.error();
            add(std::move(*port));
        }
        if (!options_.control)
            return Done{};
        auto control = virtual_suit::ControlPort::open(*options_.control,
                                                       [this](const auto& line) { return obey(line); });
        if (!control)
            return control.error();
        control_ = std::move(*control);
        sayLine("control: " + virtual_suit::toText(control_->where()));
        return Done{};
    }

    int run(const CancelFlag& cancel) {
        QTimer cancel_timer, body_timer;
        QObject::connect(&cancel_timer, &QTimer::timeout, &cancel_timer, [&] {
            if (cancel.cancelled())
                QCoreApplication::exit(static_cast<int>(ErrorKind::kCancelled));
        });
        cancel_timer.start(kCancelEvery_ms);
        body_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&body_timer, &QTimer::timeout, &body_timer, [this] { live(); });
        body_timer.start(kBodyEvery_ms);
        return QCoreApplication::exec();
    }

private:
    void add(std::unique_ptr<RobotPort> port) {
        sayLine("robot: " + port->address());
        ports_.push_back(std::move(port));
    }

    /// A robot whose program has stalled neither moves nor tells anything.
    void live() {
        const int64_t now_ns = steadyNow_ns();
        if (cut_until_ns_ != 0 && now_ns >= cut_until_ns_) {
            cut_until_ns_ = 0;
            setReachable(true);
        }
        if (now_ns < stalled_until_ns_)
            return;
        body_.advance(now_ns);
        if (now_ns < next_state_ns_)
            return;
        next_state_ns_ = now_ns + std::llround(1e9 / *options_.arguments.number("rate"));
        for (const auto& port : ports_)
            port->tellState();
    }

    void setReachable(bool reachable) {
        for (const auto& port : ports_)
            port->setReachable(reachable);
    }

    Status setStuck(const std::string& joint, bool stuck) {
        if (body_.setStuck(joint, stuck))
            return Done{};
        return Error{ErrorKind::kUsage, "no joint is called " + joint,
                     "Name one of " + batch::listed(body_.joints())};
    }

    Status obey(const std::string& line) {
        const auto command = parseControlLine(line);
        if (!command)
            return command.error();
        const int64_t until_ns = steadyNow_ns() + std::llround(command->number * 1e9);
        switch (command->kind) {
            case FaultKind::kStall:
                stalled_until_ns_ = until_ns;
                break;
            case FaultKind::kCut:
                cut_until_ns_ = until_ns;
                setReachable(false);
                break;
            case FaultKind::kLatency:
                body_.setLatency(command->number / 1000);
                break;
            case FaultKind::kLag:
                body_.setLag(command->number / 1000);
                break;
            case FaultKind::kRefuse:
            case FaultKind::kAccept:
                body_.setRefusesAll(command->kind == FaultKind::kRefuse);
                break;
            case FaultKind::kJointStuck:
            case FaultKind::kJointFree:
                return setStuck(command->joint, command->kind == FaultKind::kJointStuck);
            case FaultKind::kQuit:
                QTimer::singleShot(0, QCoreApplication::instance(), [] { QCoreApplication::exit(0); });
        }
        return Done{};
    }

    const Options& options_;
    RobotBody body_;
    std::vector<std::string> arm_names_;
    std::vector<std::unique_ptr<RobotPort>> ports_;
    std::unique_ptr<virtual_suit::ControlPort> control_;
    int64_t stalled_until_ns_ = 0, cut_until_ns_ = 0, next_state_ns_ = 0;
};

int runChecked(const std::vector<std::string>& words, const CancelFlag& cancel) {
    const auto options = parseOptions(words);
    if (!options)
        return endWithError(options.error());
    const batch::Arguments& arguments = options->arguments;
    const auto model = robot::readUrdf(arguments.text("robot"), &cancel);
    if (!model)
        return endWithError(model.error());
    const auto profile = batch::robotProfile(*model, arguments.text("profile"));
    if (!profile)
        return endWithError(profile.error());
    const auto parts = robot::drivenParts(*model, *profile, batch::partsChoice(arguments));
    if (!parts)
        return endWithError(parts.error());
    RobotProgram program(*options, *parts);
    if (Status open = program.open(); !open)
        return endWithError(open.error());
    return program.run(cancel);
}

}  // namespace

int runVirtualRobot(const std::vector<std::string>& words, const CancelFlag& cancel) {
    if (std::ranges::find(words, "--help") != words.end()) {
        std::fputs(helpText().c_str(), stdout);
        return 0;
    }
    try {
        return runChecked(words, cancel);
    } catch (const std::exception& mistake) {
        return endWithError({ErrorKind::kInternal, std::string("internal error: ") + mistake.what(),
                             "Report it with the command line and the URDF"});
    }
}

}  // namespace noctule::virtual_robot
