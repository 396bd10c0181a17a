# SPDX-License-Identifier: Apache-2.0
"""Recordings that are killed, lose their power or their cable, as often and as long as is asked for."""
import built_tests


def figure(options):
    kills = built_tests.run("test_devices_live", "BrokenRecording.KilledAt*:BrokenRecording.WithoutPower*",
                            "all recovered", NOCTULE_KILLS=str(options.kills))
    faults = built_tests.run("test_app_virtual_suit", "FaultsInATake.RecordingGoesOn*", "nothing wrong",
                             NOCTULE_CUT_SECONDS="30")
    return ("18 boards at 150 kHz in real time; every block that was committed is in the recovered take, at most "
            f"400 ms may be missing at its end. Every fault of the control port in one recording.\n\n{kills}{faults}")
