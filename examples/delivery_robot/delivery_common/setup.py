# SPDX-License-Identifier: Apache-2.0
from setuptools import setup

package_name = 'delivery_common'

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
    description='What the nodes of the delivery robot share: base classes, QoS profiles, names.',
    license='Apache-2.0',
)
