# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact rods: closed forms with their sources, and a strong-form solver for the general case.

Shared by tests and benchmarks; it shares nothing with ``transcription`` and ``solve``.
"""
