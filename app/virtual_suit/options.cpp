// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/options.h"

#include <algorithm>

#include "app/batch/help.h"
#include "app/batch/stage_request.h"
#include "devices/driver_box/discovery.h"

namespace noctule::virtual_suit {
namespace {

constexpr const char* kDefaultTcp = "127.0.0.1:41941";
const std::vector<batch::Option>& table() {
    static const std::vector<batch::Option> options = [] {
        using namespace batch;
        std::vector<Option> all = stageOptions();
        for (Option& option : std::vector<Option>{
                 text("take", "T.noctule", "stream a take made before instead of a simulation"),
                 text("cast", "CAST.json",
                      "be the box of one of several performers, as in `simulate --cast`"),
                 text("subject", "NAME",
                      "whose box of the cast, or of a take of several; room: the one of its anchors"),
                 text("start-at", "UTC",
                      "when the cast or the take begins, as 2026-05-01T10:00:00Z, the same for all of its "
                      "boxes; or now. A take without it begins at each START"),
                 flag("loop",
                      "after the end go on: back through the motion and forth again, or the take "
                      "from its beginning; else silence follows"),
                 text("tcp", "HOST:PORT",
                      "listen there, port 0 for any free one (127.0.0.1:41941 when there is no --pty)"),
                 flag("pty", "offer a serial line too: a pseudo-terminal, whose path is printed"),
                 flag("announce", "let studios on the network find this box"),
                 whole("announce-port", "N", 0, 65535, "UDP port of --announce, 0 for any free one")
                     .orElse(std::to_string(link::kDiscoveryPort)),
                 number("speed", "N", 0.01, 1000, "seconds of the suit in one second").orElse("1"),
                 text("control", "HOST:PORT", "listen there for commands to rig and box, one a line"),
                 whole("seed", "N", 0, 9007199254740991, "seed of everything random").orElse("1"),
                 flag("help", "this text")})
            all.push_back(option);
        return all;
    }();
    return options;
}

Error usage(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, what, remedy};
}

/// One of the three sources, and nothing that the others need.
Status checkSource(const batch::Arguments& arguments) {
    if (!arguments.operands().empty())
        return usage("'" + arguments.operands()[0] + "' is no option",
                     "Write --take " + arguments.operands()[0] + " or --motion " + arguments.operands()[0]);
    std::vector<std::string> given;
    for (const char* name : {"motion", "rig", "take", "cast"})
        if (arguments.given(name))
            given.push_back("--" + std::string(name));
    if (given.empty())
        return usage(
            "nothing to play is given",
            std::string("Give --motion M.bvh, --rig rest, jig, level, turntable or bag, --cast CAST.json or "
                        "--take T.noctule, for example: ") +
                kExample);
    if (given.size() > 1)
        return usage(given[0] + " and " + given[1] + " exclude each other", "Give one of them");
    if (arguments.given("take"))
        for (const char* name : {"scenario", "suit", "actor", "rest-seconds", "bvh-unit"})
            if (arguments.given(name))
                return usage("--" + std::string(name) + " does not go with --take, which is recorded already",
                             "Leave it out, or play a --motion");
    for (const char* name : {"subject", "start-at"}) {
        if (arguments.given(name) != arguments.given("cast") && !arguments.given("take"))
            return arguments.given("cast")
                       ? usage("--cast without --" + std::string(name),
                               "Give --subject NAME and --start-at UTC, the same instant for all boxes")
                       : usage("--" + std::string(name) + " without --cast or --take",
                               "Give --cast CAST.json or --take T.noctule too");
    }
    if (arguments.given("cast"))
        for (const char* name : {"suit", "actor", "up", "height", "bones"})
            if (arguments.given(name))
                return usage("--" + std::string(name) + " does not go with --cast, which says it of each",
                             "Leave it out");
    if (arguments.given("announce-port") && !arguments.given("announce"))
        return usage("--announce-port without --announce", "Give --announce too");
    return Done{};
}

Status addAddresses(Options& options) {
    const batch::Arguments& arguments = options.arguments;
    if (arguments.given("tcp") || !options.pty()) {
        const auto tcp = parseAddress(arguments.given("tcp") ? arguments.text("tcp") : kDefaultTcp, "--tcp");
        if (!tcp)
            return tcp.error();
        options.tcp = *tcp;
    }
    if (arguments.given("control")) {
        const auto control = parseAddress(arguments.text("control"), "--control");
        if (!control)
            return control.error();
        options.control = *control;
    }
    if (arguments.given("announce") && !options.tcp)
        return usage("--announce without a TCP port", "Give --tcp HOST:PORT too");
    if (arguments.given("announce"))
        options.announce_port = static_cast<quint16>(*arguments.whole("announce-port"));
    return Done{};
}

}  // namespace

const std::vector<batch::Option>& optionTable() {
    return table();
}

std::string controlHelp() {
    return "  unplug BOARD, plug BOARD, swap A B, slip BOARD DEGREES, drop-bytes RATE, flip-bits RATE,\n"
           "  stall SECONDS, cut SECONDS, battery PERCENT, temperature C, quit; pose rest|t|sit (rig rest),\n"
           "  side SIDE (rig level), spin SIDE RPM (rig turntable, 0 stops it), placement N (rig jig),\n"
           "  roll SECONDS, height METRES (rig bag).\n"
           "BOARD is an id such as l_forearm or a number from 1, RATE a share from 0 to 1,\n"
           "SIDE the boards' axis that points up: +x, -x, +y, -y, +z or -z.\n";
}

Result<Options> parseOptions(const std::vector<std::string>& words) {
    auto arguments = batch::Arguments::parse(words, table());
    if (!arguments)
        return arguments.error();
    if (Status right = checkSource(*arguments); !right)
        return right.error();
    Options options{std::move(*arguments)};
    if (Status right = addAddresses(options); !right)
        return right.error();
    return options;
}

std::string helpText() {
    return "noctule-virtual-suit: a driver box without hardware, for studios that have none at hand.\n\n"
           "usage: noctule-virtual-suit --motion M.bvh | --rig RIG | --cast CAST.json | --take T.noctule "
           "[OPTIONS]\n\n"
           "options:\n" +
           batch::optionList(table()) +
           "\nIt prints the addresses that `noctule --batch record --device` takes, then serves one studio "
           "at\n"
           "a time until Ctrl-C. The control port takes one command a line and answers ok or error:\n" +
           controlHelp() + "\n" + batch::exitCodeLine(batch::standInExitCodes()) + "\nexample: " + kExample +
           "\n";
}

}  // namespace noctule::virtual_suit
