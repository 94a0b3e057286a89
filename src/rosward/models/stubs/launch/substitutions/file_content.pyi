# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.file_content."""

from launch.substitutions import FileContent as FileContent
