# SPDX-License-Identifier: Apache-2.0
"""Welch 2018, section 4, as numbers: the table over several seeds, figures 3 to 5, and more people."""
import built_tests


def figure(_):
    return ("### Two people, 13 transceivers each, 4 in the room, 2 mm, 100 Hz\n\nAverages over 20 seeds; turn: the "
            "largest. Motions: CMU 18_01 twice and 60_05 with 61_05.\n\n" +
            built_tests.run("test_core_cooperative", "Cast.*", "^cast: ", NOCTULE_CAST_SEEDS="20"))
