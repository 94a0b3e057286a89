# SPDX-License-Identifier: Apache-2.0
from setuptools import setup

package_name = 'delivery_fleet'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='rosward',
    maintainer_email='rosward@example.org',
    description='The building side: orders, doors and monitoring of the delivery robots.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'door_gateway = delivery_fleet.door_gateway:main',
            'fleet_gateway = delivery_fleet.fleet_gateway:main',
            'monitor = delivery_fleet.monitor:main',
        ],
    },
)
