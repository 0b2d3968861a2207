"""Results that show themselves in a notebook."""

from __future__ import annotations

from viscodesign.lazy_names import module_above


class NotebookView:
    """A study that a notebook shows by its main numbers and its picture."""

    def _repr_html_(self) -> str:
        """What a notebook shows of it; `report.notebook_studies` says what that is."""
        shown: str = module_above("report.notebook_studies").study_html(self)
        return shown
