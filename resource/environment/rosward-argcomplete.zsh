# SPDX-License-Identifier: Apache-2.0
# Completion of rosward's options, where argcomplete is installed: zsh runs the script for bash.
(( ${+_comps} )) || { autoload -U +X compinit && compinit }
autoload -U +X bashcompinit && bashcompinit
source "${0:a:h}/rosward-argcomplete.bash"
