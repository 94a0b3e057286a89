# SPDX-License-Identifier: Apache-2.0
"""`xml`: what is modelled of it stands in its modules."""
