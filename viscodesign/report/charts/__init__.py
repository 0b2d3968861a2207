"""One picture a file."""

import viscodesign.report.layout as _matplotlib_first  # noqa: F401
