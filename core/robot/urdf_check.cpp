// SPDX-License-Identifier: Apache-2.0
#include "core/robot/urdf_check.h"

#include <tinyxml.h>

#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/robot/robot_model.h"

namespace noctule::robot {
namespace {

/// A URDF needs 6; TinyXML calls itself for each.
constexpr int kDeepestElement = 40;

Error unreadable(const std::string& where, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnreadable, where + ": " + what, remedy};
}

bool isShallowXml(std::string_view text) {
    int depth = 0;
    for (size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != '<')
            continue;
        const char next = text[i + 1];
        const size_t end = text.find('>', i);
        if (next == '!' || next == '?')
            continue;
        if (next == '/')
            --depth;
        else if (end == std::string_view::npos || text[end - 1] != '/')
            ++depth;
        if (depth > kDeepestElement)
            return false;
    }
    return true;
}

std::string attribute(const TiXmlElement& element, const char* name) {
    const char* value = element.Attribute(name);
    return value ? value : "";
}

std::string inMarks(const std::string& name) {
    return "\"" + visibleText(shortText(name, 100)) + "\"";
}

/// A finite number and nothing else.
bool isNumber(const std::string& text, double& value) {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    return stream >> value && (stream >> std::ws).eof() && std::isfinite(value);
}

/// Names of all elements of a kind directly below the robot, each once.
Result<std::set<std::string>> names(const TiXmlElement& robot, const char* kind, const std::string& where) {
    std::set<std::string> found;
    for (auto* e = robot.FirstChildElement(kind); e; e = e->NextSiblingElement(kind)) {
        const std::string name = attribute(*e, "name");
        if (name.empty())
            return unreadable(where, std::string("a ") + kind + " has no name", "Give every part a name");
        if (name.size() > limits::kName)
            return unreadable(where, std::string("the name of a ") + kind + " is too long",
                              "Shorten it to 1000 characters");
        if (!found.insert(name).second)
            return unreadable(where, std::string("the ") + kind + " " + inMarks(name) + " stands in it twice",
                              "Rename or remove one of them");
    }
    return found;
}

/// "parent" or "child" of a joint: the link it names.
Result<std::string> linkOf(const TiXmlElement& joint, const char* end, const std::set<std::string>& links,
                           const std::string& where) {
    const TiXmlElement* element = joint.FirstChildElement(end);
    const std::string link = element ? attribute(*element, "link") : "";
    if (links.contains(link))
        return link;
    return unreadable(where,
                      "joint " + inMarks(attribute(joint, "name")) + " names no " + end +
                          " link that is there" + (link.empty() ? "" : " (" + inMarks(link) + ")"),
                      "Correct the joint or add the link");
}

Status checkTree(const TiXmlElement& robot, const std::set<std::string>& links, const std::string& where) {
    std::map<std::string, std::string> parent_of, joint_of;
    for (auto* joint = robot.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
        const auto parent = linkOf(*joint, "parent", links, where);
        const auto child = linkOf(*joint, "child", links, where);
        if (!parent || !child)
            return parent ? child.error() : parent.error();
        const std::string name = attribute(*joint, "name");
        const auto [other, is_new] = joint_of.emplace(*child, name);
        if (!is_new)
            return unreadable(where,
                              "the joints " + inMarks(other->second) + " and " + inMarks(name) +
                                  " both hold link " + inMarks(*child) + ": the robot has a loop",
                              "Open the loop at one of the two; only trees of links can be followed");
        parent_of[*child] = *parent;
    }
    for (const std::string& link : links) {
        std::string at = link;
        for (size_t steps = 0; parent_of.contains(at); at = parent_of[at])
            if (++steps > links.size())
                return unreadable(where,
                                  "link " + inMarks(link) + " hangs below itself: the robot has a loop",
                                  "Open the loop; only trees of links can be followed");
    }
    return Done{};
}

struct LimitDefault {
    const char* name;
    double value;
};

/// A number that is there must be one; one that is missing is written in and said.
Result<double> numberOr(TiXmlElement& limit, const std::string& joint, const LimitDefault& fallback,
                        const std::string& where, std::vector<std::string>& notices) {
    double value = fallback.value;
    const std::string text = attribute(limit, fallback.name);
    if (!text.empty()) {
        if (isNumber(text, value))
            return value;
        return unreadable(where,
                          std::string("the ") + fallback.name + " limit of joint " + inMarks(joint) +
                              " is no finite number (" + inMarks(text) + ")",
                          "Write the limit from the robot's data sheet");
    }
    std::ostringstream number;
    number.imbue(std::locale::classic());
    number << fallback.value;
    limit.SetAttribute(fallback.name, number.str().c_str());
    if (std::string_view(fallback.name) != "effort")
        notices.push_back("joint " + inMarks(joint) + " states no " + fallback.name + " limit, " +
                          number.str() + " is assumed");
    return value;
}

Status completeLimits(TiXmlElement& joint, const std::string& where, std::vector<std::string>& notices) {
    const std::string type = attribute(joint, "type"), name = attribute(joint, "name");
    if (type != "revolute" && type != "prismatic" && type != "continuous")
        return Done{};
    TiXmlElement* limit = joint.FirstChildElement("limit");
    if (!limit)
        limit = joint.InsertEndChild(TiXmlElement("limit"))->ToElement();
    const double range = type == "prismatic" ? kAssumedRange_m : kAssumedRange_rad;
    const auto speed = numberOr(*limit, name, {"velocity", kAssumedSpeed_rad_per_s}, where, notices);
    const auto effort = numberOr(*limit, name, {"effort", 0}, where, notices);
    if (!speed || !effort)
        return speed ? effort.error() : speed.error();
    if (*speed <= 0)
        return unreadable(where, "the velocity limit of joint " + inMarks(name) + " is not above 0",
                          "Write the limit from the robot's data sheet");
    if (type == "continuous")
        return Done{};
    const auto lower = numberOr(*limit, name, {"lower", -range}, where, notices);
    const auto upper = numberOr(*limit, name, {"upper", range}, where, notices);
    if (!lower || !upper)
        return lower ? upper.error() : lower.error();
    if (*lower > *upper)
        return unreadable(where, "the lower limit of joint " + inMarks(name) + " is above its upper limit",
                          "Exchange the two");
    return Done{};
}

}  // namespace

Result<std::string> checkedUrdf(std::string_view text, const std::string& where,
                                std::vector<std::string>& notices) {
    if (text.find('\0') != std::string_view::npos || !isShallowXml(text))
        return unreadable(where, "is no URDF", "Choose the robot's .urdf file");
    TiXmlDocument document;
    document.Parse(std::string(text).c_str(), nullptr, TIXML_ENCODING_UTF8);
    TiXmlElement* robot = document.RootElement();
    if (document.Error() || !robot || robot->ValueStr() != "robot")
        return unreadable(where, "is no URDF", "Choose the robot's .urdf file");
    if (text.find("<xacro:") != std::string_view::npos)
        return unreadable(where, "is a xacro file, from which a URDF has yet to be made",
                          "Run `xacro FILE -o robot.urdf` and choose the result");
    const auto links = names(*robot, "link", where);
    const auto joints = names(*robot, "joint", where);
    if (!links || !joints)
        return links ? joints.error() : links.error();
    if (Status tree = checkTree(*robot, *links, where); !tree)
        return tree.error();
    for (auto* joint = robot->FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint"))
        if (Status complete = completeLimits(*joint, where, notices); !complete)
            return complete.error();
    TiXmlPrinter printer;
    document.Accept(&printer);
    return std::string(printer.CStr());
}

}  // namespace noctule::robot
