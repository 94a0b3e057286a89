# SPDX-License-Identifier: Apache-2.0
"""Many repositories, one result set: `rosward survey`.

    repositories ── one task each ──▶ executor ──▶ a process of its own ──▶ part ── all parts, in order ──▶ tables, overview

Nothing here analyses but the process behind `one`; who runs the tasks, and where, makes no difference to the tables.
"""
