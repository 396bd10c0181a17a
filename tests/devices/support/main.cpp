// SPDX-License-Identifier: Apache-2.0
// Runs the tests of the rooms of devices that use Qt: one application, as in the programs.
#include <gtest/gtest.h>

#include <QCoreApplication>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
