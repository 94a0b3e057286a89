# SPDX-License-Identifier: Apache-2.0
"""launch_xml.launch_description_sources.xml_launch_description_source."""

from launch_xml.launch_description_sources import XMLLaunchDescriptionSource as XMLLaunchDescriptionSource
