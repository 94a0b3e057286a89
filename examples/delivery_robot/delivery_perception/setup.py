# SPDX-License-Identifier: Apache-2.0
from setuptools import setup

package_name = 'delivery_perception'

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
    description='Lidar, camera and dock detection of the delivery robot.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'camera = delivery_perception.camera:main',
            'dock_detector = delivery_perception.dock_detector:main',
            'lidar_filter = delivery_perception.lidar_filter:main',
        ],
    },
)
