# SPDX-License-Identifier: Apache-2.0
"""pydantic_settings: models whose fields the environment may give.

Read from pydantic-settings 2.16.
"""
from pydantic import BaseSettings as BaseSettings

class SettingsConfigDict(dict): ...
