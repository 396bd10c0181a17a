// SPDX-License-Identifier: Apache-2.0
#include <QUrl>

#include "devices/robot/rosbridge_interface.h"
#include "devices/robot/udp_interface.h"

namespace noctule::robot_link {
namespace {

constexpr const char* kRemedy =
    "Give udp://HOST:PORT or rosbridge://HOST:PORT, such as rosbridge://127.0.0.1:9090";

using Made = Result<std::unique_ptr<RobotInterface>>;

Made makeUdp(const QUrl& url, const std::string& address, const LinkOptions& options) {
    return std::unique_ptr<RobotInterface>(
        new UdpInterface(address, url.host(), static_cast<uint16_t>(url.port()), options));
}

Made makeRosbridge(const QUrl& url, const std::string& address, const LinkOptions& options) {
    QUrl socket(url);
    socket.setScheme("ws");
    return std::unique_ptr<RobotInterface>(new RosbridgeInterface(address, socket, options));
}

/// The registry of interfaces.
struct InterfaceKind {
    const char* scheme;
    Made (*make)(const QUrl&, const std::string&, const LinkOptions&);
};
constexpr InterfaceKind kKinds[] = {{"udp", makeUdp}, {"rosbridge", makeRosbridge}, {"ws", makeRosbridge}};

}  // namespace

Result<std::unique_ptr<RobotInterface>> makeInterface(const std::string& address,
                                                      const LinkOptions& options) {
    if (options.joints.empty() || options.joints.size() > kMostJoints)
        return Error{ErrorKind::kUsage,
                     address + ": " + std::to_string(options.joints.size()) + " joints cannot be driven",
                     "Drive 1 to " + std::to_string(kMostJoints) + " joints"};
    const QUrl url(QString::fromStdString(address), QUrl::StrictMode);
    if (!url.isValid() || url.host().isEmpty() || url.port() <= 0)
        return Error{ErrorKind::kUsage, "'" + address + "' is not the address of a robot", kRemedy};
    for (const InterfaceKind& kind : kKinds)
        if (url.scheme() == kind.scheme)
            return kind.make(url, address, options);
    return Error{ErrorKind::kUsage, "'" + address + "': no interface is called " + url.scheme().toStdString(),
                 kRemedy};
}

}  // namespace noctule::robot_link
