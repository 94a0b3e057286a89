# SPDX-License-Identifier: Apache-2.0
"""Names that more than one package needs."""

ROBOT = 'porter'
BUILDING = 'building'
FLEET = 'fleet'

DOOR_SERVICE = f'/{BUILDING}/doors/open'
SIDES = ('front', 'rear')


def sensor_topic(place, what):
    """Return the topic of a sensor, relative to the namespace of the robot."""
    return '/'.join(('sensors', place, what))
