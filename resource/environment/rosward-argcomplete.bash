# SPDX-License-Identifier: Apache-2.0
# Completion of rosward's options, where argcomplete is installed.
if command -v register-python-argcomplete >/dev/null 2>&1; then
  eval "$(register-python-argcomplete rosward)"
elif command -v register-python-argcomplete3 >/dev/null 2>&1; then
  eval "$(register-python-argcomplete3 rosward)"
fi
