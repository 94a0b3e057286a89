# SPDX-License-Identifier: Apache-2.0
"""What has a person said of the findings: which are to be ignored, which were there before?

comments.py      # rosward: ignore[RW102]      ->  where the sources say that a finding is ignored
fingerprints.py  src/talker.py:20 RW102 …      ->  3f2a…, the same after lines were added above
baseline.py      fingerprints in a file        ->  what is not new
judge.py         all of it                     ->  findings shown, ignored, known
"""
