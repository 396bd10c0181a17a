// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/options.h"

#include "app/batch/robot_profiles.h"
#include "app/virtual_robot/control_line.h"

namespace noctule::virtual_robot {

const std::vector<batch::Option>& optionTable() {
    using namespace batch;
    static const std::vector<Option> options = {
        text("robot", "R.urdf", "the robot; a xacro file has to be expanded first"),
        text("profile", "P.json", "which joints are its arms; else found by the robot's name or made"),
        armsOption(),
        trunkOption(),
        text("udp", "HOST:PORT", "listen there for datagrams, port 0 for any free one"),
        text("rosbridge", "HOST:PORT", "be a rosbridge server there, port 0 for any free one"),
        number("rate", "HZ", 1, 1000, "states a second").orElse("200"),
        number("latency-ms", "MS", 0, 10'000, "until a command is heard").orElse("0"),
        number("lag-ms", "MS", 0, 10'000, "time constant of every joint").orElse("20"),
        number("refuse-beyond", "RAD", 0, 100,
               "a command farther from where a joint is is refused; 0: none is")
            .orElse("0.5"),
        text("control", "HOST:PORT", "listen there for faults, one a line"),
        flag("help", "this text")};
    return options;
}

Result<Options> parseOptions(const std::vector<std::string>& words) {
    auto arguments = batch::Arguments::parse(words, optionTable());
    if (!arguments)
        return arguments.error();
    if (!arguments->operands().empty() || !arguments->given("robot"))
        return Error{ErrorKind::kUsage,
                     arguments->operands().empty() ? "no robot is given"
                                                   : "'" + arguments->operands()[0] + "' is no option",
                     std::string("Write for example: ") + kExample};
    if (!arguments->given("udp") && !arguments->given("rosbridge"))
        return Error{ErrorKind::kUsage, "the robot has no interface",
                     "Give --udp HOST:PORT, --rosbridge HOST:PORT or both"};
    Options options{std::move(*arguments)};
    const batch::Arguments& given = options.arguments;
    const std::pair<const char*, std::optional<virtual_suit::Address>*> addresses[] = {
        {"udp", &options.udp}, {"rosbridge", &options.rosbridge}, {"control", &options.control}};
    for (const auto& [name, into] : addresses) {
        if (!given.given(name))
            continue;
        const auto address = virtual_suit::parseAddress(given.text(name), std::string("--") + name);
        if (!address)
            return address.error();
        *into = *address;
    }
    options.body.latency_s = *given.number("latency-ms") / 1000;
    options.body.lag_s = *given.number("lag-ms") / 1000;
    options.body.refuse_beyond = *given.number("refuse-beyond");
    return options;
}

std::string helpText() {
    return "noctule-virtual-robot: a robot without hardware, for studios that have none at hand.\n\n"
           "usage: noctule-virtual-robot --robot R.urdf --udp HOST:PORT | --rosbridge HOST:PORT [OPTIONS]\n\n"
           "options:\n" +
           batch::optionList(optionTable()) +
           "\nIt prints the addresses that `noctule --batch drive --to` takes, then works until Ctrl-C. The\n"
           "control port takes one command a line and answers ok or error:\n" +
           controlHelp() + "\n" + batch::exitCodeLine(batch::standInExitCodes()) + "\nexample: " + kExample +
           "\n";
}

}  // namespace noctule::virtual_robot
