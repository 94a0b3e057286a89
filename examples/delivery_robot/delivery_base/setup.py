# SPDX-License-Identifier: Apache-2.0
from setuptools import setup

package_name = 'delivery_base'

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
    description='Drive, battery and manual control of the delivery robot.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'base_driver = delivery_base.base_driver:main',
            'battery_monitor = delivery_base.battery_monitor:main',
            'teleop_mux = delivery_base.teleop_mux:main',
        ],
    },
)
