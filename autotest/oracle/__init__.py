# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Independent oracles for quantized-mesh terrain: written from the format's specification and the
definitions in docs/, with numpy alone, and sharing no code with the product they judge."""
