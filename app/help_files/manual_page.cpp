// SPDX-License-Identifier: Apache-2.0
#include "app/help_files/manual_page.h"

#include "app/batch/help.h"
#include "app/batch/version.h"
#include "app/virtual_robot/control_line.h"
#include "app/virtual_robot/options.h"
#include "app/virtual_suit/options.h"

namespace noctule::help_files {
namespace {

using batch::Option;

/// Text as roff takes it literally: no character is a request.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool begins_line = out.empty() || out.back() == '\n';
        if (begins_line && (c == '.' || c == '\''))
            out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

std::string heading(const std::string& name) {
    return ".SH " + name + "\n";
}

std::string titleLine(const std::string& program) {
    return ".TH " + program + " 1 \"\" \"Noctule " + escaped(batch::softwareVersion()) + "\" \"Noctule\"\n";
}

std::string entry(const Option& option) {
    std::string text = ".TP\n.B " + escaped("--" + option.name);
    if (!option.placeholder.empty())
        text += "\\fR \\fI" + escaped(option.placeholder) + "\\fR";
    text += "\n" + escaped(option.help);
    if (option.required)
        text += " (required)";
    if (!option.fallback.empty())
        text += " (default " + escaped(option.fallback) + ")";
    return text + "\n";
}

std::string entries(const std::vector<Option>& options) {
    std::string text;
    for (const Option& option : options)
        text += entry(option);
    return text;
}

std::string literal(const std::string& text) {
    return ".PP\n.nf\n.RS\n" + escaped(text) + "\n.RE\n.fi\n";
}

std::string verbSection(const batch::Verb& verb) {
    std::string text = ".SS " + escaped(verb.name) + "\n" + escaped(verb.summary) + ".\n";
    text += literal("noctule --batch " + verb.name + (verb.operands.empty() ? "" : " " + verb.operands) +
                    " [OPTIONS]");
    text += entries(verb.options);
    for (const std::string& remark : verb.remarks)
        text += ".PP\n" + escaped(remark) + "\n";
    return text + ".PP\nExample:\n" + literal(verb.example);
}

std::string exitStatus(const std::vector<batch::ExitCode>& codes) {
    std::string text = heading("EXIT STATUS");
    for (const batch::ExitCode& code : codes)
        text += ".TP\n.B " + std::to_string(code.code) + "\n" + escaped(code.meaning) + "\n";
    return text;
}

}  // namespace

std::string noctuleManual() {
    std::string text = titleLine("NOCTULE");
    text += heading("NAME") + "noctule \\- motion capture with gyroscopes, accelerometers and ultrasound\n";
    text += heading("SYNOPSIS") +
            ".B noctule\n[\\fISESSION\\fR|\\fITAKE\\fR]\n.br\n"
            ".B noctule \\-\\-batch\n\\fIVERB\\fR [\\fIARGUMENTS\\fR]\n.br\n"
            ".B noctule \\-\\-help\n|\n.B \\-\\-version\n";
    text +=
        heading("DESCRIPTION") +
        "Without \\fB\\-\\-batch\\fR the studio opens; it needs a display. It opens a session (its folder "
        "or\n"
        "its session.json) or a take.\n.PP\n"
        "With \\fB\\-\\-batch\\fR one job runs without a display and ends. Results go to standard output,\n"
        "messages to standard error. Every output is written aside and renamed when it is complete.\n";
    text += heading("OPTIONS AFTER EVERY VERB") + entries(batch::commonOptions());
    text += heading("VERBS");
    for (const batch::Verb& verb : batch::verbs())
        if (verb.run)
            text += verbSection(verb);
    text += exitStatus(batch::exitCodes());
    text +=
        heading("ENVIRONMENT") +
        ".TP\n.B NOCTULE_QT_DEBUG\nWith any value the studio shows Qt's own warnings on standard error.\n";
    text += heading("SEE ALSO") + ".BR noctule\\-virtual\\-suit (1),\n.BR noctule\\-virtual\\-robot (1)\n";
    return text;
}

std::string virtualSuitManual() {
    std::string text = titleLine("NOCTULE-VIRTUAL-SUIT");
    text += heading("NAME") + "noctule\\-virtual\\-suit \\- a driver box without hardware\n";
    text += heading("SYNOPSIS") +
            ".B noctule\\-virtual\\-suit\n\\-\\-motion \\fIM.bvh\\fR | \\-\\-rig \\fIRIG\\fR | \\-\\-take "
            "\\fIT.noctule\\fR [\\fIOPTIONS\\fR]\n";
    text += heading("DESCRIPTION") +
            "It behaves as the driver box of a suit: it streams a simulated suit, or a take made before, to\n"
            "one studio at a time. It prints the addresses that the studio and\n"
            ".B noctule \\-\\-batch record \\-\\-device\ntake, one a line, and serves until it is ended.\n";
    text += heading("OPTIONS") + entries(virtual_suit::optionTable());
    text += heading("CONTROL PORT") +
            "With \\fB\\-\\-control\\fR it takes one command a line and answers ok or error.\n" +
            literal(virtual_suit::controlHelp());
    text += exitStatus(batch::standInExitCodes());
    text += heading("EXAMPLE") + literal(virtual_suit::kExample);
    text += heading("SEE ALSO") + ".BR noctule (1)\n";
    return text;
}

std::string virtualRobotManual() {
    std::string text = titleLine("NOCTULE-VIRTUAL-ROBOT");
    text += heading("NAME") + "noctule\\-virtual\\-robot \\- a robot without hardware\n";
    text += heading("SYNOPSIS") +
            ".B noctule\\-virtual\\-robot\n\\-\\-robot \\fIR.urdf\\fR \\-\\-udp \\fIHOST:PORT\\fR | "
            "\\-\\-rosbridge \\fIHOST:PORT\\fR [\\fIOPTIONS\\fR]\n";
    text += heading("DESCRIPTION") +
            "It behaves as the arms of a robot: it hears commands over UDP or as a rosbridge server, follows "
            "them\nwithin its own limits, and tells its state. It prints the addresses that\n"
            ".B noctule \\-\\-batch drive \\-\\-to\nand the studio take, one a line, and serves until it is "
            "ended.\n";
    text += heading("OPTIONS") + entries(virtual_robot::optionTable());
    text += heading("CONTROL PORT") +
            "With \\fB\\-\\-control\\fR it takes one command a line and answers ok or error.\n" +
            literal(virtual_robot::controlHelp());
    text += exitStatus(batch::standInExitCodes());
    text += heading("EXAMPLE") + literal(virtual_robot::kExample);
    text += heading("SEE ALSO") + ".BR noctule (1)\n";
    return text;
}

}  // namespace noctule::help_files
