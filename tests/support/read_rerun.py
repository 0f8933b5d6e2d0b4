"""Rerun recordings read back with the reader of its library."""

from pathlib import Path
from typing import Any

__all__ = ["TIME", "Rows", "read_rerun"]

TIME = "message_log_time"
"""The column of times: nanoseconds, or ``None`` for what is always seen."""

Rows = dict[str, list[dict[str, Any]]]


def read_rerun(file: Path) -> Rows:
    """Return the rows of each entity with its components by their names, in the order of their times."""
    from rerun.chunk import RrdReader

    found: Rows = {}
    for chunk in RrdReader(file).stream().to_chunks():
        batch = chunk.to_record_batch()
        columns = {name: _plain(batch.column(name)) for name in batch.schema.names}
        for number in range(chunk.num_rows):
            row = {name: values[number] for name, values in columns.items() if values[number] is not None}
            found.setdefault(chunk.entity_path, []).append({TIME: None, **row})
    for rows in found.values():
        rows.sort(key=lambda row: -1 if row[TIME] is None else row[TIME])
    return found


def _plain(column: Any) -> list[Any]:
    """Return the values of a column, times as nanoseconds."""
    import pyarrow as pa

    if pa.types.is_duration(column.type) or pa.types.is_timestamp(column.type):
        column = column.cast(pa.int64())
    values: list[Any] = column.to_pylist()
    return values
