# SPDX-License-Identifier: Apache-2.0
from glob import glob

from setuptools import setup

package_name = 'delivery_bringup'

setup(
    name=package_name,
    version='0.1.0',
    packages=[],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', glob('launch/*.launch.*')),
        ('share/' + package_name + '/config', glob('config/*.yaml')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='rosward',
    maintainer_email='rosward@example.org',
    description='Starts one delivery robot, or the fleet and the building.',
    license='Apache-2.0',
)
