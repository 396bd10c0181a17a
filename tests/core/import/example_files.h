// SPDX-License-Identifier: Apache-2.0
// Small recordings in the formats of other programs, byte by byte after their specifications: what is read
// here was not written by what is tested.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/import/import_format.h"

namespace noctule::test {

inline Result<ImportedRecording> readAs(const std::vector<ImportFile>& files,
                                        const ImportChoice& choice = {}) {
    const ImportFormat* format = importFormatOf(files);
    EXPECT_TRUE(format);
    return format ? readImport(*format, files, choice, {}) : Error{};
}

inline bool mentions(const std::vector<std::string>& sentences, const std::string& word) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

inline std::string numberText(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6f", value);
    return text;
}

/// MT Manager 2022: `counts` are the packet counters; gravity along z, a turn of `rate` about x.
inline std::string xsensExample(const std::vector<int>& counts, char separator, bool header_rate,
                                const std::string& end = "\n", const std::string& device = "00B42D4B") {
    std::string text = "// General information: " + end + "//  DeviceId: " + device + end;
    if (header_rate)
        text += "// Update Rate: 100.0Hz" + end;
    text += "// Coordinate system: ENU" + end;
    std::string names =
        "PacketCounter,SampleTimeFine,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z,Mag_X,Mag_Y,Mag_Z,Quat_"
        "q0,Quat_q1,Quat_q2,Quat_q3";
    for (char& c : names)
        c = c == ',' ? separator : c;
    text += names + end;
    for (size_t i = 0; i < counts.size(); ++i) {
        char count[16];
        std::snprintf(count, sizeof count, "%05d", counts[i]);
        text += count;
        for (const double value :
             {double(i) * 100, 0.1, 0.2, 9.81, 0.01 * double(i), -0.5, 0.25, 0.5, 0.0, -0.9})
            text += separator + numberText(value);
        for (const double value : {0.8, 0.6, 0.0, 0.0})
            text += separator + numberText(value);
        text += end;
    }
    return text;
}

inline std::string stoExample() {
    std::string text =
        "\nDataRate=100.000000\nDataType=Quaternion\nversion=3\nOpenSimVersion=4.1\nendheader\n"
        "time\tpelvis_imu\tfemur_r_imu\n";
    for (int i = 0; i < 50; ++i)
        text += numberText(3 + 0.01 * i) + "\t0.8,0.6,0,0\t1,0,0,0\n";
    return text;
}

/// A pelvis with two legs, each child 0.5 m below; the body turns by 0.01 rad a frame about z.
inline std::string mvnxExample(int frames = 20) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mvnx version=\"4\" "
        "xmlns=\"http://www.xsens.com/mvn/mvnx\">\n"
        "<mvn version=\"2022.0\"/>\n<subject label=\"A\" frameRate=\"60\" segmentCount=\"3\">\n<segments>"
        "<segment label=\"Pelvis\" id=\"1\"/><segment label=\"RightUpperLeg\" id=\"2\"/>"
        "<segment label=\"LeftUpperLeg\" id=\"3\"/></segments>\n<sensors><sensor label=\"Pelvis\"/>"
        "<sensor label=\"RightUpperLeg\"/></sensors>\n<joints><joint label=\"jRightHip\"><connector1>"
        "Pelvis/jRightHip</connector1><connector2>RightUpperLeg/jRightHip</connector2></joint>"
        "<joint label=\"jLeftHip\"><connector1>Pelvis/jLeftHip</connector1>"
        "<connector2>LeftUpperLeg/jLeftHip</connector2></joint></joints>\n<frames segmentCount=\"3\" "
        "sensorCount=\"2\" jointCount=\"2\">\n<frame time=\"0\" type=\"identity\"><orientation>1 0 0 0 1 0 0 "
        "0 1 "
        "0 0 0</orientation><position>0 0 1 0 -0.1 0.9 0 0.1 0.9</position></frame>\n";
    for (int i = 0; i < frames; ++i) {
        const double w = std::cos(0.005 * i), z = std::sin(0.005 * i);
        const std::string q = numberText(w) + " 0 0 " + numberText(z) + " ";
        const double c = std::cos(0.01 * i), s = std::sin(0.01 * i);
        text += "<frame time=\"" + std::to_string(i * 1000 / 60) + "\" index=\"" + std::to_string(i) +
                "\" type=\"normal\"><orientation>" + q + q + q + "</orientation><position>1 2 1 " +
                numberText(1 + 0.1 * s) + " " + numberText(2 - 0.1 * c) + " 0.9 " + numberText(1 - 0.1 * s) +
                " " + numberText(2 + 0.1 * c) +
                " 0.9</position><sensorFreeAcceleration>0 0 0 0 0 1</sensorFreeAcceleration>"
                "<sensorMagneticField>0.5 0 -0.8 0.5 0 -0.8</sensorMagneticField><sensorOrientation>" +
                q + q + "</sensorOrientation><jointAngle>0 0 0 0 0 0</jointAngle></frame>\n";
    }
    return text + "</frames></subject></mvnx>\n";
}

inline std::string ximu3Csv(int rows = 40) {
    std::string text =
        "Timestamp (us),Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s),"
        "Accelerometer X (g),Accelerometer Y (g),Accelerometer Z (g)\n";
    for (int i = 0; i < rows; ++i)
        text += std::to_string(1000000 + 2500 * i) + ",90.000000," + numberText(i) +
                ",0.000000,0.000000,0.000000,1.000000\n";
    return text;
}

template <class T>
std::string littleEndianBytes(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline std::string ximu3Message(char letter, uint64_t time_us, const std::vector<float>& values) {
    std::string plain = littleEndianBytes(time_us);
    for (const float value : values)
        plain += littleEndianBytes(value);
    std::string message(1, char(letter | 0x80));
    for (const char c : plain)
        message += c == 0x0A         ? std::string("\xDB\xDC")
                   : c == char(0xDB) ? std::string("\xDB\xDD")
                                     : std::string(1, c);
    return message + '\n';
}

/// With times and values that need stuffing, a text message, a command and a message of another kind.
inline std::string ximu3Binary() {
    std::string bytes = "{\"ping\":null}\r\n";
    for (uint64_t i = 0; i < 40; ++i) {
        bytes += ximu3Message('I', 0x0ADB0A + 2500 * i, {90, float(i), 0, 0, 0, 1});
        if (i % 4 == 0)
            bytes += ximu3Message('M', 0x0ADB0A + 2500 * i, {1, 0, -2});
        bytes += ximu3Message('Q', 0x0ADB0A + 2500 * i, {1, 0, 0, 0});
        bytes += ximu3Message('T', 0x0ADB0A + 2500 * i, {25});
    }
    return bytes + "I," + std::to_string(0x0ADB0A + 2500 * 40) + ",90.0,40.0,0.0,0.0,0.0,1.0\r\n";
}

inline std::string trcExample() {
    std::string text =
        "PathFileType\t4\t(X/Y/Z)\ttrial.trc\r\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\t"
        "OrigDataRate\tOrigDataStartFrame\tOrigNumFrames\r\n100.00\t100.00\t 99\t 2\tmm\t100.00\t1\t"
        "3\r\nFrame#\tTime\tHips\t\t\tLASI\t\t\r\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\r\n\r\n";
    for (int i = 0; i < 3; ++i)
        text += std::to_string(i + 1) + "\t" + numberText(0.01 * i) + "\t" + std::to_string(1000 + i) +
                "\t500\t250\t" + (i == 1 ? "\t\t" : "1\t2\t3") + "\t\r\n";
    return text;
}

/// A C3D file in one processor's numbers: Intel 84, DEC 85, SGI 86.
class C3dExample {
public:
    C3dExample(int processor, bool floats, bool long_frames = false)
        : processor_(processor), floats_(floats), long_frames_(long_frames) {}

    std::string bytes() const {
        std::string header = std::string("\x02\x50", 2) + word(2) + word(0) + word(1) + word(3) + word(0) +
                             real(floats_ ? -0.5f : 0.5f) + word(3) + word(0) + real(200);
        header.resize(512, '\0');
        std::string groups = std::string("\0\0\x01", 3) + char(processor_) + group(-1, "POINT") +
                             parameter("USED", 2, {}, word(2)) +
                             parameter("SCALE", 4, {}, real(floats_ ? -0.5f : 0.5f)) +
                             parameter("RATE", 4, {}, real(200)) + parameter("DATA_START", 2, {}, word(3)) +
                             parameter("FRAMES", 2, {}, word(long_frames_ ? 1 : 3)) +
                             (long_frames_ ? parameter("LONG_FRAMES", 4, {}, real(3)) : "") +
                             parameter("LABELS", -1, {6, 2}, "s:LASIHips  ") +
                             parameter("UNITS", -1, {2}, "mm") + parameter("Y_SCREEN", -1, {2}, "+Z");
        groups.resize(512, '\0');
        std::string data;
        for (int frame = 0; frame < 3; ++frame) {
            data += point(100.f + float(frame), -200, 300, true);
            data += point(10, 20, 30, frame != 1);
        }
        data.resize(512, '\0');
        return header + groups + data;
    }

private:
    std::string word(int value) const {
        std::string bytes{char(value & 255), char(value >> 8 & 255)};
        return processor_ == 86 ? std::string{bytes[1], bytes[0]} : bytes;
    }
    std::string real(float value) const {
        const auto b = littleEndianBytes(processor_ == 85 ? value * 4 : value);
        return processor_ == 84   ? b
               : processor_ == 85 ? std::string{b[2], b[3], b[0], b[1]}
                                  : std::string{b[3], b[2], b[1], b[0]};
    }
    std::string group(int id, const std::string& name) const {
        return std::string{char(name.size()), char(id)} + name + word(3) + '\0';
    }
    std::string parameter(const std::string& name, int type, const std::vector<int>& dimensions,
                          const std::string& data) const {
        std::string sizes(1, char(dimensions.size()));
        for (const int d : dimensions)
            sizes += char(d);
        return std::string{char(-int(name.size())), 1} + name +
               word(int(2 + 1 + sizes.size() + data.size() + 1)) + char(type) + sizes + data + '\0';
    }
    std::string point(float x, float y, float z, bool seen) const {
        if (floats_)
            return real(x) + real(y) + real(z) + real(seen ? 0.f : -1.f);
        return word(int(x / 0.5f)) + word(int(y / 0.5f)) + word(int(z / 0.5f)) + word(seen ? 0 : -1);
    }

    int processor_;
    bool floats_, long_frames_;
};

}  // namespace noctule::test
