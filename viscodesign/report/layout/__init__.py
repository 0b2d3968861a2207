"""How pictures are laid out: style, labels, snapshots, thinning."""

from viscodesign.report.layout.drawing_library import import_matplotlib

import_matplotlib()  # before any module that draws names it
