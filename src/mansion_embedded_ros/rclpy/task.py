"""Futures, and tasks that run a callback or a coroutine in an executor."""

from __future__ import annotations

import inspect
import sys
import threading
import warnings
import weakref
from collections.abc import Callable, Generator
from typing import Any

__all__ = ["Future", "Task"]


def _fake_weakref() -> None:
    """Stand in for the weak reference to an executor where there is none."""
    return


class Future:
    """A result that is there later. An executor runs its callbacks, if it has one."""

    def __init__(self, *, executor=None):  # type: ignore[no-untyped-def]
        self._done = False
        self._cancelled = False
        self._result: Any = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Future], Any]] = []
        self._lock = threading.Lock()
        self._executor: Callable[[], Any] = _fake_weakref
        self._set_executor(executor)

    def __del__(self) -> None:
        if self._exception is not None and not self._exception_fetched:
            print(
                "The following exception was never retrieved: " + str(self._exception),
                file=sys.stderr,
            )

    def __await__(self) -> Generator[Any, None, Any]:
        # Yield the future itself: the task that awaits it is resumed when it is done.
        while not self._done:
            yield self
        return self.result()

    def cancel(self):  # type: ignore[no-untyped-def]
        """Request cancellation of the running task if it is not done already."""
        with self._lock:
            if self._done:
                return
            self._cancelled = True
            self._done = True
        self._invoke_callbacks()

    def cancelled(self):  # type: ignore[no-untyped-def]
        """Whether the task was cancelled."""
        return self._cancelled

    def done(self):  # type: ignore[no-untyped-def]
        """Whether there is a result, an exception or a cancellation."""
        return self._done

    def result(self):  # type: ignore[no-untyped-def]
        """The result (None before there is one); raises the exception if there is one."""
        if self._exception is not None:
            raise self.exception()
        return self._result

    def exception(self):  # type: ignore[no-untyped-def]
        """The exception, None if there is none."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result):  # type: ignore[no-untyped-def]
        """Set the result and schedule the callbacks."""
        with self._lock:
            self._result = result
            self._done = True
            self._cancelled = False
        self._invoke_callbacks()

    def set_exception(self, exception):  # type: ignore[no-untyped-def]
        """Set the exception and schedule the callbacks."""
        with self._lock:
            self._exception = exception
            self._exception_fetched = False
            self._done = True
            self._cancelled = False
        self._invoke_callbacks()

    def add_done_callback(self, callback):  # type: ignore[no-untyped-def]
        """Have ``callback(future)`` called when the future is done; at once if it is."""
        with self._lock:
            if not self._done:
                self._callbacks.append(callback)
                return
        self._invoke(callback)

    def remove_done_callback(self, callback: Callable[[Future], Any]) -> bool:
        """Take a callback back; whether it was there."""
        with self._lock:
            if callback in self._callbacks:
                self._callbacks.remove(callback)
                return True
        return False

    def _set_executor(self, executor: Any) -> None:
        self._executor = _fake_weakref if executor is None else weakref.ref(executor)

    def _invoke_callbacks(self) -> None:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            self._invoke(callback)

    def _invoke(self, callback: Callable[[Future], Any]) -> None:
        executor = self._executor()
        if executor is not None and not getattr(callback, "_runs_anywhere", False):
            executor.create_task(callback, self)
            return
        try:
            callback(self)
        except Exception as problem:
            warnings.warn(
                f"Unhandled exception in done callback: {problem}", RuntimeWarning, stacklevel=2
            )


class Task(Future):
    """Execute a function or coroutine; as a future it holds the result."""

    def __init__(self, handler, args=None, kwargs=None, executor=None):  # type: ignore[no-untyped-def]
        super().__init__(executor=executor)
        self._args = [] if args is None else args
        self._kwargs = {} if kwargs is None else kwargs
        if inspect.iscoroutinefunction(handler):
            self._handler: Any = handler(*self._args, **self._kwargs)
            self._args = self._kwargs = None
        else:
            self._handler = handler
        self._coroutine = inspect.iscoroutine(self._handler)
        self._executing = False
        self._task_lock = threading.Lock()

    def __call__(self) -> None:
        """Run or resume; what another thread is running is left alone."""
        if self._done or not self._task_lock.acquire(blocking=False):
            return
        try:
            if self._done:
                return
            self._executing = True
            if self._coroutine:
                self._step()
            else:
                try:
                    self.set_result(self._handler(*self._args, **self._kwargs))
                except Exception as problem:
                    self.set_exception(problem)
                self._complete()
        finally:
            self._executing = False
            self._task_lock.release()
        self._resume_later()

    def _step(self) -> None:
        self._awaited: Any = None
        try:
            self._awaited = self._handler.send(None)
        except StopIteration as end:
            self.set_result(end.value)
            self._complete()
        except Exception as problem:
            self.set_exception(problem)
            self._complete()

    def _resume_later(self) -> None:
        """Queue the task again once what it waits for is there."""
        executor = self._executor()
        if self._done or executor is None:
            return
        if isinstance(self._awaited, Future):
            ref = weakref.ref(executor)

            def resume(_: Future) -> None:
                target = ref()
                if target is not None:
                    target._queue_task(self)

            resume._runs_anywhere = True  # type: ignore[attr-defined]
            self._awaited.add_done_callback(resume)
        else:
            executor._queue_task(self)

    def _complete(self) -> None:
        self._handler = None
        self._args = self._kwargs = None

    def executing(self):  # type: ignore[no-untyped-def]
        """Whether a thread is running it now."""
        return self._executing
